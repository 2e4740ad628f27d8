// See rotation_methods.hpp.
#include "numeric/methods/rotation_methods.hpp"

#include <array>

#include "numeric/methods/zxz_rows.hpp"
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/rotation.hpp"

namespace sh::numeric {

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

#define SHFORGE_INSTANCE(Real) template std::span<const RotationMethod<Real>> rotation_methods<Real>();

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
