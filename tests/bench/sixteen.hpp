// Sixteen floats in whatever registers the machine has, as a type that kernels can compute with.
#pragma once

#include <cstddef>

namespace sh::bench {

class Sixteen {
 public:
  using value_type = float;
  using Vector = float __attribute__((vector_size(64)));

  Sixteen() = default;
  explicit Sixteen(float value) : v_(Vector{} + value) {}
  explicit Sixteen(Vector v) : v_(v) {}

  friend Sixteen operator+(Sixteen a, Sixteen b) { return Sixteen(a.v_ + b.v_); }
  friend Sixteen operator-(Sixteen a, Sixteen b) { return Sixteen(a.v_ - b.v_); }
  friend Sixteen operator*(Sixteen a, Sixteen b) { return Sixteen(a.v_ * b.v_); }
  friend Sixteen operator-(Sixteen a) { return Sixteen(-a.v_); }

 private:
  Vector v_{};
};

}  // namespace sh::bench
