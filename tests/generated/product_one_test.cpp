// One product with SIMD inside: against quadrature with the oracle's basis, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "tests/generated/batch_support.hpp"
#include "tests/message_of.hpp"

namespace sh::test {
namespace {

constexpr int kMostBands = 11;
using Floats = std::vector<float>;
using Doubles = std::vector<double>;
constexpr double kLimit{4 * std::numeric_limits<float>::epsilon()};  // times |a| |b|

double length(const Floats& v) {
  double sum = 0;
  for (const float x : v) sum += static_cast<double>(x) * static_cast<double>(x);
  return std::sqrt(sum);
}

double dot(const Floats& c, const Doubles& y) {
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += static_cast<double>(c[i]) * y[i];
  return sum;
}

// Products by integration over the sphere, exact up to rounding in double.
class Oracle {
 public:
  explicit Oracle(int degree) {
    for (const auto& node : numeric::sphere_rule<double>(3 * degree)) {
      values_.emplace_back(coefficient_count(degree));
      numeric::basis(degree, node.x, node.y, node.z, values_.back().data());
      weights_.push_back(node.weight);
    }
  }
  [[nodiscard]] Doubles product(const Floats& a, const Floats& b) const {
    Doubles result(a.size());
    for (std::size_t p = 0; p < weights_.size(); ++p) {
      const double value = weights_[p] * dot(a, values_[p]) * dot(b, values_[p]);
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += value * values_[p][i];
    }
    return result;
  }

 private:
  std::vector<Doubles> values_;
  Doubles weights_;
};

Floats random_vector(std::size_t size, std::mt19937& random) {
  std::normal_distribution<float> normal;
  Floats v(size);
  for (float& x : v) x = normal(random);
  return v;
}

// Vectors of every kind: random, one coefficient, one band, tiny, large, mixed in size, zero.
std::vector<Floats> vectors(int degree) {
  const std::size_t size = coefficient_count(degree);
  std::mt19937 random(7);
  std::vector<Floats> all(6);
  for (Floats& v : all) v = random_vector(size, random);
  for (std::size_t i = 0; i < size; ++i) {
    all.emplace_back(size, 0.0F);
    all.back()[i] = 1.5F;
  }
  for (int l = 0; l <= degree; ++l) {
    Floats band = random_vector(size, random);
    std::fill_n(band.begin(), coefficient_count(l - 1), 0.0F);
    std::fill(band.begin() + coefficient_count(l), band.end(), 0.0F);
    all.push_back(band);
  }
  for (const float scale : {1e-12F, 1e12F}) {
    all.push_back(random_vector(size, random));
    for (float& x : all.back()) x *= scale;
  }
  all.push_back(random_vector(size, random));
  for (std::size_t i = 0; i < size; ++i) all.back()[i] *= std::ldexp(1.0F, -3 * static_cast<int>(i % 9));
  all.emplace_back(size, 0.0F);
  return all;
}

Floats multiplied(int degree, const Floats& a, const Floats& b) {
  Floats out(a.size());
  batch::product_one(degree, a.data(), b.data(), out.data());
  return out;
}

TEST(ProductOne, StaysWithinFourEpsOfTheLengthsForVectorsOfEveryKind) {
  for (int degree = 0; degree < kMostBands; ++degree) {
    const Oracle oracle(degree);
    const std::vector<Floats> all = vectors(degree);
    // There are no lanes beyond degree 6: fewer pairs will do.
    for (std::size_t i = 0; i < all.size(); i += degree <= 6 ? 1 : 7) {
      for (std::size_t j = 0; j < all.size(); j += degree <= 6 ? 1 + j % 3 : 11) {
        const Doubles wanted = oracle.product(all[i], all[j]);
        const double limit = kLimit * length(all[i]) * length(all[j]);
        on_every_set([&] {
          const Floats out = multiplied(degree, all[i], all[j]);
          for (std::size_t k = 0; k < out.size(); ++k) {
            ASSERT_NEAR(static_cast<double>(out[k]), wanted[k], limit) << degree << ": " << i << " " << j << " " << k;
          }
        });
      }
    }
  }
}

TEST(ProductOne, UnderflowsNoEarlierThanTheLargestTerm) {
  std::mt19937 random(3);
  for (int degree = 0; degree < kMostBands; ++degree) {
    const Oracle oracle(degree);
    for (const float scale : {1e-15F, 1e-20F, 1e-30F, 1e-40F}) {
      Floats a = random_vector(coefficient_count(degree), random);
      const Floats b = random_vector(coefficient_count(degree), random);
      for (float& x : a) x *= scale;
      const Doubles wanted = oracle.product(a, b);
      // A few hundred terms, each off by half of the least positive number.
      const double limit =
          kLimit * length(a) * length(b) + 500 * static_cast<double>(std::numeric_limits<float>::denorm_min());
      on_every_set([&] {
        const Floats out = multiplied(degree, a, b);
        for (std::size_t k = 0; k < out.size(); ++k) {
          ASSERT_NEAR(static_cast<double>(out[k]), wanted[k], limit) << degree << " " << scale << " " << k;
        }
      });
    }
  }
}

TEST(ProductOne, GivesTheSameBitsInPlaceAndAtAnyAlignmentAndWritesNothingElse) {
  std::mt19937 random(11);
  for (int degree = 0; degree < kMostBands; ++degree) {
    const std::size_t size = coefficient_count(degree);
    const Floats a = random_vector(size, random);
    const Floats b = random_vector(size, random);
    on_every_set([&] {
      const Floats expected = multiplied(degree, a, b);
      Floats over_a = a;
      batch::product_one(degree, over_a.data(), b.data(), over_a.data());
      EXPECT_EQ(over_a, expected) << degree;
      Floats over_b = b;
      batch::product_one(degree, a.data(), over_b.data(), over_b.data());
      EXPECT_EQ(over_b, expected) << degree;
      const Floats square = multiplied(degree, a, a);
      Floats over_both = a;
      batch::product_one(degree, over_both.data(), over_both.data(), over_both.data());
      EXPECT_EQ(over_both, square) << degree;
      for (std::size_t offset = 1; offset < 16; offset += 5) {
        Array<float> in_a({Layout::kPlain, offset}, {a}, size);
        Array<float> in_b({Layout::kPlain, offset + 1}, {b}, size);
        Array<float> out({Layout::kPlain, offset + 2}, 1, size);
        batch::product_one(degree, in_a.records().data, in_b.records().data, out.records().data);
        EXPECT_EQ(out.read()[0], expected) << degree << " " << offset;
        EXPECT_TRUE(out.guarded()) << degree << " " << offset;
      }
    });
  }
}

TEST(ProductOne, CarriesWhatIsNotANumberToTheConstantOrBeyond) {
  for (int degree = 0; degree < kMostBands; ++degree) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      const Floats ones(coefficient_count(degree), 1.0F);
      for (std::size_t i = 0; i < ones.size(); ++i) {
        Floats a = ones;
        a[i] = value;
        on_every_set([&] { EXPECT_FALSE(std::isfinite(multiplied(degree, a, ones)[0])) << degree << " " << i; });
      }
    }
  }
}

TEST(ProductOne, RefusesDegreesItHasNoKernelFor) {
  Floats v(400);
  for (const int degree : {-1, 11}) {
    EXPECT_EQ(message_of([&] { batch::product_one(degree, v.data(), v.data(), v.data()); }),
              "sh::batch::product_one: expected a degree of 0 to 10, got " + std::to_string(degree));
  }
}

}  // namespace
}  // namespace sh::test
