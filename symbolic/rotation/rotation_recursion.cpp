#include "symbolic/rotation/rotation_recursion.hpp"

#include <cstdlib>

#include "symbolic/basis/normalisation.hpp"

namespace sh::symbolic {
cln::cl_RA column_scale(int degree, int column) {
  const int a = std::abs(column);
  const cln::cl_RA inverse_g = a == degree ? cln::cl_RA(2 * degree - 1) : cln::cl_RA(2 * degree - 1) / (degree - a);
  return squared_factor(degree, a) / squared_factor(degree - 1, a == degree ? a - 1 : a) * inverse_g;
}

void require_recursion_degree(int degree, int limit) {
  if (degree < 0 || degree > limit) {
    throw std::invalid_argument("rotation recursion: degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(limit) + " (exact entries grow with the degree)");
  }
}

}  // namespace sh::symbolic
