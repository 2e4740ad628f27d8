// See zonal.hpp.
#include "numeric/oracle/zonal.hpp"

#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {

// For even l: A_l = 2 pi (-1)^(l/2-1) / ((l+2)(l-1)) * l! / (2^l (l/2)!^2), the last factor being the product of
// (k-1)/k over even k up to l.
template <class Real>
Real clamped_cosine_factor(int l) {
  require_range("clamped_cosine_factor: degree", l, 0);
  if (l == 1) return 2 * pi<Real>() / 3;
  if (l % 2 == 1) return Real(0);
  const long first = (l + 2L) * (l - 1L);
  Real factor = -2 * pi<Real>() / static_cast<Real>(first);
  for (int k = 2; k <= l; k += 2) factor = -factor * static_cast<Real>(k - 1) / static_cast<Real>(k);
  return factor;
}

#define SHFORGE_INSTANCE(Real) template Real clamped_cosine_factor<Real>(int);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
