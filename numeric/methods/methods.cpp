// The tables of methods.hpp.
#include "numeric/methods/methods.hpp"

#include <array>

#include "numeric/methods/legendre_rows.hpp"
#include "numeric/methods/zxz_rows.hpp"
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric {

template <class Real>
std::span<const LegendreMethod<Real>> legendre_methods() {
  static constexpr std::array<LegendreMethod<Real>, 9> kMethods{{
      {"factorials", "Green 2003, Numerical Recipes", legendre_green<Real>},
      {"column times power", "Sloan 2013", legendre_sloan<Real>},
      {"forward column", "Holmes & Featherstone 2002", legendre_forward_column<Real>},
      {"modified forward column", "Holmes & Featherstone 2002", legendre_modified_column<Real>},
      {"modified forward row", "Libbrecht 1985", legendre_modified_row<Real>},
      {"four-term", "Swarztrauber 1993", legendre_swarztrauber<Real>},
      {"X-number column", "Fukushima 2012", legendre_x_numbers<Real>},
      {"two-step column", "Ishioka 2018", legendre_ishioka<Real>},
      {"scaled rows", "the oracle", legendre_scaled_rows<Real>},
  }};
  return kMethods;
}

template <class Real>
std::span<const RotationMethod<Real>> rotation_methods() {
  using Method = RotationMethod<Real>;
  static constexpr std::array kMethods = {
      Method{"ivanic_ruedenberg", "Ivanic, Ruedenberg 1996 and 1998", rotate<Real>},
      Method{"choi", "Choi, Ivanic, Gordon, Ruedenberg 1999", methods::rotate_choi<Real>},
      Method{"blanco", "Blanco, Florez, Bermejo 1997, eqs. 64-68", methods::rotate_blanco<Real>},
      Method{"wigner_d", "Blanco, Florez, Bermejo 1997, eq. 64, from scaled starts", methods::rotate_wigner_d<Real>},
      Method{"pinchon_hoggan", "Pinchon, Hoggan 2007", methods::rotate_pinchon_hoggan<Real>},
      Method{"zxz", "Trapani, Navaza 2006", methods::rotate_zxz<Real>},
      Method{"zxz_rows", "Trapani, Navaza 2006, rows made while they are used", methods::rotate_zxz_rows<Real>}};
  return kMethods;
}

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

#define SHFORGE_INSTANCE(Real)                                       \
  template std::span<const LegendreMethod<Real>> legendre_methods(); \
  template std::span<const ZonalMethod<Real>> zonal_methods();

SHFORGE_INSTANCE(float)
SHFORGE_INSTANCE(double)
SHFORGE_INSTANCE(Mpfr50)

#define SHFORGE_ROTATION_INSTANCE(Real) template std::span<const RotationMethod<Real>> rotation_methods();

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_ROTATION_INSTANCE)

}  // namespace sh::numeric
