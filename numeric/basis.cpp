// Instances of basis.hpp for the types of real.hpp: multiprecision templates compile here, once.
#include "numeric/basis_impl.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                                            \
  template void basis<Real>(int, const Real&, const Real&, const Real&, Real*);           \
  template void basis<Real>(int, const Real&, const Real&, const Real&, std::span<Real>); \
  template std::vector<Real> basis<Real>(int, const Real&, const Real&, const Real&);     \
  template void basis_z_form<Real>(int, const Real&, const Real&, const Real&, Real*);    \
  template Real basis_value<Real>(int, int, const Real&, const Real&, const Real&);       \
  template std::array<Real, 3> normalised<Real>(const Real&, const Real&, const Real&);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_INSTANCE(float)
SHFORGE_INSTANCE(double)
SHFORGE_INSTANCE(long double)
SHFORGE_INSTANCE(Mpfr50)
SHFORGE_INSTANCE(Mpfr100)
SHFORGE_INSTANCE(MpfrAny)

}  // namespace sh::numeric
