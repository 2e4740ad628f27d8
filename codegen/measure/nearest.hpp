// The point of a kernel's domain that rounded inputs represent. The roles of the parameters determine it.
//
// Directions and quaternions are scaled to length 1. A cosine and its sine are scaled to the unit circle. A matrix
// becomes the nearest rotation. All other inputs already lie in the domain.
#pragma once

#include <cln/float.h>

#include <string>
#include <vector>

#include "codegen/ir/role.hpp"

namespace sh::codegen {

/// inputs: flattened parameters.
std::vector<cln::cl_F> nearest_in_domain(const std::vector<Parameter>& parameters, std::vector<cln::cl_F> inputs);

/// A description: "the direction scaled to length 1"; empty if all inputs already lie in the domain.
std::string nearest_point(const std::vector<Parameter>& parameters);

}  // namespace sh::codegen
