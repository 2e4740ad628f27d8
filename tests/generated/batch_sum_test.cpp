// Drivers that are more than a kernel per record: sums over all records, and coefficients in half precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "generated/batch/batch.hpp"
#include "generated/cpp/project.hpp"
#include "tests/generated/batch_support.hpp"

namespace sh::test {
namespace {

template <class T>
class BatchSums : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchSums, Scalars);

template <class T>
struct Samples {
  std::vector<std::vector<T>> directions;
  std::vector<std::vector<T>> weights;
};

template <class T>
Samples<T> random_samples(std::size_t n) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Samples<T> samples;
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, 3> v{normal(random), normal(random), normal(random)};
    const double length = std::hypot(v[0], v[1], v[2]);
    samples.directions.push_back(
        {static_cast<T>(v[0] / length), static_cast<T>(v[1] / length), static_cast<T>(v[2] / length)});
    samples.weights.push_back({static_cast<T>(normal(random) / static_cast<double>(n))});
  }
  return samples;
}

// Sums kernel by kernel in double, added up in more.
template <class T>
std::vector<double> expected_sum(int degree, const Samples<T>& samples) {
  std::vector<long double> sum(coefficient_count(degree), 1.0L);
  for (std::size_t i = 0; i < samples.weights.size(); ++i) {
    const auto& d = samples.directions[i];
    std::vector<double> one(sum.size(), 0.0);
    with_degree<10>(degree, [&]<int kDegree>() {
      project<kDegree>(static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2]),
                       static_cast<double>(samples.weights[i][0]), one.data());
    });
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += static_cast<long double>(one[k]);
  }
  return {sum.begin(), sum.end()};
}

template <class T>
std::vector<T> run_sum(int degree, const Samples<T>& samples, Place directions_place, Place weights_place) {
  const std::size_t n = samples.weights.size();
  const Array<T> directions(directions_place, samples.directions, 3);
  const Array<T> weights(weights_place, samples.weights, 1);
  std::vector<T> sum(coefficient_count(degree) + 2, T(1));
  batch::project(degree, n, directions.records(), weights.records(), sum.data() + 1);
  EXPECT_EQ(sum.front(), T(1));
  EXPECT_EQ(sum.back(), T(1));
  return {sum.begin() + 1, sum.end() - 1};
}

TYPED_TEST(BatchSums, AddToWhatIsThereForEveryLengthAndTheSameBitsInEveryLayout) {
  using T = TypeParam;
  constexpr std::size_t kBlock = batch::kBlock<T>;
  constexpr double epsilon{std::numeric_limits<T>::epsilon()};
  for (int degree = 0; degree <= 10; ++degree) {
    for (const std::size_t n :
         {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4}, std::size_t{5},
          std::size_t{7}, std::size_t{8}, std::size_t{9}, std::size_t{12}, std::size_t{13}, kBlock, kBlock + 1,
          std::size_t{24}, std::size_t{25}, 64 * kBlock, 64 * kBlock + 3, std::size_t{5000}}) {
      const Samples<T> samples = random_samples<T>(n);
      const std::vector<double> expected = expected_sum(degree, samples);
      on_every_set([&] {
        const std::vector<T> sum = run_sum(degree, samples, {}, {});
        for (std::size_t k = 0; k < sum.size(); ++k) {
          EXPECT_NEAR(static_cast<double>(sum[k]), expected[k], (4 + degree) * epsilon)
              << degree << " " << n << " " << k;
        }
        EXPECT_EQ(run_sum(degree, samples, {Layout::kBlocked, 0}, {Layout::kBlocked, 0}), sum);
        EXPECT_EQ(run_sum(degree, samples, {Layout::kBlocked, 1}, {Layout::kPlain, 3}), sum);
      });
    }
  }
}

TYPED_TEST(BatchSums, TakeOneWeightForAll) {
  using T = TypeParam;
  for (const std::size_t n : {1, 3, 4, 5, 1000}) {
    Samples<T> samples = random_samples<T>(n);
    for (auto& weight : samples.weights) weight[0] = T(0.001);
    for (const int degree : {0, 3, 7}) {
      on_every_set([&] {
        EXPECT_EQ(run_sum(degree, samples, {}, {Layout::kShared, 0}), run_sum(degree, samples, {}, {})) << n;
        EXPECT_EQ(run_sum(degree, samples, {Layout::kBlocked, 0}, {Layout::kShared, 0}),
                  run_sum(degree, samples, {}, {}))
            << n;
      });
    }
  }
}

TYPED_TEST(BatchSums, TakeOneDirectionForAll) {
  using T = TypeParam;
  for (const std::size_t n : {1, 2, 4, 5, 8, 9, 24, 25, 1000}) {
    Samples<T> samples = random_samples<T>(n);
    for (auto& direction : samples.directions) direction = samples.directions[0];
    for (const int degree : {0, 1, 2, 3, 4, 7}) {
      on_every_set([&] {
        const std::vector<T> sum = run_sum(degree, samples, {}, {});
        EXPECT_EQ(run_sum(degree, samples, {Layout::kShared, 0}, {}), sum) << degree << " " << n;
        EXPECT_EQ(run_sum(degree, samples, {Layout::kShared, 0}, {Layout::kBlocked, 1}), sum) << degree << " " << n;
      });
    }
  }
}

// Half-precision numbers of every kind, with their values.
const std::vector<std::pair<std::uint16_t, float>> kHalves{{0x0000, 0.F},
                                                           {0x3c00, 1.F},
                                                           {0xc000, -2.F},
                                                           {0x3555, 0.33325195F},
                                                           {0x0001, 5.9604645e-08F},
                                                           {0x03ff, 6.097555e-05F},
                                                           {0x0400, 6.1035156e-05F},
                                                           {0x7bff, 65504.F},
                                                           {0x8001, -5.9604645e-08F}};

// n records of halves in a layout, and the same numbers in float; what belongs to no record is not a number.
struct HalvesAndFloats {
  std::vector<batch::Half> halves;
  Array<float> floats;

  HalvesAndFloats(Layout layout, std::size_t n, std::size_t size, std::mt19937& random)
      : floats({layout, 0}, n, size), layout_(layout) {
    const std::size_t values = layout == Layout::kBlocked  ? batch::blocked_size<float>(n, size)
                               : layout == Layout::kShared ? size
                                                           : n * size;
    halves.assign(values, batch::Half{0x7e00});
    std::uniform_int_distribution<std::size_t> any(0, kHalves.size() - 1);
    for (std::size_t i = 0; i < (layout == Layout::kShared ? 1 : n); ++i) {
      for (std::size_t k = 0; k < size; ++k) {
        const auto& [bits, value] = kHalves[any(random)];
        floats.at(i, k) = value;
        halves[&floats.at(i, k) - floats.records().data] = batch::Half{bits};
      }
    }
  }
  [[nodiscard]] Records<const batch::Half> records() const { return {halves.data(), layout_}; }

 private:
  Layout layout_;
};

// run(input 0, output) with records of `size` values in either type.
template <class Run>
void expect_same_bits(std::size_t n, std::size_t size, std::size_t out_size, std::mt19937& random, const Run& run) {
  for (const Layout layout : {Layout::kPlain, Layout::kBlocked, Layout::kShared}) {
    HalvesAndFloats both(layout, n, size, random);
    on_every_set([&] {
      std::vector<float> from_floats(out_size * n);
      std::vector<float> from_halves(out_size * n);
      run(Records<const float>(both.floats.records()), batch::plain(from_floats.data()));
      run(both.records(), batch::plain(from_halves.data()));
      EXPECT_EQ(from_halves, from_floats) << n;
    });
  }
}

TEST(BatchHalves, GiveTheBitsOfTheSameNumbersInFloat) {
  constexpr int kDegree = 3;
  std::mt19937 random(11);
  for (const std::size_t n : {std::size_t{1}, std::size_t{15}, std::size_t{16}, std::size_t{53}}) {
    const Samples<float> samples = random_samples<float>(n);
    const Array<float> directions({}, samples.directions, 3);
    expect_same_bits(n, 3 * coefficient_count(kDegree), 3, random, [&](auto colors, auto out) {
      batch::evaluate_rgb(kDegree, n, colors, directions.records(), out);
    });
    constexpr int kLight = 2;
    std::vector<float> light(3 * (8 * kLight * kLight + 4));
    for (float& sample : light) sample = std::uniform_real_distribution<float>(-1, 1)(random);
    const std::vector<float> lobe{0.5F, 0.25F, 0.125F};
    expect_same_bits(n, coefficient_count(2 * kLight), 3, random, [&](auto visibility, auto out) {
      batch::transfer_glossy_rgb(kLight, n, visibility, light.data(), batch::shared(lobe.data()), directions.records(),
                                 out);
    });
    expect_same_bits(
        n, coefficient_count(2 * kLight), 3 * coefficient_count(kLight), random,
        [&](auto visibility, auto out) { batch::transfer_apply_rgb(kLight, n, visibility, light.data(), out); });
  }
}

}  // namespace
}  // namespace sh::test
