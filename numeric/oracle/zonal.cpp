// Definitions of zonal.hpp, compiled once for the types of real.hpp.
#include "numeric/oracle/zonal.hpp"

#include <stdexcept>
#include <string>

#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {

// For even l: A_l = 2 pi (-1)^(l/2-1) / ((l+2)(l-1)) * l! / (2^l (l/2)!^2), the last factor being the product of
// (k-1)/k over even k up to l.
template <class Real>
Real clamped_cosine_factor(int l) {
  if (l < 0) throw std::invalid_argument("clamped_cosine_factor: degree is " + std::to_string(l) + ", must be >= 0");
  if (l == 1) return 2 * pi<Real>() / 3;
  if (l % 2 == 1) return Real(0);
  const long first = (l + 2L) * (l - 1L);
  Real factor = -2 * pi<Real>() / static_cast<Real>(first);
  for (int k = 2; k <= l; k += 2) factor = -factor * static_cast<Real>(k - 1) / static_cast<Real>(k);
  return factor;
}

// NOLINTNEXTLINE(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real) template Real clamped_cosine_factor<Real>(int);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
