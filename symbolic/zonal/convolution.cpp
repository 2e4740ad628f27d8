#include "symbolic/zonal/convolution.hpp"

#include <stdexcept>
#include <string>

namespace sh::symbolic {

Surd convolution_factor(int degree) {
  if (degree < 0) {
    throw std::invalid_argument("convolution factor: degree " + std::to_string(degree) + "; it should be 0 or more");
  }
  return Surd::square_root(cln::cl_RA(4) / (2 * degree + 1), 1);
}

std::vector<TurnedZonal> turned_zonal(int degree) {
  require_basis_index(degree, 0);
  std::vector<TurnedZonal> entries;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const BasisFunction& y = basis_function(l, m);
      entries.push_back({l, m, convolution_factor(l) * y.factor, y.homogeneous});
    }
  }
  return entries;
}

}  // namespace sh::symbolic
