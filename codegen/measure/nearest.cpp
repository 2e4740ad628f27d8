#include "codegen/measure/nearest.hpp"

#include <cln/real.h>

#include <algorithm>

#include "codegen/measure/rotations.hpp"

namespace sh::codegen {
namespace {

using Iterator = std::vector<cln::cl_F>::iterator;

void scale_to_length_one(Iterator first, std::size_t size) {
  cln::cl_F square = first[0] * first[0];
  for (std::size_t i = 1; i < size; ++i) square = square + first[static_cast<long>(i)] * first[static_cast<long>(i)];
  const cln::cl_F length = cln::sqrt(square);
  std::for_each(first, first + static_cast<long>(size), [&](cln::cl_F& value) { value = value / length; });
}

void move_to_domain(const Parameter& parameter, Iterator first) {
  switch (parameter.role) {
    case Role::kDirection:
      if (parameter.axis == 0) scale_to_length_one(first, 3);
      break;
    case Role::kQuaternion:
      scale_to_length_one(first, 4);
      break;
    case Role::kCosine:  // its sine follows
      scale_to_length_one(first, 2);
      break;
    case Role::kRotationMatrix: {
      const std::vector<cln::cl_F> nearest = nearest_rotation({first, first + parameter.size()});
      std::copy(nearest.begin(), nearest.end(), first);
      break;
    }
    default:
      break;
  }
}

}  // namespace

std::vector<cln::cl_F> nearest_in_domain(const std::vector<Parameter>& parameters, std::vector<cln::cl_F> inputs) {
  auto first = inputs.begin();
  for (const Parameter& parameter : parameters) {
    move_to_domain(parameter, first);
    first += parameter.size();
  }
  return inputs;
}

std::string nearest_point(const std::vector<Parameter>& parameters) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
  for (const Parameter& parameter : parameters) {
    if (parameter.role == Role::kDirection && parameter.axis == 0) {
      add(parameters.size() == 3 ? "the input scaled to length 1" : "the direction scaled to length 1");
    }
    if (parameter.role == Role::kQuaternion) add("the quaternion scaled to length 1");
    if (parameter.role == Role::kCosine) add("cosine and sine scaled to the unit circle");
    if (parameter.role == Role::kRotationMatrix) add("the nearest rotation matrix");
  }
  return text;
}

}  // namespace sh::codegen
