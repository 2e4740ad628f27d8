// Claims on irradiance from nine coefficients: source_claims.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "numeric/report/source_claims.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/point_lights.hpp"

namespace sh::numeric {
namespace {

constexpr double kPercent = 100;
constexpr int kDegree = 2;
using Nine = std::array<double, coefficient_count(kDegree)>;

Nine nine(const SphereNode<double>& d) {
  Nine y;
  basis(kDegree, d.x, d.y, d.z, y.data());
  return y;
}

// Normals with the basis there, made once.
struct Normals {
  std::vector<SphereNode<double>> directions;
  std::vector<Nine> basis;

  explicit Normals(int count) : directions(fibonacci_nodes(count)) {
    for (const auto& d : directions) basis.push_back(nine(d));
  }
};

// |irradiance of nine coefficients - irradiance| over INT L: largest and mean over the normals.
struct Error {
  double largest = 0;
  double mean = 0;
};

Error error_of(const PointLights& light, const Normals& normals) {
  Nine coefficients{};
  for (const auto& source : light) {
    const Nine y = nine(source);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const int l = i == 0 ? 0 : i < 4 ? 1 : 2;
      coefficients[i] += clamped_cosine_factor<double>(l) * source.weight * y[i];
    }
  }
  Error error;
  for (std::size_t n = 0; n < normals.directions.size(); ++n) {
    const auto& normal = normals.directions[n];
    double difference = -irradiance(light, normal);
    for (std::size_t i = 0; i < coefficients.size(); ++i) difference += coefficients[i] * normals.basis[n][i];
    error.largest = std::max(error.largest, std::abs(difference));
    error.mean += std::abs(difference) / static_cast<double>(normals.directions.size());
  }
  return error;
}

Error worst_of_random_lights(const Normals& normals, bool quick) {
  Error worst;
  const int environments = quick ? 40 : 400;
  std::uint64_t seed = 0;
  for (const int count : {1, 2, 3, 5, 10, 50}) {
    for (int i = 0; i < environments; ++i) {
      const Error e = error_of(random_point_lights(count, ++seed), normals);
      worst.largest = std::max(worst.largest, e.largest);
      worst.mean = std::max(worst.mean, e.mean);
    }
  }
  return worst;
}

double mean_error_of_skies(const Normals& normals) {
  const std::array<PointLights, 4> skies{overcast_point_lights(0, 0), overcast_point_lights(0.2, 0),
                                         overcast_point_lights(0.2, 0.2), overcast_point_lights(0.2, 0.5)};
  double sum = 0;
  for (const PointLights& light : skies) sum += error_of(light, normals).mean;
  return sum / skies.size();
}

// The share of INT max(0, z)^2 that bands 0 .. 2 hold: sum (2l+1)/(4 pi) A_l^2 over 2 pi / 3.
double energy_of_three_bands() {
  double energy = 0;
  for (int l = 0; l <= kDegree; ++l) {
    const auto factor = clamped_cosine_factor<double>(l);
    energy += (2 * l + 1) / (4 * std::numbers::pi) * factor * factor;
  }
  return energy / (2 * std::numbers::pi / 3);
}

}  // namespace

std::vector<SourceClaim> irradiance_claims(bool quick) {
  const Normals normals(quick ? 4000 : 16000);
  const Error worst = worst_of_random_lights(normals, quick);
  return {
      claim_of("RH-13", 0, kPercent * worst.mean,
               "mean over normals of |error| / INT L, the worst of random sets of 1 to 50 lights; it is reached by one "
               "light, exactly 19 sqrt(19) / 2700 = 3.07 %"),
      claim_of("RH-13", 1, kPercent * worst.largest,
               "largest |error| / INT L of the same; exactly 3/32 = 9.375 % for one light, on its horizon"),
      claim_of("RH-13", 2, kPercent * mean_error_of_skies(normals),
               "mean over four CIE overcast skies: black ground, bright ground, with a sun of 20 % and 50 % of the "
               "power; the sources speak of captured pictures"),
      claim_of("BJ-01", 0, kPercent * energy_of_three_bands(), "sum (2l+1)/(4 pi) A_l^2 over INT max(0, z)^2"),
  };
}

}  // namespace sh::numeric
