// cap(one_minus_cos) -> zonal; zonal(zonal, d) -> out; add_cap and add_cap_rgb (d, one_minus_cos, color, sum in
// place). Against quadrature over the cap and the oracle's basis in the direction of the light.
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/cap.hpp"

namespace sh::numeric {
namespace {

// out (bands^2): the zonal function z_0, z_1, ... turned from +z to the unit direction d.
template <class Real>
void turned_zonal(int degree, const Real* zonal, const Real* d, Real* out) {
  using std::sqrt;
  basis(degree, d[0], d[1], d[2], out);
  for (int l = 0; l <= degree; ++l) {
    const Real factor = sqrt(Real(4 * pi<Real>() / static_cast<Real>(2 * l + 1))) * zonal[l];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
  }
}

// x, y, z, one_minus_cos, one value a channel, sum (channels, bands^2)
auto light(int channels) {
  return [channels](int degree, const auto* in, auto* out) {
    using Real = std::remove_cvref_t<decltype(*in)>;
    std::vector<Real> zonal(static_cast<std::size_t>(degree) + 1);
    cap_zonal_quadrature(degree, in[3], zonal.data());
    std::vector<Real> turned(coefficient_count(degree));
    turned_zonal(degree, zonal.data(), in, turned.data());
    const Real* sum = in + 4 + channels;
    for (int channel = 0; channel < channels; ++channel) {
      for (const Real& value : turned) *out++ = *sum++ + in[4 + channel] * value;
    }
  };
}

}  // namespace

std::vector<ExactFamily> exact_zonal() {
  return {{"cap", [](int degree, const auto* in, auto* out) { cap_zonal_quadrature(degree, in[0], out); }},
          {"zonal", [](int degree, const auto* in, auto* out) { turned_zonal(degree, in, in + degree + 1, out); }},
          {"add_cap", light(1)},
          {"add_cap_rgb", light(3)}};
}

}  // namespace sh::numeric
