// Exact integrals of polynomials in x, y, z over the unit sphere.
//
// integral x^a y^b z^c = 4 pi (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!! for even a, b, c, otherwise zero
// [Folland01].
#pragma once

#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {

/// The mean of p over the unit sphere, that is its integral divided by 4 pi; variables 0, 1, 2 are x, y, z.
cln::cl_RA sphere_mean(const Polynomial& p);

}  // namespace sh::symbolic
