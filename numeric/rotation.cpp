// Instances of rotation.hpp for the types of real.hpp.
#include "numeric/rotation_impl.hpp"

namespace sh::numeric {

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real)                                                    \
  template std::vector<std::vector<Real>> rotation_bands<Real>(int, const Real*); \
  template void rotate<Real>(int, const Real*, const Real*, Real*);
// NOLINTEND(bugprone-macro-parentheses)

SHFORGE_INSTANCE(float)
SHFORGE_INSTANCE(double)
SHFORGE_INSTANCE(long double)
SHFORGE_INSTANCE(Mpfr50)
SHFORGE_INSTANCE(Mpfr100)
SHFORGE_INSTANCE(MpfrAny)

}  // namespace sh::numeric
