// Instances of wigner.hpp for the types of real.hpp.
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/wigner_impl.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                        \
  template Wigner3jRow<Real> wigner_3j_row<Real>(int, int, int, int); \
  template Real wigner_3j<Real>(const Triple&, const Triple&);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
