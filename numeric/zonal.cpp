// Instances of zonal.hpp for the types of real.hpp.
#include "numeric/zonal_impl.hpp"

namespace sh::numeric {

template float clamped_cosine_factor<float>(int);
template double clamped_cosine_factor<double>(int);
template long double clamped_cosine_factor<long double>(int);
template Mpfr50 clamped_cosine_factor<Mpfr50>(int);
template Mpfr100 clamped_cosine_factor<Mpfr100>(int);
template MpfrAny clamped_cosine_factor<MpfrAny>(int);

}  // namespace sh::numeric
