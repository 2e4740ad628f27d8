#include "symbolic/basis/normalisation.hpp"

#include <cln/integer.h>

#include <cstdlib>

#include "symbolic/number/remembered.hpp"

namespace sh::symbolic {

cln::cl_RA squared_factor(int degree, int order) {
  const int a = std::abs(order);
  const cln::cl_I below = cln::factorial(static_cast<unsigned>(degree - a));
  const cln::cl_I above = cln::factorial(static_cast<unsigned>(degree + a));
  return (order == 0 ? 1 : 2) * (2 * degree + 1) * (below / cln::cl_RA(above));
}

const Surd& orthonormal_factor(int degree, int order) {
  static std::map<std::pair<int, int>, Surd> known;
  return remembered(known, {degree, std::abs(order)},
                    [&] { return Surd::square_root(squared_factor(degree, order) / 4, -1); });
}

Surd factor_ratio(int degree, int row_order, int column_order) {
  return Surd::square_root(squared_factor(degree, row_order) / squared_factor(degree, column_order));
}

}  // namespace sh::symbolic
