// Instances of legendre_values.hpp for the types of real.hpp.
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/legendre_values_impl.hpp"

namespace sh::numeric {

#define SHFORGE_INSTANCE(Real)                                                      \
  template void legendre_row<Real>(int, const Real&, const Real&, Real*);           \
  template void legendre_row<Real>(int, const Real&, const Real&, std::span<Real>); \
  template void legendre_column<Real>(int, int, const Real&, const Real&, Real*);   \
  template Real legendre_value<Real>(int, int, const Real&, const Real&);           \
  template void legendre_amplitude<Real>(int, const Real&, const Real*, Real*);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
