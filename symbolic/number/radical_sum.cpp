#include "symbolic/number/radical_sum.hpp"

#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <cln/real.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace sh::symbolic {
namespace {

cln::cl_RA as_rational(const cln::cl_R& real) { return cln::the<cln::cl_RA>(real); }

void print_term(std::ostringstream& text, bool first, const Surd& size, bool imaginary) {
  text << (size.is_negative() ? (first ? "-" : " - ") : (first ? "" : " + "));
  const std::string body = (size.is_negative() ? -size : size).to_string();
  if (!imaginary) {
    text << body;
  } else {
    text << (body == "1" ? std::string("i") : "i " + body);
  }
}

}  // namespace

RadicalSum RadicalSum::imaginary_unit() {
  RadicalSum result;
  result.add_term({1, 0}, cln::complex(0, 1));
  return result;
}

void RadicalSum::add_term(const Radical& radical, const cln::cl_N& coefficient) {
  if (cln::zerop(coefficient)) return;
  const auto [position, inserted] = terms_.try_emplace(radical, coefficient);
  if (inserted) return;
  position->second = position->second + coefficient;
  if (cln::zerop(position->second)) terms_.erase(position);
}

bool RadicalSum::is_real() const {
  return std::all_of(terms_.begin(), terms_.end(),
                     [](const auto& term) { return cln::zerop(cln::imagpart(term.second)); });
}

RadicalSum RadicalSum::conjugate() const {
  RadicalSum result;
  for (const auto& [radical, coefficient] : terms_) result.terms_.emplace(radical, cln::conjugate(coefficient));
  return result;
}

RadicalSum RadicalSum::inverse() const {
  if (terms_.size() != 1) {
    throw std::invalid_argument("RadicalSum: inverse: expected one term that is not zero, got " + to_string());
  }
  const auto& [radical, coefficient] = *terms_.begin();
  RadicalSum result;  // 1 / (q sqrt(r) p) = sqrt(r) / (q r p)
  result.add_term({radical.first, -radical.second}, cln::recip(coefficient * radical.first));
  return result;
}

Surd RadicalSum::surd() const {
  if (is_zero()) return {};
  if (terms_.size() != 1 || !is_real()) {
    throw std::invalid_argument("RadicalSum: expected a real number with one radical, got " + to_string());
  }
  const auto& [radical, coefficient] = *terms_.begin();
  return Surd::square_root(cln::cl_RA(radical.first), radical.second) * Surd(as_rational(cln::realpart(coefficient)));
}

std::string RadicalSum::to_string() const {
  if (is_zero()) return "0";
  std::ostringstream text;
  bool first = true;
  for (const auto& [radical, coefficient] : terms_) {
    const Surd root = Surd::square_root(cln::cl_RA(radical.first), radical.second);
    for (const bool imaginary : {false, true}) {
      const cln::cl_RA part = as_rational(imaginary ? cln::imagpart(coefficient) : cln::realpart(coefficient));
      if (cln::zerop(part)) continue;
      print_term(text, first, root * Surd(part), imaginary);
      first = false;
    }
  }
  return text.str();
}

RadicalSum RadicalSum::operator-() const {
  RadicalSum result;
  for (const auto& [radical, coefficient] : terms_) result.terms_.emplace(radical, -coefficient);
  return result;
}

RadicalSum& RadicalSum::operator+=(const RadicalSum& other) {
  for (const auto& [radical, coefficient] : other.terms_) add_term(radical, coefficient);
  return *this;
}

RadicalSum operator*(const RadicalSum& a, const RadicalSum& b) {
  RadicalSum result;
  for (const auto& [radical_a, coefficient_a] : a.terms_) {
    for (const auto& [radical_b, coefficient_b] : b.terms_) {
      // Both radicands are square-free, so their common factor is all that leaves the root.
      const cln::cl_I common = cln::gcd(radical_a.first, radical_b.first);
      const cln::cl_I rest = cln::exquo(radical_a.first, common) * cln::exquo(radical_b.first, common);
      result.add_term({rest, radical_a.second + radical_b.second}, coefficient_a * coefficient_b * common);
    }
  }
  return result;
}

bool operator==(const RadicalSum& a, const RadicalSum& b) {
  return std::equal(a.terms_.begin(), a.terms_.end(), b.terms_.begin(), b.terms_.end(),
                    [](const auto& s, const auto& t) { return s.first == t.first && cln::equal(s.second, t.second); });
}

}  // namespace sh::symbolic
