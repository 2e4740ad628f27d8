// See rotation_reference.hpp.
#include "numeric/reference/rotation_reference.hpp"

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "numeric/oracle/surd.hpp"
#include "numeric/reference/decimal.hpp"

namespace sh::numeric {
namespace {

constexpr double kMaxSeparation = 100000;  // seconds at degree 1000

struct Complex {
  MpfrAny real = 0;
  MpfrAny imaginary = 0;
};

Complex operator*(const Complex& a, const Complex& b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

// 1, a, a^2, ..., a^count.
std::vector<Complex> powers(const Complex& a, int count) {
  std::vector<Complex> all{{1, 0}};
  for (int i = 0; i < count; ++i) all.push_back(all.back() * a);
  return all;
}

// a^n of the powers of a; of the conjugate for negative n.
Complex power(const std::vector<Complex>& all, int n) {
  const auto& value = all[std::abs(n)];
  return {value.real, n < 0 ? MpfrAny(-value.imaginary) : value.imaginary};
}

// sum over k of (-1)^(m'-m+k) C(l+m, k) C(l-m, m'-m+k) A^(k1-k) B^(k-k0), for k from k0 to k1, all that do not vanish.
MpfrAny binomial_sum(long l, long row, long column, const MpfrAny& a, const MpfrAny& b) {
  long k = std::max(0L, column - row);
  long j = row - column + k;
  const long last = std::min(l + column, l - row);
  Integer coefficient;
  Integer other;
  auto* const c = coefficient.backend().data();
  mpz_bin_uiui(c, static_cast<unsigned long>(l + column), static_cast<unsigned long>(k));
  mpz_bin_uiui(other.backend().data(), static_cast<unsigned long>(l - column), static_cast<unsigned long>(j));
  coefficient *= other;
  if (j % 2 != 0) coefficient = -coefficient;
  MpfrAny sum;
  mpfr_set_z(sum.backend().data(), c, MPFR_RNDN);
  MpfrAny b_power = 1;
  MpfrAny term;
  for (; k < last; ++k, ++j) {
    mpz_mul_si(c, c, -(l + column - k) * (l - column - j));
    mpz_divexact_ui(c, c, static_cast<unsigned long>((k + 1) * (j + 1)));
    b_power *= b;
    mpfr_mul_z(term.backend().data(), b_power.backend().data(), c, MPFR_RNDN);
    sum = sum * a + term;
  }
  return sum;
}

}  // namespace

// With a = w - i z and b = y - i x the rotation takes u to a u + b v and v to -b* u + a* v; Y_lm, with Condon-Shortley
// phase, turns like u^(l+m) v^(l-m) / sqrt((l+m)! (l-m)!), which is D_m'm below [Wigner59], [Varshalovich88] 4.3. From
// there to the real basis by E_m = P_l|m| e^(i m phi), which is Y_lm without the phase (-1)^m for m > 0: the cosine is
// sqrt 2 Re E_m, the sine sqrt 2 Im E_m.
class WignerEntries {
 public:
  WignerEntries(int l, const std::array<MpfrAny, 4>& q)
      : l_(l),
        a_(q[0] * q[0] + q[3] * q[3]),
        b_(q[1] * q[1] + q[2] * q[2]),
        a_powers_(powers({q[0], -q[3]}, 2 * l)),
        b_powers_(powers({q[2], -q[1]}, 2 * l)),
        ratios_(1, MpfrAny(1)) {
    for (int m = 1; m <= l; ++m) ratios_.push_back(ratios_.back() * (l + m) / (l - m + 1));
  }

  MpfrAny entry(int row, int column) {
    const int m = std::abs(row);
    const int n = std::abs(column);
    if (pair_ != std::pair(m, n)) {
      pair_ = {m, n};
      plus_ = turned(m, n);
      if (m != 0) minus_ = turned(-m, n);
    }
    if (m == 0 && n == 0) return plus_.real;
    if (m == 0) return sqrt(MpfrAny(2)) * (column > 0 ? plus_.real : plus_.imaginary);
    if (n == 0) return sqrt(MpfrAny(2)) * (row > 0 ? plus_.real : MpfrAny(-plus_.imaginary));
    if (column > 0) return row > 0 ? MpfrAny(plus_.real + minus_.real) : MpfrAny(minus_.imaginary - plus_.imaginary);
    return row > 0 ? MpfrAny(plus_.imaginary + minus_.imaginary) : MpfrAny(plus_.real - minus_.real);
  }

 private:
  // E_column(R^-1 s) = sum over rows of this times E_row(s); column >= 0.
  [[nodiscard]] Complex turned(int row, int column) const {
    const MpfrAny ratio = ratios_[std::abs(row)] / ratios_[column];
    MpfrAny scale = binomial_sum(l_, row, column, a_, b_) * sqrt(ratio);
    if ((std::max(row, 0) + column) % 2 != 0) scale = -scale;
    const Complex phase = power(a_powers_, column + row) * power(b_powers_, column - row);
    return {scale * phase.real, scale * phase.imaginary};
  }

  int l_;
  MpfrAny a_, b_;  // |a|^2, |b|^2
  std::vector<Complex> a_powers_, b_powers_;
  std::vector<MpfrAny> ratios_;  // (l+m)! (l-m)! / l!^2
  std::pair<int, int> pair_{-1, -1};
  Complex plus_, minus_;  // of the rows +-m of the pair, for its column n
};

RotationReference::RotationReference(int degree, GivenRotation rotation)
    : degree_(degree), rotation_(std::move(rotation)) {
  require_range("degree", degree, 0, kMaxRotationReferenceDegree);
}

RotationReference::~RotationReference() = default;

std::string RotationReference::entry(int row, int column, int digits) {
  require_range("row", row, -degree_, degree_);
  require_range("column", column, -degree_, degree_);
  const double separation =
      rotation_.rational ? degree_ * (rotation_.height + 0.31) + 1 : digits + 100 + 2 * degree_ * rotation_.height;
  Computation computation{[&](int decimals) {
    auto& entries = by_decimals_[decimals];
    if (!entries) entries = std::make_unique<WignerEntries>(degree_, rotation_.quaternion());
    return entries->entry(row, column);
  }};
  computation.zero = {static_cast<long>(std::min(separation, kMaxSeparation)) + 1, degree_ + 20L};
  return correct_digits(digits, computation);
}

std::vector<std::string> RotationReference::all(int digits, const std::function<void()>& advance) {
  const int size = 2 * degree_ + 1;
  std::vector<std::string> entries(static_cast<std::size_t>(size) * size);
  for (int m = 0; m <= degree_; ++m) {
    for (int n = 0; n <= degree_; ++n) {
      // The up to four entries that share their sums.
      for (const int row : {m, -m}) {
        for (const int column : {n, -n}) {
          auto& text = entries[(row + degree_) * size + column + degree_];
          if (!text.empty()) continue;
          text = entry(row, column, digits);
          advance();
        }
      }
    }
  }
  return entries;
}

}  // namespace sh::numeric
