// A scalar of about 106 bits that counts the operations done on it: running a kernel on it gives the kernel's own
// formula almost exactly, and the kernel's cost.
//
// A value is the unevaluated sum high + low of two doubles with |low| <= ulp(high) / 2; a sum or product errs by a few
// 2^-105 of its value, a quotient or root likewise. Range: that of double. Needs arithmetic without contraction. Counts
// are per thread and only rise; take the difference of two readings.
// Reference: T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18
// (1971) 224; D. E. Knuth, The Art of Computer Programming 2, section 4.2.2 (two_sum).
#pragma once

namespace sh::numeric {

struct Operations {
  int mul = 0;
  int add = 0;    // additions, subtractions and negations, as generated/MANIFEST counts them
  int other = 0;  // divisions, square roots and selections

  friend Operations operator-(const Operations& a, const Operations& b) {
    return {a.mul - b.mul, a.add - b.add, a.other - b.other};
  }
};

class Wide {
 public:
  using value_type = double;  // so that generated kernels choose their double constants

  Wide() = default;
  explicit Wide(double value) : high_(value) {}
  Wide(double high, double low) : high_(high), low_(low) {}  // |low| <= ulp(high) / 2

  /// Any type with more digits than double, such as Mpfr50.
  template <class Real>
  static Wide from(const Real& value) {
    const auto high = static_cast<double>(value);
    return {high, static_cast<double>(Real(value - Real(high)))};
  }

  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double low() const { return low_; }

  static Operations counts();

  friend Wide operator+(Wide a, Wide b);
  friend Wide operator-(Wide a, Wide b);
  friend Wide operator*(Wide a, Wide b);
  friend Wide operator/(Wide a, Wide b);
  friend Wide operator-(Wide a);
  friend Wide sqrt(Wide a);
  friend bool operator<(Wide a, Wide b);  // counts as a selection: kernels compare for nothing else

 private:
  double high_ = 0;
  double low_ = 0;
};

}  // namespace sh::numeric
