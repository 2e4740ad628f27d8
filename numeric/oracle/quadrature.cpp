// Instances of quadrature.hpp for the types of real.hpp.
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/quadrature_impl.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                \
  template GaussLegendreRule<Real> gauss_legendre<Real>(int); \
  template std::vector<SphereNode<Real>> sphere_rule<Real>(int);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
