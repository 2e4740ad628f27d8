#include "codegen/measure/domains.hpp"

#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "codegen/measure/directions.hpp"

namespace sh::codegen {
namespace {

std::vector<std::vector<double>> directions(int /*degree*/) {
  std::vector<std::vector<double>> inputs;
  for (const auto& d : test_directions()) inputs.push_back({d[0], d[1], d[2]});
  return inputs;
}

}  // namespace

Domain direction_domain() {
  return {.inputs = "directions (random, axes, poles, near poles)",
          .unit = "sqrt((2l+1)/(4 pi))",
          .test_inputs = directions,
          .sizes = {"Y(l)"}};
}

std::vector<std::vector<double>> unit_vectors(int count, int size, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> vectors;
  for (int i = 0; i < count; ++i) {
    std::vector<double> v(size);
    // std::uniform_real_distribution may differ between libraries.
    for (double& component : v) component = std::ldexp(static_cast<double>(random() >> 11U), -52) - 1;
    const double norm = length(v);
    for (double& component : v) component /= norm;
    vectors.push_back(std::move(v));
  }
  return vectors;
}

std::vector<std::array<double, 3>> some_test_directions(std::size_t count) {
  constexpr std::size_t kAxes = 6;
  const std::vector<std::array<double, 3>> all = test_directions();
  const std::size_t step = std::max<std::size_t>(1, all.size() / count);
  std::vector<std::array<double, 3>> chosen(all.begin(), all.begin() + kAxes);
  for (std::size_t i = kAxes; i < all.size(); i += step) chosen.push_back(all[i]);
  return chosen;
}

std::vector<double> cap_sizes(int count, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<double> sizes;
  sizes.reserve(count);
  for (int i = 0; i < count; ++i) {
    const double u = std::ldexp(static_cast<double>((random() >> 11U) | 1U), -52);
    const double near = u * std::ldexp(1.0, -static_cast<int>(random() % 20));
    sizes.push_back(i % 3 == 0 ? u : i % 3 == 1 ? near : 2 - near);
  }
  return sizes;
}

double length(std::span<const double> vector) {
  return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

std::vector<std::vector<cln::cl_RA>> rational_vectors(int count, int size, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<cln::cl_RA>> vectors;
  for (int i = 0; i < count; ++i) {
    std::vector<cln::cl_RA> v;
    v.reserve(size);
    for (int k = 0; k < size; ++k) {
      const auto numerator = static_cast<long>(random() % 2001) - 1000;
      v.push_back(cln::cl_RA(numerator) / static_cast<long>(random() % 500 + 1));
    }
    vectors.push_back(std::move(v));
  }
  return vectors;
}

}  // namespace sh::codegen
