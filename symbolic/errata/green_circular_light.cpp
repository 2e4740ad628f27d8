#include "symbolic/errata/green_circular_light.hpp"

#include <cln/rational.h>
#include <cln/real.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "symbolic/zonal/zonal_integrals.hpp"

namespace sh::symbolic {
namespace {

using Switch = PrintedTerm::Switch;

Polynomial cosine_power(int power) { return Polynomial::variable(0).power(power); }
Polynomial sine_squared() { return Polynomial(1) - cosine_power(2); }

// A range of the cutoff: which switches are on and what the light is there.
struct Range {
  std::string name;
  bool t3;
  bool t9;
  Polynomial lower;  // the light is 1 for lower < t < 1
};

std::array<Range, 3> ranges() {
  return {Range{"cutoff < 0", true, true, Polynomial(1)},
          Range{"0 <= cutoff < pi", true, false, Polynomial::variable(0)},
          Range{"cutoff >= pi", false, false, Polynomial(-1)}};
}

bool is_on(const PrintedTerm& term, const Range& range) {
  return term.on == Switch::kNone || (term.on == Switch::kT3 ? range.t3 : range.t9);
}

struct Rounded {
  Polynomial value;
  Polynomial slack;  // the coefficient of a power of c may be off by this much
};

Rounded printed_coefficient(const std::vector<PrintedTerm>& terms, int index, const Range& range) {
  Rounded sum;
  for (const PrintedTerm& term : terms) {
    if (term.index != index || !is_on(term, range)) continue;
    sum.value += rational_of_decimal(term.decimal) * term.function;
    for (const auto& [monomial, coefficient] : term.function.terms()) {
      sum.slack.add_term(monomial, cln::abs(coefficient) * half_last_digit(term.decimal));
    }
  }
  return sum;
}

bool agrees(const Rounded& printed, const ZonalTerm& exact, int degree) {
  const Polynomial& ours = exact.numerator.front();
  for (int power = 0; power <= degree + 1; ++power) {
    const Monomial monomial{power};
    const cln::cl_F value = (exact.factor * Surd(ours.coefficient(monomial))).evaluate(40);
    const cln::cl_R off = cln::abs(printed.value.coefficient(monomial) - cln::rational(value));
    if (off > printed.slack.coefficient(monomial) + cln::expt(cln::cl_RA(10), -35)) return false;
  }
  return printed.value.degree() <= degree + 1;
}

}  // namespace

std::vector<PrintedTerm> green_circular_light() {
  const Polynomial one(1);
  const Polynomial c = cosine_power(1);
  const Polynomial s2 = sine_squared();
  return {
      {0, "3.544907702", Switch::kNone, one},
      {0, "-1.772453851", Switch::kT3, one},
      {0, "-1.772453851", Switch::kT3, c},
      {0, "-1.772453851", Switch::kT9, one},
      {0, "1.772453851", Switch::kT9, c},
      {2, "1.534990062", Switch::kT3, s2},
      {2, "-1.534990062", Switch::kT9, s2},
      {6, "-1.98166365", Switch::kT3, cosine_power(3)},
      {6, "1.98166365", Switch::kT3, c},
      {6, "1.98166365", Switch::kT9, cosine_power(3)},
      {6, "-1.98166365", Switch::kT9, c},
      {12, "2.930920062", Switch::kT3, one},
      {12, "-2.930920062", Switch::kT3, cosine_power(4)},
      {12, "-3.517104075", Switch::kT3, s2},
      {12, "-2.930920062", Switch::kT9, one},
      {12, "2.930920062", Switch::kT9, cosine_power(4)},
      {12, "3.517104075", Switch::kT9, s2},
  };
}

cln::cl_RA rational_of_decimal(const std::string& decimal) {
  const bool negative = !decimal.empty() && decimal.front() == '-';
  cln::cl_I digits = 0;
  int places = 0;
  int points = 0;
  for (std::size_t i = negative ? 1 : 0; i < decimal.size(); ++i) {
    if (decimal[i] == '.') {
      ++points;
    } else if (decimal[i] >= '0' && decimal[i] <= '9') {
      digits = digits * 10 + (decimal[i] - '0');
      places += points;
    } else {
      points = 2;
    }
  }
  if (points > 1 || decimal.size() == (negative ? 1U : 0U)) {
    throw std::invalid_argument("decimal '" + decimal + "'; it should be digits with at most one point");
  }
  const cln::cl_RA value = digits / cln::expt(cln::cl_RA(10), places);
  return negative ? -value : value;
}

cln::cl_RA half_last_digit(const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  const auto places = point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
  return cln::expt(cln::cl_RA(10), -places) / 2;
}

ProofResult prove_green_circular_light(const std::vector<PrintedTerm>& terms) {
  constexpr int kBands = 4;
  for (const PrintedTerm& term : terms) {
    const std::array<int, kBands> axial{0, 2, 6, 12};
    if (std::find(axial.begin(), axial.end(), term.index) == axial.end()) {
      return refuted("coefficient " + std::to_string(term.index) + " of a function about z should be zero");
    }
  }
  for (const Range& range : ranges()) {
    for (int l = 0; l < kBands; ++l) {
      const ZonalTerm exact = project_profile(l, {{Polynomial(1), range.lower, Polynomial(1)}});
      if (!agrees(printed_coefficient(terms, l * (l + 1), range), exact, l)) {
        return refuted("coefficient " + std::to_string(l * (l + 1)) + " for " + range.name);
      }
    }
  }
  return proved("4 coefficients in 3 ranges of the cutoff");
}

}  // namespace sh::symbolic
