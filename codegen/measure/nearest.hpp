// The point of a kernel's domain that rounded inputs stand for, from the roles of its parameters.
//
// Directions and quaternions are scaled to length 1, a cosine and its sine to the unit circle, a matrix becomes the
// nearest rotation. Other inputs are in the domain as they are.
#pragma once

#include <cln/float.h>

#include <string>
#include <vector>

#include "codegen/ir/role.hpp"

namespace sh::codegen {

/// inputs: flattened parameters.
std::vector<cln::cl_F> nearest_in_domain(const std::vector<Parameter>& parameters, std::vector<cln::cl_F> inputs);

/// For people: "the direction scaled to length 1"; empty where all inputs are in the domain.
std::string nearest_point(const std::vector<Parameter>& parameters);

}  // namespace sh::codegen
