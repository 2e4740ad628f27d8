#include "codegen/exact_real.hpp"

namespace sh::codegen {

using symbolic::Surd;

namespace {

constexpr int kSignDigits = 20;

}  // namespace

bool Computed::is_negative() const { return cln::minusp(value_(kSignDigits)); }

cln::cl_F evaluate(const ExactReal& value, int digits) {
  return std::visit([digits](const auto& v) { return v.evaluate(digits); }, value);
}

std::optional<cln::cl_RA> as_rational(const ExactReal& value) {
  const Surd* surd = std::get_if<Surd>(&value);
  if (surd == nullptr || surd->radicand() != 1 || surd->pi_half_power() != 0) return std::nullopt;
  return surd->rational();
}

bool is_zero(const ExactReal& value) {
  const Surd* surd = std::get_if<Surd>(&value);
  return surd != nullptr && surd->is_zero();
}

bool is_negative(const ExactReal& value) {
  return std::visit([](const auto& v) { return v.is_negative(); }, value);
}

ExactReal negate(const ExactReal& value) {
  if (const Surd* surd = std::get_if<Surd>(&value)) return -*surd;
  const Computed computed = std::get<Computed>(value);
  // -(-x) is x again, so that equal constants stay equal.
  const std::string& definition = computed.definition();
  const bool negated = definition.rfind("-(", 0) == 0 && definition.back() == ')';
  return Computed(negated ? definition.substr(2, definition.size() - 3) : "-(" + definition + ")",
                  [computed](int digits) { return -computed.evaluate(digits); });
}

std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  const Surd* left = std::get_if<Surd>(&a);
  const Surd* right = std::get_if<Surd>(&b);
  if (left == nullptr || right == nullptr || !left->adds_to(*right)) return std::nullopt;
  return *left + *right;
}

std::optional<ExactReal> multiply(const ExactReal& a, const ExactReal& b) {
  const Surd* left = std::get_if<Surd>(&a);
  const Surd* right = std::get_if<Surd>(&b);
  if (left == nullptr || right == nullptr) return std::nullopt;
  return *left * *right;
}

std::string to_string(const ExactReal& value) {
  if (const Surd* surd = std::get_if<Surd>(&value)) return surd->to_string();
  return std::get<Computed>(value).definition();
}

}  // namespace sh::codegen
