#include "codegen/ir/role.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "numeric/oracle/index.hpp"

namespace sh::codegen {
namespace {

// The name of a role, and whether its numbers stand by degree and order, are coefficients, or are coordinates.
struct Traits {
  Role role;
  const char* name;
  bool by_degree_and_order = false;
  bool coefficients = false;
  bool coordinate = false;
};

constexpr Traits kTraits[] = {
    {Role::kDirection, "direction", false, false, true},
    {Role::kVector, "vector", false, false, true},
    {Role::kRotationMatrix, "rotation matrix"},
    {Role::kQuaternion, "quaternion"},
    {Role::kBandMatrices, "band matrices"},
    {Role::kCosine, "cosine"},
    {Role::kSine, "sine"},
    {Role::kCapSize, "cap size"},
    {Role::kParameter, "parameter"},
    {Role::kWeight, "weight"},
    {Role::kColor, "color"},
    {Role::kValue, "value"},
    {Role::kCoefficients, "coefficients", true, true},
    {Role::kEvaluatedCoefficients, "evaluated coefficients", true, true},
    {Role::kIrradiance, "coefficients", true, true},  // the name tells the order of the numbers
    {Role::kLight, "coefficients", true, true},
    {Role::kZonalCoefficients, "zonal coefficients", false, true},
    {Role::kBasisValues, "basis values", true},
    {Role::kBasisGradient, "basis gradient", true, false, true},
    {Role::kMoments, "moments", true},
    {Role::kPolynomial, "polynomial"},
    {Role::kSamples, "sampled function"},
    {Role::kLinearForm, "linear form", true},
    {Role::kQuadraticForm, "quadratic form"},
};

const Traits& traits(Role role) {
  return *std::find_if(std::begin(kTraits), std::end(kTraits), [role](const Traits& t) { return t.role == role; });
}

using numeric::coefficient_count;

std::vector<int> shape_of(Role role) {
  switch (role) {
    case Role::kRotationMatrix:
      return {3, 3};
    case Role::kQuaternion:
    case Role::kLinearForm:
      return {4};
    case Role::kQuadraticForm:
      return {4, 4};
    default:
      return {};
  }
}

}  // namespace

std::string role_name(Role role) { return traits(role).name; }

int Parameter::size() const { return std::accumulate(shape.begin(), shape.end(), 1, std::multiplies<>()); }

int Parameter::channels() const { return is_by_degree_and_order(role) && shape.size() == 2 ? shape.front() : 1; }

Parameter parameter(Role role, std::string name) {
  Parameter made{std::move(name), shape_of(role), role};
  if (role == Role::kLinearForm) made.degree = 1;
  if (role == Role::kQuadraticForm) made.degree = 2;
  return made;
}

Parameter array(Role role, std::string name, int degree, int channels) {
  int size = coefficient_count(degree);
  if (role == Role::kZonalCoefficients) size = degree + 1;
  // 8 n^2 on the rings, two at the poles, two for the correction; a constant has one.
  if (role == Role::kSamples) size = degree == 0 ? 1 : 8 * degree * degree + 4;
  if (role == Role::kBandMatrices) size = (degree + 1) * (2 * degree + 1) * (2 * degree + 3) / 3;
  std::vector<int> shape{size};
  if (channels > 1) shape.insert(shape.begin(), channels);
  return {std::move(name), std::move(shape), role, degree};
}

std::vector<Parameter> with_direction(std::vector<Parameter> before, const std::vector<Parameter>& after, Role role) {
  constexpr const char* kCoordinates[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) before.push_back({kCoordinates[axis], {}, role, -1, axis});
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

bool is_prepared(Role role) {
  return role == Role::kBandMatrices || role == Role::kPolynomial || role == Role::kMoments || role == Role::kSamples;
}

bool is_shared(Role role) { return role == Role::kSamples || role == Role::kLight; }

bool is_by_degree_and_order(Role role) { return traits(role).by_degree_and_order; }

bool holds_coefficients(Role role) { return traits(role).coefficients; }

bool is_coordinate(Role role) { return traits(role).coordinate; }

int total_size(const std::vector<Parameter>& arrays) {
  return std::accumulate(arrays.begin(), arrays.end(), 0, [](int sum, const Parameter& a) { return sum + a.size(); });
}

int position_of(const std::vector<Parameter>& arrays, const std::string& name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Parameter& a) { return a.name == name; });
  return found == arrays.end() ? -1 : static_cast<int>(found - arrays.begin());
}

}  // namespace sh::codegen
