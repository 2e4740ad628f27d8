// The exact real constants a kernel may hold.
//
// Today every constant is a surd. Other kinds (roots of integer polynomials, cosines of rational angles) join the
// variant together with their case in each function below; a sum or product that leaves the representable kinds is
// std::nullopt, never an approximation.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "symbolic/surd.hpp"

namespace sh::codegen {

using ExactReal = std::variant<symbolic::Surd>;

/// The value with a relative error below 10^-digits.
cln::cl_F evaluate(const ExactReal& value, int digits);
/// The value itself when it is rational.
std::optional<cln::cl_RA> as_rational(const ExactReal& value);
bool is_negative(const ExactReal& value);
ExactReal negate(const ExactReal& value);
std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b);
std::optional<ExactReal> multiply(const ExactReal& a, const ExactReal& b);
/// For people: "1/2 sqrt(3/pi)".
std::string to_string(const ExactReal& value);

}  // namespace sh::codegen
