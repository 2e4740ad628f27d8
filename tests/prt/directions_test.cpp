// The sets of directions: shape, seeds, integrals, the decrease of the error at a shadow's edge, and bakes with each
// set.
#include "prt/rays/directions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/power_law.hpp"
#include "numeric/sampling/random.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/angles.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kDegree = 4;
constexpr std::size_t kCount = 25;
constexpr std::array kSamplers = {Sampler::kFibonacci, Sampler::kStratified, Sampler::kSobol, Sampler::kRandom,
                                  Sampler::kCosine};

using Vector = Eigen::Vector3d;
using Coefficients = std::array<double, kCount>;

Coefficients basis_at(const Vector& d) {
  Coefficients values;
  numeric::basis(kDegree, d.x(), d.y(), d.z(), values.data());
  return values;
}

// A surface that faces `normal` with a disc about `towards` in its sky, wholly above the horizon.
struct Shaded {
  Vector normal;
  Vector towards;
  double cosine;  // of the disc's half-angle
};

// 24 of them, spread over all directions.
std::vector<Shaded> shaded_surfaces() {
  std::vector<Shaded> surfaces;
  const auto normals = numeric::random_directions(24, 5);
  const auto sideways = numeric::random_directions(24, 6);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector normal(normals[i].x, normals[i].y, normals[i].z);
    const Vector towards = (2.0 * normal + Vector(sideways[i].x, sideways[i].y, sideways[i].z)).normalized();
    surfaces.push_back({normal, towards, 0.88});  // 28 degrees; the disc's middle is at most 30 degrees off the normal
  }
  return surfaces;
}

// Adds scale cos/pi Y over the cap: a polynomial, which the rule integrates exactly.
void add_cap(const Vector& normal, const Vector& towards, double cosine, double scale, Coefficients& sum) {
  const numeric::GaussLegendreRule<double> rule = numeric::gauss_legendre<double>(12);
  const Vector across = towards.unitOrthogonal();
  const Vector along = towards.cross(across);
  constexpr int kAzimuths = 12;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double z = 0.5 * ((1.0 + cosine) + (1.0 - cosine) * rule.nodes[i]);
    for (int j = 0; j < kAzimuths; ++j) {
      const double azimuth = 2.0 * kPi * j / kAzimuths;
      const double radius = std::sqrt(1.0 - z * z);
      const Vector d = radius * (std::cos(azimuth) * across + std::sin(azimuth) * along) + z * towards;
      const double weight = 0.5 * (1.0 - cosine) * rule.weights[i] * 2.0 * kPi / kAzimuths;
      const Coefficients values = basis_at(d);
      for (std::size_t k = 0; k < kCount; ++k) sum[k] += scale * weight * d.dot(normal) / kPi * values[k];
    }
  }
}

Coefficients exact_transfer(const Shaded& surface) {
  Coefficients sum{};
  add_cap(surface.normal, surface.normal, 0.0, 1.0, sum);
  add_cap(surface.normal, surface.towards, surface.cosine, -1.0, sum);
  return sum;
}

// The estimate of the directions, without a control variate.
Coefficients sampled_transfer(const Shaded& surface, const std::vector<Eigen::Vector3f>& directions, Sampler sampler) {
  const bool local = sampler == Sampler::kCosine;
  const Eigen::Matrix3d frame = frame_about(surface.normal.cast<float>().eval()).cast<double>();
  const double share = (local ? 1.0 : 4.0) / static_cast<double>(directions.size());
  Coefficients sum{};
  for (const Eigen::Vector3f& direction : directions) {
    const Vector d = local ? Vector(frame * direction.cast<double>()) : Vector(direction.cast<double>());
    const double cosine = d.dot(surface.normal);
    if (cosine <= 0.0 || d.dot(surface.towards) > surface.cosine) continue;
    const Coefficients values = basis_at(d);
    for (std::size_t k = 0; k < kCount; ++k) sum[k] += share * (local ? 1.0 : cosine) * values[k];
  }
  return sum;
}

double rms_error(Sampler sampler, int count) {
  constexpr std::uint32_t kSeeds = 8;
  double sum = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<Eigen::Vector3f> directions = make_directions(sampler, count, seed);
    for (const Shaded& surface : shaded_surfaces()) {
      const Coefficients exact = exact_transfer(surface);
      const Coefficients sampled = sampled_transfer(surface, directions, sampler);
      for (std::size_t k = 0; k < kCount; ++k) sum += (sampled[k] - exact[k]) * (sampled[k] - exact[k]);
    }
  }
  return std::sqrt(sum / (kSeeds * static_cast<double>(shaded_surfaces().size() * kCount)));
}

// Of the line through (log count, log error) by least squares.
double slope(Sampler sampler) {
  constexpr std::array kCounts = {128, 512, 2048, 8192};
  std::vector<std::pair<double, double>> errors;
  for (const int count : kCounts) errors.emplace_back(count, rms_error(sampler, count));
  const numeric::PowerLaw law = numeric::fit_power_law(errors).value();
  std::printf("%-10s error %.2e at %d directions, slope %.3f\n", std::string(name_of(sampler)).c_str(),
              law.factor * std::pow(2048.0, law.exponent), 2048, law.exponent);
  return law.exponent;
}

TEST(Directions, AreAsManyUnitVectorsAsAreAskedFor) {
  for (const Sampler sampler : kSamplers) {
    for (const int count : {1, 2, 3, 7, 64, 1000, 4097}) {
      const auto directions = make_directions(sampler, count, 9);
      EXPECT_EQ(directions.size(), static_cast<std::size_t>(sampler == Sampler::kCosine ? (count + 1) / 2 : count));
      for (const Eigen::Vector3f& d : directions) {
        ASSERT_NEAR(d.norm(), 1.0F, 2e-7F) << name_of(sampler) << ' ' << count;
      }
    }
    EXPECT_THROW(make_directions(sampler, 0, 1), std::invalid_argument);
    EXPECT_THROW(make_directions(sampler, kMaxDirections + 1, 1), std::invalid_argument);
  }
}

// Errors of one direction times sqrt(count), which for independent ones is 1 rms, whatever the function.
TEST(Directions, IntegrateLowDegreesToZero) {
  constexpr int kDirections = 2048;
  const std::array<double, 4> limits = {0.008, 0.4, 0.12, 4.0};  // measured: 3.6e-3, 0.155, 0.049, 1.97
  for (std::size_t s = 0; s < limits.size(); ++s) {
    Coefficients sum{};
    for (const Eigen::Vector3f& d : make_directions(kSamplers[s], kDirections, 3)) {
      const Coefficients values = basis_at(d.cast<double>());
      std::transform(sum.begin(), sum.end(), values.begin(), sum.begin(), std::plus<>());
    }
    const auto worst =
        std::max_element(sum.begin() + 1, sum.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double error = std::abs(*worst) * std::sqrt(4.0 * kPi / kDirections);
    std::printf("%-10s worst of degrees 1..4: %.2e at i = %td\n", std::string(name_of(kSamplers[s])).c_str(), error,
                worst - sum.begin());
    EXPECT_LT(error, limits[s]) << name_of(kSamplers[s]);
  }
}

TEST(Directions, AboutTheNormalAreAsDenseAsTheCosine) {
  Coefficients sum{};
  const auto directions = make_directions(Sampler::kCosine, 4096, 3);
  for (const Eigen::Vector3f& d : directions) {
    EXPECT_GT(d.z(), 0.0F);
    const Coefficients values = basis_at(d.cast<double>());
    std::transform(sum.begin(), sum.end(), values.begin(), sum.begin(),
                   [&](double a, double b) { return a + b / static_cast<double>(directions.size()); });
  }
  Coefficients exact{};
  add_cap(Vector::UnitZ(), Vector::UnitZ(), 0.0, 1.0, exact);
  for (std::size_t k = 0; k < kCount; ++k) {
    EXPECT_NEAR(sum[k], exact[k], 1e-3) << k;
  }
}

TEST(Directions, AreTheSameForTheSameSeedAndDifferForAnother) {
  for (const Sampler sampler : kSamplers) {
    EXPECT_EQ(make_directions(sampler, 100, 4), make_directions(sampler, 100, 4));
    EXPECT_EQ(make_directions(sampler, 100, 4) == make_directions(sampler, 100, 5), sampler == Sampler::kFibonacci);
  }
}

TEST(Directions, OfTheStratifiedSetLieOneInEachCell) {
  // Zones are whole numbers of cells, so that between two seeds only places within zones differ.
  const auto a = numeric::zone_nodes(1000, 1);
  const auto b = numeric::zone_nodes(1000, 2);
  double furthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) furthest = std::max(furthest, std::abs(a[i].z - b[i].z));
  EXPECT_LT(furthest, 0.16);  // a zone is 28 cells wide at most, of 2/1000 each in z: 0.056; 3 sigma on the poles less
}

TEST(SobolPoints, LieOneInEachElementaryBoxWhateverTheSeed) {
  constexpr int kLog = 8;
  for (const std::uint64_t seed : {0U, 1U, 77U}) {
    const auto points = numeric::sobol_points(3 << kLog, seed);
    for (int block = 0; block < 3; ++block) {
      for (int columns = 0; columns <= kLog; ++columns) {
        std::vector<int> hits(std::size_t{1} << kLog, 0);
        for (int i = block << kLog; i < (block + 1) << kLog; ++i) {
          const auto& [u, v] = points[i];
          ASSERT_TRUE(u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0);
          const auto column = static_cast<std::size_t>(std::ldexp(u, columns));
          const auto row = static_cast<std::size_t>(std::ldexp(v, kLog - columns));
          ++hits[(column << (kLog - columns)) + row];
        }
        EXPECT_TRUE(std::all_of(hits.begin(), hits.end(), [](int n) { return n == 1; })) << block << ' ' << columns;
      }
    }
  }
}

TEST(SobolPoints, AreUniformOverTheSeeds) {
  constexpr int kSeeds = 4000;
  std::array<double, 2> mean{};
  std::array<double, 2> square{};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto point = numeric::sobol_points(6, seed).back();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      mean[axis] += point[axis] / kSeeds;
      square[axis] += point[axis] * point[axis] / kSeeds;
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(mean[axis], 1.0 / 2.0, 0.02) << axis;  // 4 standard errors
    EXPECT_NEAR(square[axis], 1.0 / 3.0, 0.02) << axis;
  }
}

// At an edge no set can do better than count^-3/4; independent directions reach -1/2.
TEST(Directions, LoseTheirErrorAtAShadowsEdgeAtTheRateOfTheirSampler) {
  const double random = slope(Sampler::kRandom);
  EXPECT_NEAR(random, -0.5, 0.06);
  for (const Sampler sampler : {Sampler::kFibonacci, Sampler::kStratified, Sampler::kSobol, Sampler::kCosine}) {
    EXPECT_NEAR(slope(sampler), -0.75, 0.1) << name_of(sampler);
  }
}

TEST(Frames, AreRotationsThatTakeZToTheNormal) {
  for (const auto& [x, y, z] : numeric::standard_directions(200)) {
    const Eigen::Vector3f normal = Vector(x, y, z).normalized().cast<float>();
    const Eigen::Matrix3f frame = frame_about(normal);
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3f::Identity()).cwiseAbs().maxCoeff(), 1e-6F) << normal;
    EXPECT_NEAR(frame.determinant(), 1.0F, 1e-6F);
    EXPECT_EQ(frame.col(2), normal);
  }
}

Transfer baked_with(Sampler sampler, const Mesh& mesh, const TransferKind* kind, int directions) {
  Scene scene = scene_of(mesh, kind, directions, kDegree);
  scene.bake.sampler = sampler;
  scene.bake.seed = 11;
  return bake(scene);
}

TEST(BakeWithEverySampler, IsExactWhereNothingIsInTheWayAndZeroWhereEverythingIs) {
  for (const Sampler sampler : kSamplers) {
    Mesh mesh = with_one_normal("sphere", 12);
    const Transfer open = baked_with(sampler, mesh, &kShadowed, 300);
    EXPECT_EQ(open.coefficients, baked_with(sampler, mesh, &kUnshadowed, 300).coefficients);
    EXPECT_EQ(open.sampler, sampler);
    EXPECT_EQ(open.seed, 11U);
    turn_inside_out(mesh);
    const Transfer closed = baked_with(sampler, mesh, &kShadowed, 300);
    EXPECT_TRUE(std::all_of(closed.coefficients.begin(), closed.coefficients.end(), [](float t) { return t == 0.0F; }))
        << name_of(sampler);
  }
}

TEST(BakeWithEverySampler, ComesToTheSameResult) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Mesh mesh = primitive_mesh("stairs");
    const Transfer reference = baked_with(Sampler::kFibonacci, mesh, kind, 65536);
    for (const Sampler sampler : kSamplers) {
      const double error = rms_difference(baked_with(sampler, mesh, kind, 16384), reference);
      EXPECT_LT(error, sampler == Sampler::kRandom ? 4e-3 : 4e-4) << name_of(sampler);
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
