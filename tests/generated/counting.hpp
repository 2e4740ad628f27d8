// A scalar that counts the operations done on it; works as any T of the generated kernels.
#pragma once

namespace sh::test {

struct Operations {
  int mul = 0;
  int add = 0;
  int neg = 0;
};

class Counting {
 public:
  using value_type = double;

  Counting() = default;
  explicit Counting(double value) : value_(value) {}
  [[nodiscard]] double value() const { return value_; }

  static Operations& count() {
    static Operations operations;
    return operations;
  }

  friend Counting operator*(Counting a, Counting b) {
    ++count().mul;
    return Counting(a.value_ * b.value_);
  }
  friend Counting operator+(Counting a, Counting b) {
    ++count().add;
    return Counting(a.value_ + b.value_);
  }
  friend Counting operator-(Counting a, Counting b) {
    ++count().add;
    return Counting(a.value_ - b.value_);
  }
  friend Counting operator-(Counting a) {
    ++count().neg;
    return Counting(-a.value_);
  }

 private:
  double value_ = 0;
};

}  // namespace sh::test
