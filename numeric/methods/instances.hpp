// The types for which the named alternatives are compiled: those that users compare, and one to check them in.
#pragma once

#include "numeric/oracle/real.hpp"

// INSTANCE(Real): explicit instantiations for one type.
#define SHFORGE_FOR_EACH_METHOD_REAL(INSTANCE) \
  INSTANCE(float)                              \
  INSTANCE(double)                             \
  INSTANCE(long double)                        \
  INSTANCE(Mpfr50)
