#include "codegen/exact_real.hpp"

namespace sh::codegen {

using symbolic::Surd;

cln::cl_F evaluate(const ExactReal& value, int digits) { return std::get<Surd>(value).evaluate(digits); }

std::optional<cln::cl_RA> as_rational(const ExactReal& value) {
  const Surd& surd = std::get<Surd>(value);
  if (surd.radicand() != 1 || surd.pi_half_power() != 0) return std::nullopt;
  return surd.rational();
}

bool is_negative(const ExactReal& value) { return std::get<Surd>(value).is_negative(); }

ExactReal negate(const ExactReal& value) { return -std::get<Surd>(value); }

std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b) {
  const Surd& left = std::get<Surd>(a);
  const Surd& right = std::get<Surd>(b);
  if (!left.adds_to(right)) return std::nullopt;
  return left + right;
}

std::optional<ExactReal> multiply(const ExactReal& a, const ExactReal& b) {
  return std::get<Surd>(a) * std::get<Surd>(b);
}

std::string to_string(const ExactReal& value) { return std::get<Surd>(value).to_string(); }

}  // namespace sh::codegen
