// Putting polynomials in for variables, and the normal form of a polynomial on the unit sphere.
#pragma once

#include <span>

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// p with values[i] in place of variable i. Throws std::invalid_argument when a variable of p has no value.
Polynomial substitute(const Polynomial& p, std::span<const Polynomial> values);

/// The one polynomial of degree at most 1 in x that equals p wherever x^2+y^2+z^2 = 1 (variables 0, 1, 2 are x, y, z):
/// every x^2 becomes 1 - y^2 - z^2. Two polynomials agree on the sphere exactly when their normal forms are equal.
Polynomial reduce_on_sphere(const Polynomial& p);

}  // namespace sh::symbolic
