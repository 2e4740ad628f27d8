// Instances of basis.hpp for the types of real.hpp: multiprecision templates compile here, once.
#include "numeric/oracle/basis_impl.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric {

#define SHFORGE_INSTANCE(Real)                                                            \
  template void basis<Real>(int, const Real&, const Real&, const Real&, Real*);           \
  template void basis<Real>(int, const Real&, const Real&, const Real&, std::span<Real>); \
  template std::vector<Real> basis<Real>(int, const Real&, const Real&, const Real&);     \
  template void basis_z_form<Real>(int, const Real&, const Real&, const Real&, Real*);    \
  template Real basis_value<Real>(int, int, const Real&, const Real&, const Real&);       \
  template std::array<Real, 3> normalised<Real>(const Real&, const Real&, const Real&);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
