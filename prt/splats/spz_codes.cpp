#include "prt/splats/spz_codes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "prt/splats/splat_numbers.hpp"

namespace sh::prt {
namespace {

constexpr double kColorScale = 0.15;
constexpr double kScaleSteps = 16.0;
constexpr double kLeastLogScale = -10.0;
constexpr int kLargestPosition = (1 << 23) - 1;

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(std::round(value), 0.0, 255.0)); }

/// x, y, z, w of length 1.
Eigen::Vector4d unit_xyzw(const float* q) {
  const Eigen::Vector4d v = Eigen::Map<const Eigen::Vector4f>(q).cast<double>().normalized();
  return {v[1], v[2], v[3], v[0]};
}

constexpr unsigned kMagnitudeBits = 9;
constexpr unsigned kLargestMagnitude = (1U << kMagnitudeBits) - 1;

void encode_smallest_three(const Eigen::Vector4d& v, char* to) {
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  auto code = static_cast<std::uint32_t>(largest);
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (i == largest) continue;
    const double steps = std::abs(v[i]) * std::numbers::sqrt2 * kLargestMagnitude;
    const auto magnitude = static_cast<std::uint32_t>(std::min<double>(std::round(steps), kLargestMagnitude));
    const bool negative = (v[i] < 0.0) != (v[largest] < 0.0);
    code = code << 1U | (negative ? 1U : 0U);
    code = code << kMagnitudeBits | magnitude;
  }
  std::memcpy(to, &code, sizeof code);
}

Eigen::Vector4d decode_smallest_three(const char* from) {
  std::uint32_t code = 0;
  std::memcpy(&code, from, sizeof code);
  const auto largest = static_cast<Eigen::Index>(code >> 30U);
  Eigen::Vector4d v = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 3; i >= 0; --i) {
    if (i == largest) continue;
    const double size = (code & kLargestMagnitude) / (std::numbers::sqrt2 * kLargestMagnitude);
    v[i] = (code >> kMagnitudeBits & 1U) != 0 ? -size : size;
    code >>= kMagnitudeBits + 1;
  }
  v[largest] = std::sqrt(std::max(0.0, 1.0 - v.squaredNorm()));
  return v;
}

}  // namespace

void encode_spz_position(float x, int fractional_bits, char* to) {
  const double steps = std::round(std::ldexp(static_cast<double>(x), fractional_bits));
  const auto code = static_cast<std::int32_t>(std::clamp<double>(steps, -kLargestPosition - 1, kLargestPosition));
  std::memcpy(to, &code, 3);
}

float decode_spz_position(const char* from, int fractional_bits) {
  std::uint32_t code = 0;
  std::memcpy(&code, from, 3);
  const auto steps = static_cast<std::int32_t>(code << 8U) / 256;  // with the sign of the 24 bits
  return std::ldexp(static_cast<float>(steps), -fractional_bits);
}

std::uint8_t encode_spz_scale(float log_scale) {
  return to_byte((static_cast<double>(log_scale) - kLeastLogScale) * kScaleSteps);
}

float decode_spz_scale(std::uint8_t code) { return static_cast<float>(code / kScaleSteps + kLeastLogScale); }

std::uint8_t encode_spz_opacity(float logit) { return to_byte(255.0 * opacity_of_logit(logit)); }

float decode_spz_opacity(std::uint8_t code) { return logit_of_opacity(code / 255.0); }

std::uint8_t encode_spz_color(float coefficient) {
  return to_byte(255.0 * (kColorScale * static_cast<double>(coefficient) + 0.5));
}

float decode_spz_color(std::uint8_t code) { return static_cast<float>((code / 255.0 - 0.5) / kColorScale); }

std::uint8_t encode_spz_harmonic(float coefficient, int bits) {
  constexpr int kZero = 128;
  const int step = 1 << (8 - bits);
  const double steps = std::round(static_cast<double>(coefficient) * kZero / step);
  return to_byte(kZero + steps * step);
}

float decode_spz_harmonic(std::uint8_t code) { return (static_cast<float>(code) - 128.0F) / 128.0F; }

void encode_spz_rotation(const float* q, int version, char* to) {
  const Eigen::Vector4d v = unit_xyzw(q);
  if (version >= 3) return encode_smallest_three(v, to);
  for (Eigen::Index i = 0; i < 3; ++i) {
    to[i] = static_cast<char>(to_byte(127.5 * (v[3] < 0.0 ? -v[i] : v[i]) + 127.5));
  }
}

void decode_spz_rotation(const char* from, int version, float* q) {
  Eigen::Vector4d v = Eigen::Vector4d::Zero();
  if (version >= 3) {
    v = decode_smallest_three(from);
  } else {
    for (Eigen::Index i = 0; i < 3; ++i) v[i] = static_cast<std::uint8_t>(from[i]) / 127.5 - 1.0;
    v[3] = std::sqrt(std::max(0.0, 1.0 - v.squaredNorm()));
  }
  for (Eigen::Index i = 0; i < 4; ++i) q[i] = static_cast<float>(v[(i + 3) % 4]);
}

}  // namespace sh::prt
