#include "codegen/domains.hpp"

#include <cln/real.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "codegen/directions.hpp"

namespace sh::codegen {
namespace {

std::vector<std::vector<double>> directions(int /*degree*/) {
  std::vector<std::vector<double>> inputs;
  for (const auto& d : test_directions()) inputs.push_back({d[0], d[1], d[2]});
  return inputs;
}

double band_maximum(std::span<const double> /*inputs*/, std::size_t output) {
  const double band = std::floor(std::sqrt(static_cast<double>(output)));
  return std::sqrt((2 * band + 1) / (4 * std::numbers::pi));
}

std::vector<cln::cl_F> normalised(const std::vector<cln::cl_F>& d) {
  const cln::cl_F length = cln::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

}  // namespace

Domain direction_domain() {
  return {"directions (random, axes, poles, near poles)",
          "sqrt((2l+1)/(4 pi))",
          "the input scaled to length 1",
          directions,
          band_maximum,
          normalised};
}

std::vector<std::vector<double>> unit_vectors(int count, int size, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> vectors;
  for (int i = 0; i < count; ++i) {
    std::vector<double> v(static_cast<std::size_t>(size));
    // std::uniform_real_distribution may differ between libraries.
    for (double& component : v) component = std::ldexp(static_cast<double>(random() >> 11U), -52) - 1;
    const double norm = length(v);
    for (double& component : v) component /= norm;
    vectors.push_back(std::move(v));
  }
  return vectors;
}

double length(std::span<const double> vector) {
  return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

std::vector<std::vector<cln::cl_RA>> rational_vectors(int count, int size, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<cln::cl_RA>> vectors;
  for (int i = 0; i < count; ++i) {
    std::vector<cln::cl_RA> v;
    for (int k = 0; k < size; ++k) {
      v.push_back(cln::cl_RA(static_cast<long>(random() % 2001) - 1000) / static_cast<long>(random() % 500 + 1));
    }
    vectors.push_back(std::move(v));
  }
  return vectors;
}

}  // namespace sh::codegen
