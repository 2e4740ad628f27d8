// Instances of zonal.hpp for the types of real.hpp.
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/zonal_impl.hpp"

namespace sh::numeric {

// NOLINTNEXTLINE(bugprone-macro-parentheses): a type cannot stand in parentheses.
#define SHFORGE_INSTANCE(Real) template Real clamped_cosine_factor<Real>(int);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
