// Shared by the methods of three turns: turns about z from a matrix without loss of digits, multiples, application.
//
// R = Rz(alpha) Ry(beta) Rz(gamma). A turn is the pair (cosine, sine) of its angle; no angle is ever formed. Both come
// from the quaternion of the nearest rotation, w + iz = cos(beta/2) e^(i sum), y - ix = sin(beta/2) e^(i difference)
// with sum, difference = (alpha +- gamma) / 2 [Diebel06], so sin(beta) is not the root of 1 - cos^2(beta): a rotation
// within 1e-300 of the identity or of a half turn keeps its digits, and at beta = 0 or pi exactly the turn that is
// then free is taken as none. In float and double this is done with a longer mantissa: angles are multiplied by
// orders up to the degree, and so would be their rounding.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"

namespace sh::numeric::methods {

template <class Real>
struct Turn {
  Real cosine, sine;
};

/// a after b, and the difference of the two.
template <class Real>
Turn<Real> operator+(const Turn<Real>& a, const Turn<Real>& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}
template <class Real>
Turn<Real> operator-(const Turn<Real>& a, const Turn<Real>& b) {
  return a + Turn<Real>{b.cosine, -b.sine};
}

template <class Real>
struct ThreeTurns {
  Turn<Real> alpha, half_beta, gamma;  // 0 <= beta <= pi
};

/// The type in which angles of a Real are kept.
template <class Real>
using Longer = std::conditional_t<std::is_same_v<Real, float>, double,
                                  std::conditional_t<std::is_same_v<Real, double>, long double, Real>>;

/// (x, y) scaled to length 1, and the length; of the zero vector no turn.
template <class Real>
Turn<Real> direction_of(const Real& x, const Real& y, Real& length) {
  using std::hypot;
  length = hypot(x, y);
  if (length == 0) return {1, 0};
  return {x / length, y / length};
}

/// r (3x3), orthogonal with determinant 1 up to rounding.
template <class Real>
ThreeTurns<Longer<Real>> three_turns(const Real* r) {
  using Wide = Longer<Real>;
  const auto nearest = nearest_rotation<Wide>(r);
  std::array<Wide, 4> q;
  quaternion_of_matrix(nearest.data(), q.data());
  Turn<Wide> half_beta;
  const Turn<Wide> sum = direction_of<Wide>(q[0], q[3], half_beta.cosine);
  const Turn<Wide> difference = direction_of<Wide>(q[2], -q[1], half_beta.sine);
  return {sum + difference, half_beta, sum - difference};
}

/// The turns by 0, 1 .. count times the angle of `turn`.
template <class Real, class Wide>
std::vector<Turn<Real>> multiples(const Turn<Wide>& turn, int count) {
  std::vector<Turn<Real>> all;
  Turn<Wide> current{1, 0};
  for (int m = 0; m <= count; ++m) {
    all.push_back({static_cast<Real>(current.cosine), static_cast<Real>(current.sine)});
    current = current + turn;
  }
  return all;
}

/// out = D(Rz) c on the band l, c and out (2l+1) at order 0; multiples of the turn up to l. out may be c.
template <class Real>
void turn_band(int l, const std::vector<Turn<Real>>& turns, const Real* c, Real* out) {
  out[0] = c[0];
  for (int m = 1; m <= l; ++m) {
    const Turn<Real>& t = turns[m];
    const Real cosine_part = c[m], sine_part = c[-m];
    out[m] = t.cosine * cosine_part - t.sine * sine_part;
    out[-m] = t.sine * cosine_part + t.cosine * sine_part;
  }
}

/// The same for every band, c and out (bands^2).
template <class Real, class Wide>
void turn_about_z(int degree, const Turn<Wide>& turn, const Real* c, Real* out) {
  const auto turns = multiples<Real>(turn, degree);
  for (int l = 0; l <= degree; ++l) turn_band(l, turns, c + coefficient_index(l, 0), out + coefficient_index(l, 0));
}

/// out = D(r) c as three turns; tilt(half_beta, in, out) is to do D(Ry(beta)), in and out (bands^2) apart.
template <class Real, class Tilt>
void rotate_by_turns(int degree, const Real* r, const Real* c, Real* out, const Tilt& tilt) {
  const auto turns = three_turns(r);
  std::vector<Real> before(coefficient_count(degree));
  std::vector<Real> after(before.size());
  turn_about_z(degree, turns.gamma, c, before.data());
  tilt(turns.half_beta, before.data(), after.data());
  turn_about_z(degree, turns.alpha, after.data(), out);
}

/// Adds a pair of Wigner's d to D(Ry(beta)) c: the entries of rows and columns +-p and +-q, p >= q >= 0, of one band,
/// from `same` = d^l_pq and `opposite` = d^l_(p,-q) [BlancoFlorezBermejo97, the real form at alpha = gamma = 0].
/// in and out at order 0 of the band; adds to out.
template <class Real>
void add_tilt(int p, int q, const Real& same, const Real& opposite, const Real* in, Real* out) {
  using std::sqrt;
  if (p == 0) {
    out[0] += same * in[0];
    return;
  }
  const Real sign = (p - q) % 2 == 0 ? 1 : -1;  // from row q, column p to row p, column q
  if (q == 0) {
    const Real cosine = sqrt(Real(2)) * same;
    out[0] += cosine * in[p];
    out[p] += sign * cosine * in[0];
    return;
  }
  const Real mirrored = q % 2 == 0 ? opposite : -opposite;
  const Real cosine = same + mirrored, sine = same - mirrored;
  out[q] += cosine * in[p];
  out[-q] += sine * in[-p];
  if (p == q) return;
  out[p] += sign * cosine * in[q];
  out[-p] += sign * sine * in[-q];
}

}  // namespace sh::numeric::methods
