#include "symbolic/errata/definitions.hpp"

#include <array>
#include <cstdlib>
#include <map>
#include <tuple>

namespace sh::symbolic::errata {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

ex power_of(const ex& base, int exponent) { return GiNaC::pow(base, exponent); }

// D^(l+m) (t^2 - 1)^l / (2^l l!)
ex rodrigues(int l, int m, const ex& t) {
  const GiNaC::symbol v;
  const ex derivative = power_of(power_of(v, 2) - 1, l).expand().diff(v, static_cast<unsigned>(l + m));
  return (derivative / (power_of(2, l) * GiNaC::factorial(numeric(l)))).subs(v == t);
}

// sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) d^m P_l/dz^m, m >= 0
ex axial(int l, int m) {
  const ex square = numeric(2 * l + 1, 4) * GiNaC::factorial(numeric(l - m)) / GiNaC::factorial(numeric(l + m));
  return GiNaC::sqrt(square / GiNaC::Pi) * rodrigues(l, m, symbol("z"));
}

// Mean of x^i y^j, i and j even, over one turn of x = cos, y = sin.
ex circle_mean(int i, int j) {
  const auto odd_product = [](int n) { return GiNaC::doublefactorial(numeric(n - 1)); };
  return odd_product(i) * odd_product(j) / GiNaC::doublefactorial(numeric(i + j));
}

GiNaC::matrix about_y(const ex& cosine, const ex& sine) { return {{cosine, 0, sine}, {0, 1, 0}, {-sine, 0, cosine}}; }
GiNaC::matrix about_z(const ex& cosine, const ex& sine) { return {{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}}; }

// Each entry once; 0 outside the band.
template <ex (*Entry)(int l, int m, int n)>
ex band_entry(int l, int m, int n) {
  static std::map<std::tuple<int, int, int>, ex> known;
  if (l < 0 || std::abs(m) > l || std::abs(n) > l) return 0;
  const auto [place, is_new] = known.try_emplace({l, m, n});
  if (is_new) place->second = Entry(l, m, n);
  return place->second;
}

ex integrated_real(int l, int m, int n) {
  return cap_integral(turned_by(real_harmonic(l, m), sample_rotation()) * real_harmonic(l, n), -1);
}
ex integrated_complex(int l, int m, int n, const GiNaC::matrix& r) {
  const ex conjugate = (m % 2 == 0 ? 1 : -1) * complex_harmonic(l, -m);
  return cap_integral(conjugate * turned_by(complex_harmonic(l, n), r.transpose()), -1);
}
ex integrated_sample(int l, int m, int n) { return integrated_complex(l, m, n, sample_rotation()); }
ex integrated_wigner(int l, int m, int n) {
  const ex& c = symbol("ch");
  const ex& s = symbol("sh");
  return integrated_complex(l, m, n, about_y(power_of(c, 2) - power_of(s, 2), 2 * c * s));
}

}  // namespace

ex legendre(int l, int m) {
  return l < 0 || std::abs(m) > l ? ex(0) : power_of(symbol("s"), m) * rodrigues(l, m, symbol("c"));
}

ex multiple(int m, const ex& c, const ex& s, bool sine) {
  const ex plus = power_of(c + GiNaC::I * s, std::abs(m)).expand();
  const ex minus = power_of(c - GiNaC::I * s, std::abs(m)).expand();
  const ex value = sine ? (plus - minus) / (2 * GiNaC::I) : (plus + minus) / 2;
  return (sine && m < 0 ? -value : value).expand();
}

ex real_harmonic(int l, int m) {
  const int a = std::abs(m);
  const ex turn = multiple(a, symbol("x"), symbol("y"), m < 0);
  return (axial(l, a) * turn * (m == 0 ? ex(1) : GiNaC::sqrt(ex(2)))).expand();
}

ex complex_harmonic(int l, int m) {
  const int a = std::abs(m);
  const ex plane = symbol("x") + (m < 0 ? -GiNaC::I : GiNaC::I) * symbol("y");
  return ((m > 0 && m % 2 != 0 ? -1 : 1) * axial(l, a) * power_of(plane, a)).expand();
}

ex polynomial_integral(const ex& variable, const ex& a, const ex& b, const ex& f) {
  return GiNaC::integral(variable, a, b, f.expand()).eval_integ();
}

ex cap_integral(const ex& f, const ex& lower) {
  const ex& z = symbol("z");
  const ex expanded = f.expand();
  ex along_axis = 0;
  for (int i = 0; i <= expanded.degree(symbol("x")); i += 2) {
    const ex of_x = expanded.coeff(symbol("x"), i);
    for (int j = 0; j <= of_x.degree(symbol("y")); j += 2) {
      along_axis += circle_mean(i, j) * of_x.coeff(symbol("y"), j) * power_of(1 - power_of(z, 2), (i + j) / 2);
    }
  }
  return (2 * GiNaC::Pi * polynomial_integral(z, lower, 1, along_axis)).expand();
}

ex direction(const ex& f, const ex& a, const ex& b, const ex& c) {
  return f.subs(GiNaC::exmap{{symbol("x"), a}, {symbol("y"), b}, {symbol("z"), c}});
}

const ex& half_cosine(int angle) {
  static const std::array<ex, 3> cosines{numeric(4, 5), numeric(12, 13), numeric(-15, 17)};
  return cosines[angle];
}
const ex& half_sine(int angle) {
  static const std::array<ex, 3> sines{numeric(3, 5), numeric(5, 13), numeric(8, 17)};
  return sines[angle];
}
ex whole_cosine(int angle) { return power_of(half_cosine(angle), 2) - power_of(half_sine(angle), 2); }
ex whole_sine(int angle) { return 2 * half_cosine(angle) * half_sine(angle); }

const GiNaC::matrix& sample_rotation() {
  static const GiNaC::matrix r = about_z(whole_cosine(0), whole_sine(0))
                                     .mul(about_y(whole_cosine(1), whole_sine(1)))
                                     .mul(about_z(whole_cosine(2), whole_sine(2)));
  return r;
}

ex turned_by(const ex& f, const GiNaC::matrix& r) {
  const GiNaC::matrix s{{symbol("x")}, {symbol("y")}, {symbol("z")}};
  const GiNaC::matrix turned = r.mul(s);
  return direction(f, turned(0, 0), turned(1, 0), turned(2, 0)).expand();
}

ex real_rotation(int l, int m, int n) { return band_entry<integrated_real>(l, m, n); }
ex complex_rotation(int l, int m, int n) { return band_entry<integrated_sample>(l, m, n); }
ex wigner_small_d(int l, int m, int n) { return band_entry<integrated_wigner>(l, m, n); }

}  // namespace sh::symbolic::errata
