// The exact products of functions and where the kernels that compute them are measured; for families/product.cpp.
//
// References come from symbolic::product_form and its relatives at vectors of small rationals, domains are vectors of
// unit length, and errors are counted in machine epsilon times the product of the lengths.
#pragma once

#include <functional>
#include <vector>

#include "codegen/families/family.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::codegen {

Reference product_reference(const symbolic::ProductShape& shape, int count);
Reference square_reference(int degree, int count);
Reference product_zonal_reference(int degree, int count);
Reference triple_reference(int degree, int count);

/// The numbers of coefficients of the factors of a product at a degree.
using FactorSizes = std::function<std::vector<int>(int degree)>;
/// unit: of the error, e.g. "|a| |b|".
Domain factor_domain(const FactorSizes& sizes, const std::string& unit);

}  // namespace sh::codegen
