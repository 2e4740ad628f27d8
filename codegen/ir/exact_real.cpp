#include "codegen/ir/exact_real.hpp"

#include <cln/real.h>

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace sh::codegen {

using symbolic::Surd;

namespace {

constexpr int kSignDigits = 20;
constexpr int kGuardDigits = 5;  // for the products of a computed real

bool is_one(const Surd& surd) { return surd == Surd(1); }

std::string power_text(const std::string& definition, int exponent) {
  return exponent == 1 ? definition : definition + "^" + std::to_string(exponent);
}

}  // namespace

Computed::Computed(const std::string& definition, Value value) {
  powers_[definition] = {1, std::make_shared<const Value>(std::move(value))};
}

std::string Computed::definition() const {
  std::string above;
  std::string below;
  for (const auto& [text, power] : powers_) {
    if (power.exponent > 0) above += (above.empty() ? "" : " ") + power_text(text, power.exponent);
    if (power.exponent < 0) below += " / " + power_text(text, -power.exponent);
  }
  if (is_one(factor_)) return (above.empty() ? "1" : above) + below;
  if (is_one(-factor_)) return (above.empty() ? "-1" : "-" + above) + below;
  return factor_.to_string() + (above.empty() ? "" : " " + above) + below;
}

cln::cl_F Computed::evaluate(int digits) const {
  cln::cl_F result = factor_.evaluate(digits + kGuardDigits);
  for (const auto& [text, power] : powers_) {
    const cln::cl_F value = (*power.value)(digits + kGuardDigits);
    for (int i = 0; i < std::abs(power.exponent); ++i) result = power.exponent > 0 ? result * value : result / value;
  }
  return result;
}

bool Computed::is_negative() const { return cln::minusp(evaluate(kSignDigits)); }

bool Computed::has_powers_of(const Computed& other) const {
  return std::equal(
      powers_.begin(), powers_.end(), other.powers_.begin(), other.powers_.end(),
      [](const auto& x, const auto& y) { return x.first == y.first && x.second.exponent == y.second.exponent; });
}

Computed Computed::with_factor(const Surd& factor) const {
  Computed result = *this;
  result.factor_ = factor;
  return result;
}

Computed Computed::inverse() const {
  Computed result = *this;
  result.factor_ = factor_.inverse();
  for (auto& [text, power] : result.powers_) power.exponent = -power.exponent;
  return result;
}

Computed operator*(const Computed& a, const Computed& b) {
  Computed result = a;
  result.factor_ = a.factor_ * b.factor_;
  for (const auto& [text, power] : b.powers_) {
    const auto [position, added] = result.powers_.try_emplace(text, power);
    if (added) continue;
    position->second.exponent += power.exponent;
    if (position->second.exponent == 0) result.powers_.erase(position);
  }
  return result;
}

bool operator<(const Computed& a, const Computed& b) {
  if (!(a.factor_ == b.factor_)) return a.factor_ < b.factor_;
  return std::lexicographical_compare(
      a.powers_.begin(), a.powers_.end(), b.powers_.begin(), b.powers_.end(), [](const auto& x, const auto& y) {
        return std::tie(x.first, x.second.exponent) < std::tie(y.first, y.second.exponent);
      });
}

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

ExactReal negate(const ExactReal& value) { return multiply(Surd(-1), value); }

std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  if (a.index() != b.index()) return std::nullopt;
  if (const Surd* left = std::get_if<Surd>(&a)) {
    const Surd& right = std::get<Surd>(b);
    return left->adds_to(right) ? std::optional<ExactReal>(*left + right) : std::nullopt;
  }
  const auto& left = std::get<Computed>(a);
  const auto& right = std::get<Computed>(b);
  if (!left.has_powers_of(right) || !left.factor().adds_to(right.factor())) return std::nullopt;
  const Surd factor = left.factor() + right.factor();
  return factor.is_zero() ? ExactReal(factor) : left.with_factor(factor);
}

ExactReal multiply(const ExactReal& a, const ExactReal& b) {
  if (is_zero(a)) return a;
  if (is_zero(b)) return b;
  const Surd* left = std::get_if<Surd>(&a);
  const Surd* right = std::get_if<Surd>(&b);
  if (left != nullptr && right != nullptr) return *left * *right;
  if (left != nullptr) return std::get<Computed>(b).with_factor(*left * std::get<Computed>(b).factor());
  if (right != nullptr) return std::get<Computed>(a).with_factor(*right * std::get<Computed>(a).factor());
  const Computed product = std::get<Computed>(a) * std::get<Computed>(b);
  return product.is_surd() ? ExactReal(product.factor()) : product;
}

ExactReal reciprocal(const ExactReal& value) {
  if (const Surd* surd = std::get_if<Surd>(&value)) return surd->inverse();
  return std::get<Computed>(value).inverse();
}

std::string to_string(const ExactReal& value) {
  if (const Surd* surd = std::get_if<Surd>(&value)) return surd->to_string();
  return std::get<Computed>(value).definition();
}

}  // namespace sh::codegen
