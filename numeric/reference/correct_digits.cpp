// See correct_digits.hpp.
#include "numeric/reference/correct_digits.hpp"

#include <mpfr.h>

#include <stdexcept>
#include <vector>

namespace sh::numeric {
namespace {

// The widest range of exponents there is: sin^m near a pole leaves the usual one.
class WideExponents {
 public:
  WideExponents() {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
  }
  ~WideExponents() {
    mpfr_set_emin(least_);
    mpfr_set_emax(largest_);
  }
  WideExponents(const WideExponents&) = delete;
  WideExponents& operator=(const WideExponents&) = delete;

 private:
  mpfr_exp_t least_ = mpfr_get_emin();
  mpfr_exp_t largest_ = mpfr_get_emax();
};

MpfrAny value_at(const Computation& computation, int decimals) {
  const PrecisionScope scope(static_cast<unsigned>(decimals));
  return computation.compute(decimals);
}

std::string rounded(const MpfrAny& value, int digits) {
  std::vector<char> text(static_cast<std::size_t>(digits) + 64);
  mpfr_snprintf(text.data(), text.size(), "%.*Re", digits - 1, value.backend().data());
  return text.data();
}

// Whether two computations of one value that is not zero agree to `digits` and 8 more. Where everything cancels they
// have nothing in common and this fails.
bool agree(const MpfrAny& a, const MpfrAny& b, int digits) {
  if (a == 0 || b == 0) return false;
  const MpfrAny relative = abs(MpfrAny((a - b) / b));
  return relative == 0 || relative < pow(MpfrAny(10), -digits - 8);
}

// Whether the value, computed with so many decimals, cannot be other than zero.
bool vanishes(const MpfrAny& value, int decimals, const Computation::Separation& zero) {
  return decimals > zero.separation + zero.absolute_loss + 1 &&
         (value == 0 || abs(value) < pow(MpfrAny(10), -zero.separation));
}

}  // namespace

void require_range(const std::string& name, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(name + " is " + std::to_string(value) + ", must be " + std::to_string(low) + " to " +
                              std::to_string(high));
}

std::string correct_digits(int digits, const Computation& computation) {
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const WideExponents range;
  constexpr int kApart = 16;
  for (int guard = 16;; guard *= 2) {
    const int decimals = digits + guard + kApart;
    const MpfrAny value = value_at(computation, digits + guard);
    const MpfrAny better = value_at(computation, decimals);
    std::string text = rounded(better, digits);
    if (agree(value, better, digits) && rounded(value, digits) == text) return text;
    if (computation.zero && vanishes(better, decimals, *computation.zero)) return "0";
  }
}

}  // namespace sh::numeric
