// A scalar that counts the operations done on it: instantiating a kernel on it measures the kernel's cost.
//
// Counts are per thread and only rise; take the difference of two readings. The values are those of float.
#pragma once

namespace sh::numeric {

struct Operations {
  int mul = 0;
  int add = 0;  // additions and subtractions; a negation is free

  friend Operations operator-(const Operations& a, const Operations& b) { return {a.mul - b.mul, a.add - b.add}; }
};

class Counted {
 public:
  using value_type = float;  // so that generated kernels choose their float constants

  Counted() = default;
  explicit Counted(float value) : value_(value) {}

  static Operations counts() { return counts_; }

  friend Counted operator*(Counted a, Counted b) { return ++counts_.mul, Counted(a.value_ * b.value_); }
  friend Counted operator+(Counted a, Counted b) { return ++counts_.add, Counted(a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return ++counts_.add, Counted(a.value_ - b.value_); }
  friend Counted operator-(Counted a) { return Counted(-a.value_); }

 private:
  static inline thread_local Operations counts_;
  float value_ = 0;
};

}  // namespace sh::numeric
