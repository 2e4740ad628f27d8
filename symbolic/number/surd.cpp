#include "symbolic/number/surd.hpp"

#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <cln/real.h>

#include <sstream>
#include <stdexcept>

namespace sh::symbolic {
namespace {

// Radicands here are products of small factors (factorials); this is far beyond the primes of degree 1000.
constexpr int kLargestTrialFactor = 1'000'000;

struct SquareSplit {
  cln::cl_I root;  // n = root^2 * square_free
  cln::cl_I square_free;
};

// Splits a positive integer by trial division; stops as soon as the rest is 1 or a perfect square.
SquareSplit split_square(cln::cl_I n) {
  SquareSplit split{1, 1};
  for (int factor = 2; n > 1; factor += factor == 2 ? 1 : 2) {
    cln::cl_I root;
    if (cln::sqrtp(n, &root)) {
      split.root = split.root * root;
      return split;
    }
    if (n < cln::cl_I(factor) * factor) {  // the rest is prime
      split.square_free = split.square_free * n;
      return split;
    }
    if (factor > kLargestTrialFactor) {
      throw std::invalid_argument("Surd: expected a radicand with small prime factors, got one above 1000000");
    }
    int multiplicity = 0;
    while (cln::zerop(cln::mod(n, factor))) {
      n = cln::exquo(n, factor);
      ++multiplicity;
    }
    for (int i = 0; i < multiplicity / 2; ++i) split.root = split.root * factor;
    if (multiplicity % 2 == 1) split.square_free = split.square_free * factor;
  }
  return split;
}

}  // namespace

Surd Surd::square_root(const cln::cl_RA& square, int pi_half_power) {
  if (cln::minusp(square)) {
    throw std::invalid_argument("Surd: square root: expected a number of 0 or more, got a negative one");
  }
  Surd result;
  if (cln::zerop(square)) return result;
  // sqrt(n/d) = sqrt(n d) / d
  const SquareSplit split = split_square(cln::numerator(square) * cln::denominator(square));
  result.rational_ = split.root / cln::denominator(square);
  result.radicand_ = split.square_free;
  result.pi_half_power_ = pi_half_power;
  return result;
}

bool Surd::adds_to(const Surd& other) const {
  return is_zero() || other.is_zero() || (radicand_ == other.radicand_ && pi_half_power_ == other.pi_half_power_);
}

cln::cl_F Surd::evaluate(int digits) const {
  const cln::float_format_t format = cln::float_format(static_cast<std::uintptr_t>(digits) + 5);
  cln::cl_F value = cln::cl_float(rational_, format);
  if (radicand_ != 1) value = value * cln::sqrt(cln::cl_float(radicand_, format));
  if (pi_half_power_ != 0) {
    const cln::cl_F pi = cln::pi(format);
    const bool whole = pi_half_power_ % 2 == 0;
    const int power = whole ? pi_half_power_ / 2 : pi_half_power_;
    value = value * cln::the<cln::cl_F>(cln::expt(whole ? pi : cln::sqrt(pi), power));
  }
  return value;
}

std::string Surd::to_string() const {
  std::ostringstream text;
  const bool pi_below_root = pi_half_power_ == -1;
  const bool has_root = radicand_ != 1 || pi_below_root;
  const bool has_pi = pi_half_power_ != 0 && !pi_below_root;
  if (rational_ != 1 || (!has_root && !has_pi)) {
    if (rational_ == -1 && (has_root || has_pi)) {
      text << '-';
    } else {
      text << rational_ << (has_root || has_pi ? " " : "");
    }
  }
  if (has_root) text << "sqrt(" << radicand_ << (pi_below_root ? "/pi)" : ")");
  if (has_pi) {
    text << (has_root ? " " : "") << "pi";
    if (pi_half_power_ != 2) text << '^';
    if (pi_half_power_ % 2 != 0) {
      text << '(' << pi_half_power_ << "/2)";
    } else if (pi_half_power_ != 2) {
      text << pi_half_power_ / 2;
    }
  }
  return text.str();
}

Surd Surd::operator-() const {
  Surd result = *this;
  result.rational_ = -rational_;
  return result;
}

Surd Surd::inverse() const {
  if (is_zero()) throw std::invalid_argument("Surd: inverse: expected a number that is not zero, got 0");
  Surd result;  // 1 / (q sqrt(r)) = sqrt(r) / (q r)
  result.rational_ = cln::recip(rational_ * radicand_);
  result.radicand_ = radicand_;
  result.pi_half_power_ = -pi_half_power_;
  return result;
}

Surd operator*(const Surd& a, const Surd& b) {
  Surd result;
  result.rational_ = a.rational_ * b.rational_;
  if (result.is_zero()) return result;
  // Both radicands are square-free, so their common factor is all that leaves the root.
  const cln::cl_I common = cln::gcd(a.radicand_, b.radicand_);
  result.rational_ = result.rational_ * common;
  result.radicand_ = cln::exquo(a.radicand_, common) * cln::exquo(b.radicand_, common);
  result.pi_half_power_ = a.pi_half_power_ + b.pi_half_power_;
  return result;
}

Surd operator+(const Surd& a, const Surd& b) {
  if (!a.adds_to(b)) {
    throw std::invalid_argument("Surd: expected a sum of equal radicals, got " + a.to_string() + " + " + b.to_string());
  }
  if (a.is_zero()) return b;
  Surd result = a;
  result.rational_ = a.rational_ + b.rational_;
  return result.is_zero() ? Surd() : result;
}

bool operator==(const Surd& a, const Surd& b) {
  return a.rational_ == b.rational_ && a.radicand_ == b.radicand_ && a.pi_half_power_ == b.pi_half_power_;
}

bool operator<(const Surd& a, const Surd& b) {
  if (a.pi_half_power_ != b.pi_half_power_) return a.pi_half_power_ < b.pi_half_power_;
  if (a.radicand_ != b.radicand_) return a.radicand_ < b.radicand_;
  return a.rational_ < b.rational_;
}

}  // namespace sh::symbolic
