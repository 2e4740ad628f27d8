// The exact references and the domains of the product families.
//
// The references evaluate symbolic::product_form and its variants at vectors of small rationals. The domains are
// vectors of unit length. The unit of errors is machine epsilon times the product of the lengths.
#pragma once

#include "codegen/families/exact.hpp"
#include "symbolic/product/product_form.hpp"

namespace sh::codegen {

/// The exact outputs of each product family at some points.
Reference product_reference(const symbolic::ProductShape& shape, int points);
Reference square_reference(int degree, int points);
Reference product_zonal_reference(int degree, int points);
Reference triple_reference(int degree, int points);

/// The number of coefficients of each factor of a product, for a degree.
using FactorSizes = std::function<std::vector<int>(int degree)>;
/// The domain of factors of these sizes. unit: the unit of the error, e.g. "|a| |b|".
Domain factor_domain(const FactorSizes& sizes, const std::string& unit);

}  // namespace sh::codegen
