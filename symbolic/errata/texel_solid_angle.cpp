#include "symbolic/errata/texel_solid_angle.hpp"

#include <cln/real.h>
#include <ginac/ginac.h>

#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::symbolic::errata::texel {

CornerSum CornerSum::corner(const cln::cl_RA& a, const cln::cl_RA& b) {
  CornerSum sum;
  if (cln::zerop(a) || cln::zerop(b)) return sum;
  const cln::cl_RA sign = cln::signum(a) * cln::signum(b);
  sum.terms_[{cln::min(cln::abs(a), cln::abs(b)), cln::max(cln::abs(a), cln::abs(b))}] = sign;
  return sum;
}

CornerSum CornerSum::plus(const CornerSum& other, const cln::cl_RA& factor) const {
  CornerSum result = *this;
  for (const auto& [key, coefficient] : other.terms_) {
    cln::cl_RA& term = result.terms_[key];
    term = term + factor * coefficient;
    if (cln::zerop(term)) result.terms_.erase(key);
  }
  return result;
}

cln::cl_F CornerSum::evaluate(int digits) const {
  const cln::float_format_t format = cln::float_format(static_cast<std::uintptr_t>(digits) + 5);
  cln::cl_F sum = cln::cl_float(0, format);
  for (const auto& [key, coefficient] : terms_) {
    const auto& [a, b] = key;
    const cln::cl_F root = cln::sqrt(cln::cl_float(1 + a * a + b * b, format));
    sum = sum + cln::the<cln::cl_F>(cln::atan(a * b / root)) * coefficient;
  }
  return sum;
}

bool corner_integrates_area_element() {
  const GiNaC::symbol a("a");
  const GiNaC::symbol b("b");
  const GiNaC::symbol w("w");  // sqrt(1+a^2+b^2), dw/da = a/w
  const auto along = [&w](const GiNaC::ex& f, const GiNaC::symbol& v) { return f.diff(v) + f.diff(w) * v / w; };
  const GiNaC::ex difference = along(along(GiNaC::atan(a * b / w), a), b) - GiNaC::pow(w, -3);
  const Polynomial numerator = from_ginac(difference.normal().numer(), {a, b, w});
  const Polynomial square = Polynomial(1) + Polynomial::variable(0).power(2) + Polynomial::variable(1).power(2);
  Polynomial reduced;
  for (const auto& [monomial, coefficient] : numerator.terms()) {
    const int power = monomial.exponent(2);
    Polynomial rest;
    rest.add_term({monomial.exponent(0), monomial.exponent(1), power % 2}, coefficient);
    reduced += rest * square.power(power / 2);
  }
  return reduced.is_zero();
}

bool corner_of_face_is_sixth_of_pi() {
  // tan of the angle is 1/sqrt 3, so it lies between 0 and pi/4, and six times it between 0 and 3 pi/2.
  const RadicalSum number = RadicalSum(Surd::square_root(3)) + RadicalSum::imaginary_unit();
  RadicalSum power(1);
  for (int i = 0; i < 6; ++i) power = power * number;
  return power.is_real() && power.surd().is_negative();
}

std::vector<cln::cl_RA> texel_centres(int count) {
  std::vector<cln::cl_RA> centres(to_size(count));
  for (int k = 0; k < count; ++k) centres[to_size(k)] = cln::cl_RA(2 * k + 1) / count - 1;
  return centres;
}

std::vector<std::array<RadicalSum, 3>> cube_directions(int size) {
  std::vector<std::array<RadicalSum, 3>> directions;
  for (int face = 0; face < 6; ++face) {
    for (const cln::cl_RA& u : texel_centres(size)) {
      for (const cln::cl_RA& v : texel_centres(size)) {
        const Surd scale = Surd::square_root(1 / (1 + u * u + v * v));
        std::array<RadicalSum, 3> d;
        d[to_size(face % 3)] = RadicalSum(face < 3 ? scale : -scale);
        d[to_size((face + 1) % 3)] = RadicalSum(Surd(u) * scale);
        d[to_size((face + 2) % 3)] = RadicalSum(Surd(v) * scale);
        directions.push_back(d);
      }
    }
  }
  return directions;
}

}  // namespace sh::symbolic::errata::texel
