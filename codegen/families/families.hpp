// Every family of kernels: its recipes, its exact reference, where it is measured. A family is a file of this folder (a
// few that share their mathematics share one) and a line of families.def.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

#define FAMILY(name) Family name##_family();
#include "codegen/families/families.def"
#undef FAMILY

/// All families of families.def, in its order.
const std::vector<Family>& families();

/// Factors of these degrees, projected on one degree; its recipes serve this shape only. Throws std::invalid_argument,
/// one line, unless 0 <= left_degree, right_degree <= symbolic::kMaxProductDegree and 0 <= degree <= their sum.
Family rectangular_product_family(int left_degree, int right_degree, int degree);

}  // namespace sh::codegen
