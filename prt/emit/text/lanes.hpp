#ifndef SH_EMITTED_LANES
#define SH_EMITTED_LANES
#if defined(__F16C__)
#include <immintrin.h>
#endif

namespace sh::emitted {

/// The vertices that are computed together.
inline constexpr std::size_t kBlock = 16;

/// One number of each vertex of a block.
class Lanes {
 public:
  using value_type = float;
#if defined(__GNUC__) && !defined(SH_EMITTED_PORTABLE)
  using Values = float __attribute__((vector_size(kBlock * sizeof(float))));
  Lanes() {}
  explicit Lanes(float value) : values_(value - Values{}) {}
  Lanes(const Lanes& other) : values_(other.values_) {}  // not trivial: objects are then passed by reference
  Lanes& operator=(const Lanes& other) {
    values_ = other.values_;
    return *this;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(Sum(), a.values_ + b.values_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(Sum(), a.values_ - b.values_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(Sum(), a.values_ * b.values_); }
  friend Lanes operator-(const Lanes& a) { return Lanes(Sum(), -a.values_); }

 private:
  struct Sum {};
  Lanes(Sum, const Values& values) : values_(values) {}
  Values values_;
#else
  using Values = float[kBlock];
  Lanes() = default;
  explicit Lanes(float value) {
    for (float& one : values_) one = value;
  }
  friend Lanes operator+(Lanes a, const Lanes& b) {
    for (std::size_t i = 0; i < kBlock; ++i) a.values_[i] += b.values_[i];
    return a;
  }
  friend Lanes operator-(Lanes a, const Lanes& b) {
    for (std::size_t i = 0; i < kBlock; ++i) a.values_[i] -= b.values_[i];
    return a;
  }
  friend Lanes operator*(Lanes a, const Lanes& b) {
    for (std::size_t i = 0; i < kBlock; ++i) a.values_[i] *= b.values_[i];
    return a;
  }
  friend Lanes operator-(Lanes a) {
    for (float& one : a.values_) one = -one;
    return a;
  }

 private:
  Values values_;
#endif

 public:
  [[nodiscard]] float at(std::size_t vertex) const { return values_[vertex]; }
  void set(std::size_t vertex, float value) { values_[vertex] = value; }
  /// Reads one number of each vertex, as it is stored.
  void load_single(const unsigned char* from) { std::memcpy(&values_, from, sizeof values_); }
  void load_byte(const unsigned char* from) {
    signed char bytes[kBlock];
    std::memcpy(bytes, from, sizeof bytes);
    float wide[kBlock];
    for (std::size_t i = 0; i < kBlock; ++i) wide[i] = static_cast<float>(bytes[i]);
    std::memcpy(&values_, wide, sizeof wide);
  }
  void load_half(const unsigned char* from) {
    float wide[kBlock];
#if defined(__F16C__)
    for (std::size_t i = 0; i < 2; ++i) {
      __m128i halves;
      std::memcpy(&halves, from + i * sizeof halves, sizeof halves);
      _mm256_storeu_ps(wide + i * kBlock / 2, _mm256_cvtph_ps(halves));
    }
#else
    std::uint16_t halves[kBlock];
    std::memcpy(halves, from, sizeof halves);
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::uint32_t sign = (halves[i] & 0x8000U) << 16U;
      const std::uint32_t magnitude = (halves[i] & 0x7fffU) << 13U;
      std::uint32_t bits = magnitude + 0x38000000U;                           // exponent bias 127 for 15
      float small = static_cast<float>(halves[i] & 0x3ffU) * 5.9604645e-08F;  // 2^-24: subnormal
      if ((halves[i] & 0x7c00U) == 0) std::memcpy(&bits, &small, sizeof bits);
      bits |= sign;
      std::memcpy(&wide[i], &bits, sizeof bits);
    }
#endif
    std::memcpy(&values_, wide, sizeof wide);
  }
};

/// What generated kernels with divisions, roots and choices need, lane by lane.
struct Choice {
  bool is_first[kBlock];
};

inline Choice operator<(const Lanes& a, const Lanes& b) {
  Choice out;
  for (std::size_t i = 0; i < kBlock; ++i) out.is_first[i] = a.at(i) < b.at(i);
  return out;
}

inline Lanes select(const Choice& choice, const Lanes& first, const Lanes& second) {
  Lanes out = second;
  for (std::size_t i = 0; i < kBlock; ++i) {
    if (choice.is_first[i]) out.set(i, first.at(i));
  }
  return out;
}

inline Lanes operator/(const Lanes& a, const Lanes& b) {
  Lanes out = a;
  for (std::size_t i = 0; i < kBlock; ++i) out.set(i, a.at(i) / b.at(i));
  return out;
}

inline Lanes sqrt(const Lanes& a) {
  Lanes out = a;
  for (std::size_t i = 0; i < kBlock; ++i) out.set(i, std::sqrt(a.at(i)));
  return out;
}

}  // namespace sh::emitted
#endif
