#include "symbolic/zonal/window.hpp"

#include "symbolic/basis/basis.hpp"

namespace sh::symbolic {

// Re and Im of (c + i s)^l: c and s stand in place of x and y.
Polynomial window_hann(int degree) {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  return Polynomial(half) + half * reduced_basis_function(degree, degree).azimuthal;
}

Polynomial window_lanczos_sine(int degree) {
  return degree == 0 ? Polynomial() : reduced_basis_function(degree, -degree).azimuthal;
}

int window_gaussian_exponent(int degree) { return degree * degree; }

cln::cl_RA window_laplacian_penalty(int degree) {
  const cln::cl_RA eigenvalue = degree * (degree + 1);
  return eigenvalue * eigenvalue;
}

}  // namespace sh::symbolic
