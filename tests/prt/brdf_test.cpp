// Tables of BRDFs: the surface model of glTF against its formulas, measured ones from files, and their lobes in the world.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "prt/angles.hpp"
#include "prt/basis.hpp"
#include "prt/material/measured.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/material/reflected.hpp"
#include "prt/material/tabulate.hpp"
#include "prt/runtime/glossy.hpp"
#include "tests/prt/brdf_files.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

using Eigen::Vector3d;

// The facets as the specification of glTF 2.0 writes them in appendix B: D V, and (1 - v.h)^5.
std::array<double, 2> facets(double roughness, const Vector3d& light, const Vector3d& eye) {
  const Vector3d half = (light + eye).normalized();
  const double square = std::pow(roughness, 4);
  const double d = square / (std::numbers::pi * std::pow(half.z() * half.z() * (square - 1.0) + 1.0, 2));
  const double v = 0.5 / (light.z() * std::sqrt(eye.z() * eye.z() * (1.0 - square) + square) +
                          eye.z() * std::sqrt(light.z() * light.z() * (1.0 - square) + square));
  return {d * v, std::pow(1.0 - eye.dot(half), 5)};
}

// The integral of a function over the hemisphere, finely.
template <class Function>
double over_hemisphere(const Function& function, int polar = 220) {
  const int around = 2 * polar;
  const auto rule = numeric::gauss_legendre<double>(polar);
  double sum = 0.0;
  for (int i = 0; i < polar; ++i) {
    const double z = 0.5 + 0.5 * rule.nodes[static_cast<std::size_t>(i)];
    const double r = std::sqrt(1.0 - z * z);
    for (int j = 0; j < around; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / around;
      sum += rule.weights[static_cast<std::size_t>(i)] * function({r * std::cos(azimuth), r * std::sin(azimuth), z});
    }
  }
  return sum * 0.5 * 2.0 * std::numbers::pi / around;
}

// The part of constant light that a coat reflects at an angle, and its mean.
class Coat {
 public:
  explicit Coat(double roughness) {
    for (std::size_t i = 0; i < kAngles; ++i) {
      const double angle = static_cast<double>(i) * std::numbers::pi / 2.0 / kAngles;
      const Vector3d eye(std::sin(angle), 0.0, std::cos(angle));
      reflected_[i] = over_hemisphere(
          [&](const Vector3d& light) {
            const auto [facet, grazing] = facets(roughness, light, eye);
            return facet * (0.04 + 0.96 * grazing) * light.z();
          },
          100);
      mean_ += 2.0 * std::sin(angle) * std::cos(angle) * reflected_[i] * std::numbers::pi / 2.0 / kAngles;
    }
    reflected_[kAngles] = reflected_[kAngles - 1];
  }
  [[nodiscard]] double at(double cosine) const {
    const double place = std::acos(std::min(cosine, 1.0)) * kAngles / (std::numbers::pi / 2.0);
    const auto first = std::min(static_cast<std::size_t>(place), kAngles - 1);
    const double part = place - static_cast<double>(first);
    return (1.0 - part) * reflected_[first] + part * reflected_[first + 1];
  }
  [[nodiscard]] double mean() const { return mean_; }

 private:
  static constexpr std::size_t kAngles = 180;
  std::array<double, kAngles + 1> reflected_{};
  double mean_ = 0.0;
};

// The model of gray surfaces.
double gltf_brdf(const Coat& coat, double base, double metallic, double roughness, const Vector3d& light,
                 const Vector3d& eye) {
  const auto [facet, grazing] = facets(roughness, light, eye);
  const double entering = (1.0 - coat.at(light.z())) * (1.0 - coat.at(eye.z())) / (1.0 - coat.mean());
  const double dielectric = base / std::numbers::pi * entering + facet * (0.04 + 0.96 * grazing);
  const double metal = facet * (base + (1.0 - base) * grazing);
  return (1.0 - metallic) * dielectric + metallic * metal;
}

double basis_at(int l, int m, const Vector3d& s) {
  BasisValues values;
  evaluate_basis(l, s.x(), s.y(), s.z(), values.data());
  return values[coefficient_index(l, m)];
}

// The coefficient of a gray surface of this albedo.
double coefficient(const Reflectance& made, int view, int l, int m, double albedo) {
  const std::size_t row = static_cast<std::size_t>(view) * kReflectionParts;
  const std::size_t i = even_count(l - 1) + static_cast<std::size_t>(m);
  return albedo * static_cast<double>(made.table[row * even_count(kMaxDegree) + i]) +
         static_cast<double>(made.table[(row + 1) * even_count(kMaxDegree) + i]);
}

TEST(Microfacet, IsTheModelOfGltf) {
  for (const float roughness : {0.4F, 0.7F, 1.0F}) {
    const Coat coat(static_cast<double>(roughness));
    for (const float metallic : {0.0F, 0.3F, 1.0F}) {
      const Reflectance made = microfacet_reflectance(roughness, metallic);
      for (const int view : {0, 20, 50, 62}) {
        const Vector3d eye = view_direction(view);
        for (const auto& [l, m] : {std::pair(0, 0), {1, 1}, {4, 1}, {7, 3}}) {
          const double expected = over_hemisphere([&, l = l, m = m](const Vector3d& s) {
            return gltf_brdf(coat, 0.6, static_cast<double>(metallic), static_cast<double>(roughness), s, eye) * s.z() *
                   basis_at(l, m, s);
          });
          EXPECT_NEAR(coefficient(made, view, l, m, 0.6), expected, view < 60 ? 5e-4 : 2e-3)
              << roughness << ' ' << metallic << ' ' << view << ' ' << l << ' ' << m;
        }
      }
    }
  }
}

TEST(Microfacet, WithoutRoughnessIsAMirror) {
  const Reflectance made = microfacet_reflectance(0.0F, 1.0F);
  for (int view = 0; view < kViews; ++view) {
    const Vector3d eye = view_direction(view);
    const Vector3d mirrored(-eye.x(), 0.0, eye.z());
    for (const auto& [l, m] : {std::pair(0, 0), {1, 1}, {4, 2}, {10, 10}, {10, 0}}) {
      EXPECT_NEAR(coefficient(made, view, l, m, 1.0), basis_at(l, m, mirrored), 1e-6) << view << ' ' << l << ' ' << m;
    }
  }
}

TEST(Microfacet, NeverReflectsMoreThanArrives) {
  for (const float roughness : {0.0F, 0.01F, 0.1F, 0.3F, 0.6F, 1.0F}) {
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
      const Reflectance made = microfacet_reflectance(roughness, metallic);
      for (int view = 0; view < kViews; ++view) {
        const Vector3d parts = hemispherical_reflectance(made.table.data(), view);
        EXPECT_GE(parts.minCoeff(), 0.0);
        EXPECT_LE(parts.sum(), 1.0 + 1e-4) << roughness << ' ' << metallic << ' ' << view;
        EXPECT_GT(parts.sum(), roughness < 0.5F ? 0.85 : 0.3) << roughness << ' ' << metallic << ' ' << view;
        if (metallic == 0.0F) {
          EXPECT_NEAR(parts.sum(), 1.0, 1e-6) << roughness << ' ' << view;
        }
      }
    }
  }
}

// The energy between two bands of light and view is symmetric, because the BRDF is; the view is only tabulated.
TEST(Microfacet, IsReciprocal) {
  for (const float roughness : {0.3F, 0.8F}) {
    const Reflectance made = microfacet_reflectance(roughness, 0.4F);
    const auto sent = [&](int of_light, int of_view, int m) {
      double sum = 0.0;
      for (int view = 0; view < kViews; ++view) {
        const Vector3d eye = view_direction(view);
        sum += eye.x() * eye.z() * coefficient(made, view, of_light, m, 0.5) * basis_at(of_view, m, eye);
      }
      return sum * std::numbers::pi / 2.0 / (kViews - 1);
    };
    for (const auto& [l, k, m] : {std::array{0, 1, 0}, {0, 3, 0}, {2, 4, 0}, {1, 3, 1}, {2, 5, 2}}) {
      EXPECT_NEAR(sent(l, k, m), sent(k, l, m), 3e-4) << roughness << ' ' << l << ' ' << k << ' ' << m;
      EXPECT_GT(std::abs(sent(l, l, m)), 1e-3);
    }
  }
}

TEST(Reflectance, BetweenViewsIsThatOfTheView) {
  const Coat none(1.0);
  const Reflectance made = microfacet_reflectance(0.5F, 1.0F);
  for (const double angle : {0.01, 0.3, 0.7, 1.1, 1.4, 1.53}) {
    std::array<float, kReflectionParts * even_count(6)> out;
    reflectance_at(made.table.data(), 6, static_cast<float>(angle), out.data());
    const Vector3d eye(std::sin(angle), 0.0, std::cos(angle));
    for (const auto& [l, m] : {std::pair(0, 0), {1, 1}, {3, 2}, {6, 6}, {6, 0}}) {
      const std::size_t i = even_count(l - 1) + static_cast<std::size_t>(m);
      const double expected = over_hemisphere([&, l = l, m = m](const Vector3d& s) {
        return gltf_brdf(none, 0.7, 1.0, 0.5, s, eye) * s.z() * basis_at(l, m, s);
      });
      EXPECT_NEAR(0.7 * static_cast<double>(out[i]) + static_cast<double>(out[even_count(6) + i]), expected,
                  angle < 1.5 ? 3e-4 : 1e-3)
          << angle << ' ' << l << ' ' << m;
    }
  }
}

TEST(Reflectance, BelowTheHorizonIsThatOfGrazingView) {
  const Reflectance made = microfacet_reflectance(0.5F, 1.0F);
  std::array<float, kReflectionParts * even_count(4)> grazing;
  std::array<float, kReflectionParts * even_count(4)> below;
  constexpr float kRight = std::numbers::pi_v<float> / 2.0F;
  reflectance_at(made.table.data(), 4, kRight, grazing.data());
  for (const float angle : {kRight + 1e-6F, 2.0F, 2.0F * kRight}) {
    reflectance_at(made.table.data(), 4, angle, below.data());
    EXPECT_EQ(below, grazing);
  }
}

// The numbers of a view are its angle, which the polynomial through four views then is, too.
TEST(Reflectance, SeesSmallAnglesOfViewToRoundings) {
  ReflectanceTable table(kReflectanceTableSize);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::size_t view = i / (kReflectionParts * even_count(kMaxDegree));
    table[i] = static_cast<float>(static_cast<double>(view) * std::numbers::pi / 2.0 / (kViews - 1));
  }
  const Vector3d normal = Vector3d(0.3, -0.5, 0.7).normalized();
  for (const double angle : {0.0, 1e-5, 1e-4, 1e-3, 1e-2, 0.5, 1.5}) {
    const Eigen::Vector3f up = normal.cast<float>();
    const Eigen::Vector3f eye = (Eigen::AngleAxisd(angle, normal.unitOrthogonal()) * normal).cast<float>();
    for_reflected_lobes({table.data(), true}, Eigen::Vector3f::Zero(), 0, up, eye,
                        [&](const Eigen::Vector3f&, const float* weights) {
                          EXPECT_NEAR(static_cast<double>(weights[0]), angle, 3e-7);
                        });
  }
}

// Light of degree 4 on a surface in any position, integrated in the world.
// At 45 degrees: 0.5 x 4 + 1 = 3 at the constant, 4 at the last number; other views and the third part do not count.
TEST(Reflectance, KnowsTheShareOfItsBands) {
  ReflectanceTable table(kReflectanceTableSize, 7.0F);
  EXPECT_EQ(share_of_bands({ReflectanceTable(kReflectanceTableSize, 0.0F).data(), false}, 0), 1.0);
  constexpr std::size_t kCount = even_count(kMaxDegree);
  float* const view = table.data() + std::size_t{(kViews - 1) / 2} * kReflectionParts * kCount;
  std::fill_n(view, 2 * kCount, 0.0F);
  view[0] = 4.0F;
  view[kCount] = 1.0F;
  view[kCount - 1] = 8.0F;
  for (int degree = 0; degree < kMaxDegree; ++degree) {
    EXPECT_DOUBLE_EQ(share_of_bands({table.data(), false}, degree), 9.0 / 25.0) << degree;
  }
  EXPECT_EQ(share_of_bands({table.data(), false}, kMaxDegree), 1.0);
  // Of a measured one the parts are red, green and blue: 16 + 1 + 49 of 16 + 64 + 1 + 49 kCount.
  EXPECT_DOUBLE_EQ(share_of_bands({table.data(), true}, 0), 66.0 / (81.0 + 49.0 * kCount));
}

TEST(Reflectance, TurnsWithTheSurface) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal_distribution;
  const auto direction = [&] {
    return Vector3d(normal_distribution(random), normal_distribution(random), normal_distribution(random)).normalized();
  };
  const Reflectance made = microfacet_reflectance(0.6F, 0.5F);
  const Coat coat(0.6);
  for (int i = 0; i < 6; ++i) {
    const Vector3d normal = i == 0 ? Vector3d::UnitZ().eval() : direction();
    Vector3d eye = i == 1 ? normal : direction();
    if (eye.dot(normal) < 0.0) eye = -eye;
    const std::vector<double> light = random_values<double>(3 * coefficient_count(4), 7);
    const std::vector<float> reaching(light.begin(), light.end());
    Material material{.albedo = {0.7F, 0.5F, 0.2F}, .brdf = {made.table.data()}};
    const Eigen::Vector3f seen = exit_radiance(material, 4, reaching.data(), normal.cast<float>(), eye.cast<float>());
    // The frame of the surface, where the integral is taken.
    const Eigen::Matrix3d to_world = frame_about(normal);
    const Vector3d local_eye = to_world.transpose() * eye;
    for (Eigen::Index c = 0; c < 3; ++c) {
      const double expected = over_hemisphere([&](const Vector3d& s) {
        const Vector3d world = to_world * s;
        BasisValues basis;
        evaluate_basis(4, world.x(), world.y(), world.z(), basis.data());
        double radiance = 0.0;
        for (std::size_t k = 0; k < coefficient_count(4); ++k) {
          radiance += basis[k] * light[static_cast<std::size_t>(c) * coefficient_count(4) + k];
        }
        return gltf_brdf(coat, static_cast<double>(material.albedo[c]), 0.5, 0.6, s, local_eye) * s.z() * radiance;
      });
      EXPECT_NEAR(static_cast<double>(seen[c]), expected, 1e-3) << i << ' ' << c;
    }
  }
}

class MeasuredBrdf : public testing::Test {
 protected:
  // What the reader says after the name of the file.
  std::string refusal(const std::string& file) {
    const std::string said = message_of([&] { read_measured_reflectance(file); });
    EXPECT_EQ(said.rfind(file + ": ", 0), 0U) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
    return said.substr(std::min(said.size(), file.size() + 2));
  }
  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.binary");
};

TEST_F(MeasuredBrdf, OfADiffuseSurfaceIsTheClampedCosine) {
  const Vector3d albedo(0.8, 0.5, 0.1);
  write_brdf(file_, diffuse_brdf(albedo));
  const MeasuredReflectance read = read_measured_reflectance(file_);
  EXPECT_TRUE(read.flaws.empty());
  EXPECT_LT((read.albedo.cast<double>() - albedo).cwiseAbs().maxCoeff(), 2e-3);
  for (const int view : {0, 30, 60, 64}) {
    for (int l = 0; l <= kMaxDegree; ++l) {
      for (int m = 0; m <= l; ++m) {
        const double cosine = m == 0 ? numeric::clamped_cosine_factor<double>(l) / std::numbers::pi *
                                           std::sqrt((2.0 * l + 1.0) / (4.0 * std::numbers::pi))
                                     : 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t row = static_cast<std::size_t>(view) * kReflectionParts + c;
          const std::size_t i = even_count(l - 1) + static_cast<std::size_t>(m);
          EXPECT_NEAR(static_cast<double>(read.reflectance.table[row * even_count(kMaxDegree) + i]),
                      albedo[static_cast<Eigen::Index>(c)] * cosine, 4e-3)
              << view << ' ' << l << ' ' << m;
        }
      }
    }
  }
}

TEST_F(MeasuredBrdf, OfAMicrofacetModelIsItsTable) {
  const Vector3d base(0.9, 0.6, 0.3);
  const Coat coat(0.5);
  write_brdf(file_, brdf_values([&](const Vector3d&, const Vector3d& light, const Vector3d& eye) -> Vector3d {
               if (light.z() <= 0.0 || eye.z() <= 0.0) return Vector3d::Constant(-1.0 / 1500.0);  // as in the data base
               return base.unaryExpr([&](double albedo) { return gltf_brdf(coat, albedo, 0.7, 0.5, light, eye); });
             }));
  const MeasuredReflectance read = read_measured_reflectance(file_);
  const Reflectance made = microfacet_reflectance(0.5F, 0.7F);
  double most = 0.0;
  for (const int view : {0, 10, 30, 50, 58}) {
    for (int l = 0; l <= 6; ++l) {
      for (int m = 0; m <= l; ++m) {
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t row = static_cast<std::size_t>(view) * kReflectionParts + c;
          const std::size_t i = even_count(l - 1) + static_cast<std::size_t>(m);
          const double expected = coefficient(made, view, l, m, base[static_cast<Eigen::Index>(c)]);
          EXPECT_NEAR(static_cast<double>(read.reflectance.table[row * even_count(kMaxDegree) + i]), expected, 0.012)
              << view << ' ' << l << ' ' << m;
          most = std::max(most, std::abs(expected));
        }
      }
    }
  }
  EXPECT_GT(most, 0.3);
}

TEST_F(MeasuredBrdf, ThatIsDamagedIsRefused) {
  EXPECT_EQ(refusal(folder_.file("none.binary")), "cannot read the measured BRDF: No such file or directory");
  std::vector<double> values = diffuse_brdf({0.5, 0.5, 0.5});
  write_brdf(file_, values, {90, 180, 90});
  EXPECT_EQ(refusal(file_), "not a measured BRDF of the MERL data base: 90 x 180 x 90 values, expected 90 x 90 x 180");
  write_brdf(file_, values, {90, 90});
  EXPECT_EQ(refusal(file_), "not a measured BRDF of the MERL data base: 34992008 bytes, expected 34992012");
  write_all(file_, "");
  EXPECT_EQ(refusal(file_), "not a measured BRDF of the MERL data base: 0 bytes, expected 34992012");
  values[1000000] = std::nan("");
  write_brdf(file_, values);
  EXPECT_EQ(refusal(file_), "a value of the measured BRDF is not finite");
  write_brdf(file_, diffuse_brdf({0.5, -0.1, 0.5}));
  EXPECT_EQ(refusal(file_),
            "100 % of the measured BRDF is negative above the horizon; expected reflectance of 0 or more");
}

TEST_F(MeasuredBrdf, WithAFewNegativesOrTooMuchLightSaysSo) {
  std::vector<double> values = diffuse_brdf({0.5, 0.5, 0.5});
  for (std::size_t i = 0; i < 90 * 180; ++i) values[i] = -1.0;  // where the half vector is the normal
  write_brdf(file_, values);
  const MeasuredReflectance read = read_measured_reflectance(file_);
  ASSERT_EQ(read.flaws.size(), 1U);
  EXPECT_NE(read.flaws[0].find("is negative above the horizon (0 in its place)"), std::string::npos);
  write_brdf(file_, diffuse_brdf({0.5, 2.0, 0.5}));
  const MeasuredReflectance bright = read_measured_reflectance(file_);
  ASSERT_EQ(bright.flaws.size(), 1U);
  EXPECT_NE(bright.flaws[0].find("of the light, more than arrives"), std::string::npos);
  EXPECT_EQ(bright.albedo.y(), 1.0F);
}

}  // namespace
}  // namespace sh::prt::test
