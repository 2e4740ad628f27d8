// Linear forms of a kernel's coefficients, with intervals as factors: the value of a node on a box of directions.
//
// A kernel is linear in an array of coefficients, which has too many dimensions for boxes. So its numbers stay symbols: a
// node is the sum of factor * monomial, where a monomial is 1 or c_i. A node that depends on no coefficient has the
// monomial 1 alone. A kernel that is bilinear has a second kind of symbols, for products of two forms (bilinear.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "codegen/bound/interval.hpp"

namespace sh::codegen::bound {

/// 1 (0) or c_i (i+1).
using Monomial = std::uint32_t;

inline constexpr Monomial kOne = 0;
inline Monomial monomial_of(int input) { return static_cast<Monomial>(input) + 1; }
/// Throws std::domain_error for a product of coefficients.
Monomial product_of(Monomial a, Monomial b);

/// A sum of factor * monomial, in the order of the monomials.
struct Form {
  struct Term {
    Monomial monomial = kOne;
    Interval factor;
  };
  std::vector<Term> terms;

  void set(Interval value) {
    terms.resize(1);
    terms[0] = {kOne, value};
  }
  /// True if the value depends on no coefficient.
  [[nodiscard]] bool is_number() const { return terms.empty() || (terms.size() == 1 && terms[0].monomial == kOne); }
  /// The value of a form that is a number.
  [[nodiscard]] Interval number() const { return terms.empty() ? Interval{} : terms[0].factor; }
  [[nodiscard]] bool is_finite() const;
};

namespace detail {
void set_sum(Form& result, const Form& a, const Form& b);
void set_difference(Form& result, const Form& a, const Form& b);
void set_product(Form& result, const Form& a, const Form& b);
void accumulate(Form& sum, const Form& a, bool with_zero);
}  // namespace detail

/// Each function overwrites `result`, which must not be an argument. Numbers, which most nodes are, take a short way.
inline void set_sum(Form& result, const Form& a, const Form& b) {
  if (a.is_number() && b.is_number()) return result.set(a.number() + b.number());
  detail::set_sum(result, a, b);
}
inline void set_difference(Form& result, const Form& a, const Form& b) {
  if (a.is_number() && b.is_number()) return result.set(a.number() - b.number());
  detail::set_difference(result, a, b);
}
inline void set_product(Form& result, const Form& a, const Form& b) {
  if (a.is_number() && b.is_number()) return result.set(a.number() * b.number());
  detail::set_product(result, a, b);
}
void set_negative(Form& result, const Form& a);
/// sum += a.
inline void accumulate(Form& sum, const Form& a) {
  if (a.is_number() && sum.is_number()) return sum.set(sum.number() + a.number());
  detail::accumulate(sum, a, false);
}
/// sum += the form with every factor widened to hold 0.
inline void accumulate_with_zero(Form& sum, const Form& a) { detail::accumulate(sum, a, true); }

}  // namespace sh::codegen::bound
