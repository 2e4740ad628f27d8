// Rotation of coefficients: by a matrix, by a quaternion, about z; matrices built once and applied; the value of a
// rotated function.
#include "codegen/recipes/rotation/rotation.hpp"

#include <cln/real.h>

#include <cmath>
#include <numbers>

#include "codegen/families/families.hpp"
#include "codegen/families/rotation_inputs.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/rotations.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::codegen {
namespace {

constexpr int kLargestDegree = 10;
constexpr const char* kTurnedVectors = "turned unit vectors (random, axes, half turns, tilts from 2^-99 to pi)";
constexpr const char* kTurns = "rotations (random, axes, half turns, tilts from 2^-99 to pi)";

}  // namespace

Family rotate_family() {
  return {
      .name = "rotate",
      .largest_emitted = kLargestDegree,
      .recipes = {{"zxz", recipes::rotate_zxz, 0, kLargestDegree},
                  {"dense", recipes::rotate_dense, 2, 8},
                  {"recursive", recipes::rotate_recursive, 2, 3}},
      .reference = rotate_reference,
      .domain = {.inputs = kTurnedVectors, .unit = "|c|", .test_inputs = rotate_inputs, .sizes = {"|c|"}},
      .batch = BatchDriver{.what = "Coefficients of rotated functions, by rotation matrices"},
  };
}

Family rotate_quaternion_family() {
  return {
      .name = "rotate_quaternion",
      .largest_emitted = kLargestDegree,
      .recipes = {{"zxz", recipes::rotate_quaternion_zxz, 2, kLargestDegree},
                  {"polynomial", recipes::rotate_quaternion_polynomial, 0, 8}},
      .reference = rotate_quaternion_reference,
      .domain = {.inputs = kTurnedVectors, .unit = "|c|", .test_inputs = rotate_quaternion_inputs, .sizes = {"|c|"}},
  };
}

Family rotate_z_family() {
  return {
      .name = "rotate_z",
      .recipes = {{"steps", recipes::rotate_z_steps}, {"products", recipes::rotate_z_products, 2}},
      .reference = rotate_z_reference,
      .domain = {.inputs = "unit vectors turned about z (random angles, quarter turns, angles from 2^-99)",
                 .unit = "|c|",
                 .test_inputs = rotate_z_inputs,
                 .sizes = {"|c|"}},
  };
}

Family rotate_build_family() {
  return {
      .name = "rotate_build",
      .largest_emitted = kLargestDegree,
      .recipes = {{"dense", recipes::rotate_build_dense, 0, kLargestDegree},
                  {"recursive", recipes::rotate_build_recursive, 2, 5}},
      .reference = rotate_build_reference,
      .domain = {.inputs = kTurns, .unit = "1", .test_inputs = rotate_build_inputs, .sizes = {"1"}},
  };
}

Family rotate_apply_family() {
  return {
      .name = "rotate_apply",
      .largest_emitted = kLargestDegree,
      .recipes = {{"rows", recipes::rotate_apply_rows, 0, kLargestDegree}},
      .reference = rotate_apply_reference,
      .domain = {.inputs = "random unit vectors and matrices with rows of length 1",
                 .unit = "|c|",
                 .test_inputs = rotate_apply_inputs,
                 .sizes = {"|c|"}},
  };
}

Family rotate_evaluate_family() {
  return {
      .name = "rotate_evaluate",
      .largest_emitted = kLargestDegree,
      .recipes = {{"turned", recipes::rotate_evaluate_turned, 0, kLargestDegree}},
      .reference = rotate_evaluate_reference,
      .domain = {.inputs = "turned unit vectors in random directions",
                 .unit = "|c| (degree+1) / sqrt(4 pi)",
                 .test_inputs = rotate_evaluate_inputs,
                 .sizes = {"|c| Y(0..L)"}},
  };
}

}  // namespace sh::codegen
