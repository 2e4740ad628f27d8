#include "prt/splats/splat_flaws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace sh::prt {
namespace {

bool is_finite(float value) { return (std::bit_cast<std::uint32_t>(value) & 0x7f800000U) != 0x7f800000U; }

/// One pass that the compiler turns into SIMD, as nearly all values are finite.
bool all_finite(const std::vector<float>& values) {
  bool all = true;
  for (const float value : values) all &= is_finite(value);
  return all;
}

bool is_quickly_fine(const SplatBlock& b) {
  return all_finite(b.position) && all_finite(b.rotation) && all_finite(b.log_scale) && all_finite(b.opacity) &&
         all_finite(b.harmonics);
}

struct Flaw {
  SplatNumber number;
  std::size_t index;
  float value;
};

std::optional<Flaw> find_flaw(const SplatBlock& block, std::size_t splat) {
  std::optional<Flaw> flaw;
  const auto look = [&](SplatNumber number, const std::vector<float>& values, const auto& is_fine) {
    const std::size_t row = values.size() / block.count;
    for (std::size_t k = 0; k < row && !flaw; ++k) {
      const float value = values[splat * row + k];
      if (!is_fine(value)) flaw = {number, k, value};
    }
  };
  look(SplatNumber::kPosition, block.position, is_finite);
  look(SplatNumber::kRotation, block.rotation, is_finite);
  look(SplatNumber::kScale, block.log_scale, [](float v) { return is_finite(v) || (std::isinf(v) && v < 0.0F); });
  look(SplatNumber::kOpacity, block.opacity, [](float v) { return !std::isnan(v); });
  look(SplatNumber::kHarmonics, block.harmonics, is_finite);
  return flaw;
}

void mend_quaternions(const SplatReader& reader, bool strict, SplatBlock& block, FlawCounts& counts) {
  for (std::size_t i = 0; i < block.count; ++i) {
    float* q = &block.rotation[4 * i];
    if (std::any_of(q, q + 4, [](float v) { return v != 0.0F; })) continue;
    if (strict) {
      throw std::runtime_error(
          fmt::format("{}: splat {}: its quaternion is 0; expected a rotation; refused because of "
                      "--strict",
                      reader.file(), block.first + i));
    }
    q[0] = 1.0F;
    ++counts.mended;
  }
}

}  // namespace

void mend_splats(const SplatReader& reader, const FlawChoice& choice, SplatBlock& block, FlawCounts& counts) {
  mend_quaternions(reader, choice.strict, block, counts);
  if (!is_quickly_fine(block)) {
    std::vector<std::size_t> good;
    for (std::size_t i = 0; i < block.count; ++i) {
      const auto flaw = find_flaw(block, i);
      if (!flaw) {
        good.push_back(i);
      } else if (!choice.drop) {
        throw std::runtime_error(fmt::format(
            "{}: splat {}: {} is not finite or not in its range ({}); --drop-invalid leaves such splats out",
            reader.file(), block.first + i, reader.name_of(flaw->number, flaw->index),
            static_cast<double>(flaw->value)));
      }
    }
    counts.dropped += block.count - good.size();
    block.keep(good);
  }
}

void require_finite_splats(const SplatReader& reader, const SplatBlock& block) {
  if (is_quickly_fine(block)) return;
  for (std::size_t i = 0; i < block.count; ++i) {
    if (const auto flaw = find_flaw(block, i)) {
      throw std::runtime_error(
          fmt::format("{}: after the edit {} of a splat exceeds single precision; expected a smaller "
                      "--scale or --translate",
                      reader.file(), reader.name_of(flaw->number, flaw->index)));
    }
  }
}

}  // namespace sh::prt
