// Instances of cap.hpp for the types of real.hpp.
#include "numeric/oracle/cap_impl.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                                                                 \
  template void cap_zonal<Real>(int, const Real&, Real*, CapScale);                                            \
  template void cap_zonal_closed_form<Real>(int, const Real&, Real*);                                          \
  template void cap_zonal_differences<Real>(int, const Real&, Real*);                                          \
  template void cap_zonal_quadrature<Real>(int, const Real&, Real*);                                           \
  template void zonal_quadrature<Real>(int, const std::function<Real(const Real&)>&, const Real&, const Real&, \
                                       const GaussLegendreRule<Real>&, Real*);                                 \
  template Real one_minus_cos<Real>(const Real&);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
