// A light with random coefficients in [-1, 1).
#pragma once

#include <random>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt::test {

inline LightCoefficients random_light(int degree, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  LightCoefficients light = LightCoefficients::zero(degree);
  for (double& value : light.values) value = uniform(random);
  return light;
}

}  // namespace sh::prt::test
