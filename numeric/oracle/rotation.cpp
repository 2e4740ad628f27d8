// Instances of rotation.hpp for the types of real.hpp.
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/rotation_impl.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                                    \
  template std::vector<std::vector<Real>> rotation_bands<Real>(int, const Real*); \
  template void rotate<Real>(int, const Real*, const Real*, Real*);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
