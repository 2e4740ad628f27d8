// The table of legendre_methods.hpp.
#include "numeric/methods/legendre_methods.hpp"

#include <array>

#include "numeric/methods/legendre_rows.hpp"

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

template std::span<const LegendreMethod<float>> legendre_methods();
template std::span<const LegendreMethod<double>> legendre_methods();
template std::span<const LegendreMethod<Mpfr50>> legendre_methods();

}  // namespace sh::numeric
