// The types of real.hpp for which the oracle's templates are compiled, once each.
#pragma once

#include "numeric/oracle/real.hpp"

// INSTANCE(Real): explicit instantiations for one type.
#define SHFORGE_FOR_EACH_REAL(INSTANCE) \
  INSTANCE(float)                       \
  INSTANCE(double)                      \
  INSTANCE(long double)                 \
  INSTANCE(Mpfr50)                      \
  INSTANCE(Mpfr100)                     \
  INSTANCE(MpfrAny)

// The same for the named alternatives of methods/: the types that users compare, and one to check them in.
#define SHFORGE_FOR_EACH_METHOD_REAL(INSTANCE) \
  INSTANCE(float)                              \
  INSTANCE(double)                             \
  INSTANCE(long double)                        \
  INSTANCE(Mpfr50)
