#include "codegen/bound/form.hpp"

#include <stdexcept>

namespace sh::codegen::bound {
namespace {

using Terms = std::vector<Form::Term>;

// Merges the terms of a and b: both(x, y) for a monomial of both, second(y) for one of b alone.
template <class Both, class Second>
void merge(Terms& result, const Terms& a, const Terms& b, const Both& both, const Second& second) {
  result.clear();
  auto x = a.begin();
  auto y = b.begin();
  while (x != a.end() || y != b.end()) {
    if (y == b.end() || (x != a.end() && x->monomial < y->monomial)) {
      result.push_back(*x++);
    } else if (x == a.end() || y->monomial < x->monomial) {
      result.push_back({y->monomial, second(y->factor)});
      ++y;
    } else {
      result.push_back({x->monomial, both(x->factor, y->factor)});
      ++x, ++y;
    }
  }
}

}  // namespace

Monomial product_of(Monomial a, Monomial b) {
  if (a == kOne) return b;
  if (b == kOne) return a;
  throw std::domain_error("it multiplies coefficients beside other inputs");
}

bool Form::is_finite() const {
  return std::all_of(terms.begin(), terms.end(), [](const Term& term) { return term.factor.is_finite(); });
}

void set_negative(Form& result, const Form& a) {
  result.terms = a.terms;
  for (Form::Term& term : result.terms) term.factor = -term.factor;
}

namespace detail {

void set_sum(Form& result, const Form& a, const Form& b) {
  merge(
      result.terms, a.terms, b.terms, [](Interval x, Interval y) { return x + y; }, [](Interval y) { return y; });
}

void set_difference(Form& result, const Form& a, const Form& b) {
  merge(
      result.terms, a.terms, b.terms, [](Interval x, Interval y) { return x - y; }, [](Interval y) { return -y; });
}

void set_product(Form& result, const Form& a, const Form& b) {
  result.terms.clear();
  for (const Form::Term& x : a.terms) {
    for (const Form::Term& y : b.terms) {
      result.terms.push_back({product_of(x.monomial, y.monomial), x.factor * y.factor});
    }
  }
}

// Adds terms whose monomials the sum has already; false, and nothing is done, where one is missing.
template <class Widened>
bool add_in_place(Terms& sum, const Terms& a, const Widened& widened) {
  if (a.size() > sum.size()) return false;
  auto place = sum.begin();
  for (const Form::Term& term : a) {
    while (place != sum.end() && place->monomial < term.monomial) ++place;
    if (place == sum.end() || place->monomial != term.monomial) return false;
  }
  place = sum.begin();
  for (const Form::Term& term : a) {
    while (place->monomial != term.monomial) ++place;
    place->factor = place->factor + widened(term.factor);
  }
  return true;
}

void accumulate(Form& sum, const Form& a, bool with_zeros) {
  const auto widened = [with_zeros](Interval x) { return with_zeros ? with_zero(x) : x; };
  if (sum.terms.empty()) {
    sum.terms = a.terms;
    for (Form::Term& term : sum.terms) term.factor = widened(term.factor);
    return;
  }
  if (add_in_place(sum.terms, a.terms, widened)) return;
  static thread_local Terms merged;  // keeps its memory
  merge(
      merged, sum.terms, a.terms, [&](Interval x, Interval y) { return x + widened(y); }, widened);
  sum.terms.swap(merged);
}

}  // namespace detail

}  // namespace sh::codegen::bound
