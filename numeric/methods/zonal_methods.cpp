// See zonal_methods.hpp.
#include "numeric/methods/zonal_methods.hpp"

#include <array>

#include "numeric/oracle/cap.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {

template <class Real>
std::span<const ZonalMethod<Real>> zonal_methods() {
  static constexpr std::array<ZonalMethod<Real>, 4> kMethods{
      {{"closed form", "P_(l-1) - P_(l+1) at cos, Hobson 1931", cap_zonal_closed_form<Real>},
       {"closed form in differences", "P_k - P_(k-1) as unknowns, in 1 - cos", cap_zonal_differences<Real>},
       {"quadrature", "Gauss-Legendre over the cap", cap_zonal_quadrature<Real>},
       {"recurrence in 1 - cos", "P_l' by the derivative of Bonnet's recurrence, in differences",
        [](int degree, const Real& one_minus_cos, Real* out) { cap_zonal(degree, one_minus_cos, out); }}}};
  return kMethods;
}

template std::span<const ZonalMethod<float>> zonal_methods();
template std::span<const ZonalMethod<double>> zonal_methods();
template std::span<const ZonalMethod<Mpfr50>> zonal_methods();

}  // namespace sh::numeric
