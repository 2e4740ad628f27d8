// A value printed with as many correct digits as asked for, from a computation that may be repeated at any precision.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

constexpr int kMaxReferenceDigits = 10000;

// Throws std::invalid_argument, "NAME is VALUE, must be LOW to HIGH", for a value outside.
void require_range(const std::string& name, int value, int low, int high);

// A computation of one value. compute(decimals) is called at a precision of so many decimals (a PrecisionScope holds
// meanwhile) and errs relatively by 10^(lost - decimals), whatever digits it loses.
struct Computation {
  std::function<MpfrAny(int decimals)> compute;
  // Where the value may be exactly zero: if not zero it is above 10^-separation, and its absolute error at any
  // precision is below 10^(absolute_loss - decimals).
  struct Separation {
    long separation = 0;
    long absolute_loss = 0;
  };
  std::optional<Separation> zero{};
};

// The value rounded to `digits` significant decimals, such as "-3.14e-01"; "0" where it is found to be exactly zero,
// for which `zero` has to be given (without it the search would not end). It is computed at two precisions, both beyond
// `digits`, and at higher ones until their roundings agree [Ziv91]. Throws std::invalid_argument unless
// 1 <= digits <= kMaxReferenceDigits.
std::string correct_digits(int digits, const Computation& computation);

}  // namespace sh::numeric
