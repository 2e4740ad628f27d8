// Why a coefficient differs from what a convention expects, in words.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "numeric/identify/identify.hpp"

namespace sh::numeric::identify {

// [function][row]: what the convention expects where `samples` has values.
using Columns = std::vector<std::vector<std::complex<double>>>;
Columns expected_columns(const Samples& samples, const Convention& convention);

// Of a coefficient whose ratio and shape are known: its sign, another coefficient's function, the conjugate, a factor
// (2, sqrt 2, ...; a rounded or mistyped constant), single lines, or else the functions that it is a sum of.
std::string reason_of(const Samples& samples, const Convention& convention, const Columns& expected,
                      const Coefficient& coefficient);

// "constant 0.282 for 0.2820948, rounded to 3 digits" where the constant in front of the polynomial of lowest integers
// (1.092548 in 1.092548 xy) is the right one to 2 .. 8 digits, rounded or cut off; else "".
std::string rounding_of(const Convention& convention, const Coefficient& coefficient);

}  // namespace sh::numeric::identify
