#include "codegen/measure/rotations.hpp"

#include <cln/real.h>

#include <random>

namespace sh::codegen {
namespace {

constexpr int kRandomRotations = 40;
constexpr int kDenseTilts = 31;  // tan(tilt / 2) takes every power of two from 2^-31 to 2^31
constexpr int kNewtonSteps = 6;  // each step doubles the digits, from 3 digits of the matrix to more than 100

class Random {
 public:
  cln::cl_RA rational() {
    const auto numerator = static_cast<long>(engine_() % 4001) - 2000;
    return cln::cl_RA(numerator) / static_cast<long>(engine_() % 1000 + 1);
  }
  RationalQuaternion quaternion() {
    const cln::cl_RA x = rational();
    const cln::cl_RA y = rational();
    const cln::cl_RA z = rational();
    return {rational(), x, y, z};
  }
  RationalQuaternion about_z() { return {1, 0, 0, rational()}; }

 private:
  std::mt19937_64 engine_{1776};
};

cln::cl_RA power_of_two(int exponent) { return cln::expt(cln::cl_RA(2), exponent); }

// Rz(random) Ry(2 atan t) Rz(random)
RationalQuaternion tilted(Random& random, const cln::cl_RA& half_tangent) {
  const RationalQuaternion last = random.about_z();
  const RationalQuaternion first = random.about_z();
  return symbolic::quaternion_product(symbolic::quaternion_product(last, {1, 0, half_tangent, 0}), first);
}

void add_random(std::vector<RationalQuaternion>& rotations, Random& random) {
  for (int i = 0; i < kRandomRotations; ++i) rotations.push_back(random.quaternion());
  for (int k = -kDenseTilts; k <= kDenseTilts; ++k) rotations.push_back(tilted(random, power_of_two(k)));
  for (const int k : {40, 48, 50, 51, 52, 53, 54, 60, 100}) {
    rotations.push_back(tilted(random, power_of_two(-k)));
    rotations.push_back(tilted(random, power_of_two(k)));
  }
  for (int k = 1; k <= kDenseTilts; k += 3) {
    RationalQuaternion q = random.quaternion();
    q[0] = power_of_two(k) * 1000;
    rotations.push_back(q);
  }
}

}  // namespace

std::vector<cln::cl_RA> rotation_entries(const RationalQuaternion& q) {
  const auto scaled = symbolic::matrix_from_quaternion(q);
  const cln::cl_RA square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  std::vector<cln::cl_RA> entries;
  for (int i = 0; i < 9; ++i) entries.push_back(scaled(i / 3, i % 3) / square);
  return entries;
}

std::vector<RationalQuaternion> rational_rotations(int count) {
  Random random;
  std::vector<RationalQuaternion> rotations;
  for (int i = 0; i < count; ++i) {
    rotations.push_back(random.quaternion());
    if (i % 3 == 2) rotations.back()[0] = rotations.back()[3] = 0;
  }
  return rotations;
}

std::vector<RationalQuaternion> test_rotations(int repeats) {
  Random random;
  std::vector<RationalQuaternion> rotations{{1, 0, 0, 0}};
  for (std::size_t axis = 1; axis <= 3; ++axis) {
    for (const auto& [w, sine] : std::vector<std::pair<cln::cl_RA, cln::cl_RA>>{
             {0, 1}, {1, 1}, {1, -1}, {1, random.rational()}, {1, random.rational()}}) {
      rotations.push_back({w, 0, 0, 0});
      rotations.back()[axis] = sine;
    }
  }
  for (int i = 0; i < repeats; ++i) add_random(rotations, random);
  return rotations;
}

// The orthogonal factor of the polar decomposition by Newton's iteration R <- (R + R^-T) / 2 [Higham86].
std::vector<cln::cl_F> nearest_rotation(std::vector<cln::cl_F> r) {
  for (int step = 0; step < kNewtonSteps; ++step) {
    std::vector<cln::cl_F> cofactors;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto at = [&r](std::size_t row, std::size_t column) { return r[3 * (row % 3) + column % 3]; };
        cofactors.push_back(at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1));
      }
    }
    const cln::cl_F determinant = r[0] * cofactors[0] + r[1] * cofactors[1] + r[2] * cofactors[2];
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (r[i] + cofactors[i] / determinant) / 2;
  }
  return r;
}

}  // namespace sh::codegen
