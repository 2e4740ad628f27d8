// All families of kernels. A family is a file of this folder and a line of families.def; families that share their
// mathematics may share a file.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

#define FAMILY(name) Family name##_family();
#include "codegen/families/families.def"
#undef FAMILY

/// All families of families.def, in its order.
const std::vector<Family>& families();

/// The product of factors of these degrees, projected on bands 0 .. degree. Its recipes serve this shape only. Throws
/// std::invalid_argument, one line, unless 0 <= left_degree, right_degree <= symbolic::kMaxProductDegree and
/// 0 <= degree <= left_degree + right_degree.
Family rectangular_product_family(int left_degree, int right_degree, int degree);

}  // namespace sh::codegen
