// Brown 2004: real rotation matrices from complex ones, his replacement of eqs. 8.8 to 8.14 of Choi et al.
//
// F and G are not defined on the page; the readings are the ways to take them from D_mn = exp(-i m alpha) d_mn(beta)
// exp(-i n gamma), Condon-Shortley, which is what the recursion of that paper gives (CH-01).
#include "symbolic/convention/complex_basis.hpp"
#include "symbolic/errata/brown_parts.hpp"
#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {
namespace {

using Band = Matrix<RadicalSum>;

RadicalSum halved(const RadicalSum& sum) { return root(ratio(1, 2)) * sum; }
RadicalSum signed_by(int m, const RadicalSum& number) { return scaled(cln::cl_RA(parity(m)), number); }

// S and T of a band, from F = Re D and G = Im D.
class Halves {
 public:
  explicit Halves(const Band& d) : f_(real_part(d)), g_(imaginary_part(d)) {}
  [[nodiscard]] RadicalSum s(int m, int n) const {
    if (m > 0) return halved(f(-m, n) + signed_by(m, f(m, n)));
    if (m == 0) return f(m, n);
    return halved(g(m, n) - signed_by(m, g(-m, n)));
  }
  [[nodiscard]] RadicalSum t(int m, int n) const {
    if (m > 0) return halved(g(-m, n) + signed_by(m, g(m, n)));
    if (m == 0) return g(m, n);
    return halved(-f(m, n) + signed_by(m, f(-m, n)));
  }

 private:
  [[nodiscard]] RadicalSum f(int m, int n) const { return entry_or_zero(f_, m, n); }
  [[nodiscard]] RadicalSum g(int m, int n) const { return entry_or_zero(g_, m, n); }
  Band f_;
  Band g_;
};

Band brown_real_band(const Band& d) {
  const int l = d.rows() / 2;
  const Halves h(d);
  Band r(2 * l + 1, 2 * l + 1);
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      RadicalSum& entry = r(l + m, l + n);
      if (n > 0) entry = halved(h.s(m, -n) + signed_by(n, h.s(m, n)));
      if (n == 0) entry = h.s(m, n);
      if (n < 0) entry = halved(-h.t(m, n) + signed_by(n, h.t(m, -n)));
    }
  }
  return r;
}

// prepare(D) -> the band that is taken for F + i G.
template <class Prepare>
bool gives(const Prepare& prepare, bool inverse) {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 1; l <= kHighestBand; ++l) {
      const Band r = brown_real_band(prepare(rotation.complex[to_size(l)]));
      const Band& expected = rotation.real[to_size(l)];
      if (!(r == (inverse ? expected.transposed() : expected))) return false;
    }
  }
  return true;
}

Band unchanged(const Band& d) { return d; }
Band transposed(const Band& d) { return d.transposed(); }

// D for functions without the Condon-Shortley phase.
Band without_phase(const Band& d) {
  const int l = d.rows() / 2;
  Band result = d;
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      result(l + m, l + n) = signed_by((m > 0 ? m : 0) + (n > 0 ? n : 0), d(l + m, l + n));
    }
  }
  return result;
}

bool from_d() { return gives(unchanged, false); }
bool from_adjoint() { return gives(adjoint, true); }
bool from_conjugate() { return gives(conjugate, false) || gives(conjugate, true); }
bool from_transposed() { return gives(transposed, false) || gives(transposed, true); }
bool from_phaseless() { return gives(without_phase, false) || gives(without_phase, true); }

// R = W D W*, W = of(Y_real = W Y_complex).
template <class Of>
bool product_gives(const Of& of) {
  for (const ExactRotation& rotation : sample_rotations()) {
    for (int l = 0; l <= kHighestBand; ++l) {
      const Band w = of(real_from_complex(l, true));
      if (!(w * rotation.complex[to_size(l)] * adjoint(w) == rotation.real[to_size(l)])) return false;
    }
  }
  return true;
}

bool product_for_coefficients() { return product_gives(conjugate); }
bool product_for_functions() { return product_gives(unchanged); }

}  // namespace

std::vector<Entry> brown_rotation() {
  return {
      {"B-18",
       "Rotation, replacement for 8.8-8.14: R, S, T",
       Kind::kEquation,
       Print::kRead,
       "R_{mn} = (S_{m,-n} + (-1)^n S_{mn})/sqrt2 (n > 0), S_{mn} (n = 0), (-T_{mn} + (-1)^n T_{m,-n})/sqrt2 (n < 0); "
       "S_{mn} = (F_{-m,n} + (-1)^m F_{mn})/sqrt2 (m > 0), F_{mn} (m = 0), (G_{mn} - (-1)^m G_{-m,n})/sqrt2 (m < 0); "
       "T_{mn} = (G_{-m,n} + (-1)^m G_{mn})/sqrt2 (m > 0), G_{mn} (m = 0), (-F_{mn} + (-1)^m F_{-m,n})/sqrt2 (m < 0)",
       Verdict::kUnderReading,
       {{"F + iG = D(R), Condon-Shortley, D_mn = INT conj Y_m(s) Y_n(R^-1 s) ds: R_{mn} is the matrix of R", from_d},
        {"F + iG = D(R)^H: R_{mn} is the matrix of R^-1", from_adjoint},
        {"F + iG = conj D(R): the matrix of R or of R^-1", from_conjugate},
        {"F + iG = D(R)^T: the matrix of R or of R^-1", from_transposed},
        {"F + iG = D(R) without the Condon-Shortley phase: the matrix of R or of R^-1", from_phaseless}},
       "as printed, F + iG = exp(-i m alpha) d_mn(beta) exp(-i n gamma)",
       from_d,
       "Every entry and sign is right for the D of the paper that it amends; the page does not define F and G."},
      {"B-19",
       "Claim R = W D W*",
       Kind::kText,
       Print::kRead,
       "the equations evaluate R = W D W*, * Hermitian conjugate",
       Verdict::kUnderReading,
       {{"W takes complex coefficients to real ones", product_for_coefficients},
        {"W takes complex functions to real ones, y = W Y", product_for_functions}},
       "R = conj(W) D W^T for y = W Y",
       product_for_coefficients,
       "With y = W Y the product W D W* is the matrix of another rotation, Rz(-alpha) Ry(beta) Rz(-gamma)."},
  };
}

}  // namespace sh::symbolic::errata
