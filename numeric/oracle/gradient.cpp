// Instances of gradient.hpp for the types of real.hpp.
#include "numeric/oracle/gradient_impl.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                                                                \
  template void basis_gradient<Real>(int, const Real&, const Real&, const Real&, Real*, Real*, Real*, Real*); \
  template std::array<Real, 3> basis_value_gradient<Real>(int, int, const Real&, const Real&, const Real&);   \
  template void basis_tangent_gradient<Real>(int, const Real&, const Real&, const Real&, Real*, Real*, Real*, Real*);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
