#include "prt/splats/spz_splats.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numeric/output/atomic_file.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/splats/splat_convention.hpp"
#include "prt/splats/spz_codes.hpp"
#include "prt/splats/spz_data.hpp"

namespace sh::prt {
namespace {

constexpr auto part_index(SpzPart part) { return static_cast<std::size_t>(part); }

class SpzReader : public SplatReader {
 public:
  explicit SpzReader(const std::string& path)
      : file_(path), data_(read_spz(file_)), signs_(splat_signs(data_.header.degree)) {}

  [[nodiscard]] const std::string& file() const override { return file_.path(); }
  [[nodiscard]] std::size_t count() const override { return data_.header.count; }
  [[nodiscard]] int degree() const override { return data_.header.degree; }
  [[nodiscard]] const SpzHeader* spz() const override { return &data_.header; }

  void read(std::size_t first, std::size_t count, SplatBlock& block) const override {
    block.resize(count, data_.header.degree);
    block.first = first;
    block.record_size = 0;
    block.records.clear();
    for (std::size_t i = 0; i < count; ++i) take(first + i, i, block);
  }

  // Only for completeness: all codes stand for finite numbers.
  [[nodiscard]] std::string name_of(SplatNumber /*number*/, std::size_t index) const override {
    return fmt::format("number {}", index);
  }

  [[nodiscard]] nlohmann::ordered_json details() const override {
    return {{"version", data_.header.version},
            {"fractional_bits", data_.header.fractional_bits},
            {"antialiased", (data_.header.flags & kSpzAntialiased) != 0},
            {"extension_bytes", data_.extension_bytes}};
  }

  [[nodiscard]] std::string extras() const override {
    return data_.extension_bytes == 0 ? "" : fmt::format("{} bytes of SPZ extensions", data_.extension_bytes);
  }

 private:
  [[nodiscard]] const char* at(SpzPart part, std::size_t splat) const {
    return data_.parts[part_index(part)].data() + splat * spz_size(part, data_.header);
  }
  static std::uint8_t byte(const char* from) { return static_cast<std::uint8_t>(*from); }

  void take(std::size_t splat, std::size_t i, SplatBlock& block) const {
    const char* position = at(SpzPart::kPosition, splat);
    const char* color = at(SpzPart::kColor, splat);
    const char* scale = at(SpzPart::kScale, splat);
    const char* harmonics = at(SpzPart::kHarmonics, splat);
    for (std::size_t k = 0; k < 3; ++k) {
      block.position[3 * i + k] = decode_spz_position(position + 3 * k, data_.header.fractional_bits);
      block.log_scale[3 * i + k] = decode_spz_scale(byte(scale + k));
    }
    block.opacity[i] = decode_spz_opacity(byte(at(SpzPart::kOpacity, splat)));
    decode_spz_rotation(at(SpzPart::kRotation, splat), data_.header.version, &block.rotation[4 * i]);
    const std::size_t size = signs_.size();
    for (std::size_t channel = 0; channel < 3; ++channel) {
      float* c = &block.harmonics[(3 * i + channel) * size];
      c[0] = decode_spz_color(byte(color + channel)) * signs_[0];
      for (std::size_t k = 1; k < size; ++k) {
        c[k] = decode_spz_harmonic(byte(harmonics + 3 * (k - 1) + channel)) * signs_[k];
      }
    }
  }

  InputFile file_;
  SpzData data_;
  std::vector<float> signs_;
};

/// 12, as all writers have it, or fewer where positions are so large.
int fractional_bits(const SplatOutput& output) {
  constexpr int kUsual = 12;
  constexpr double kMostSteps = 8388607.0;  // 2^23 - 1
  if (output.summary.count == 0) return kUsual;
  const Eigen::AlignedBox3f& box = output.summary.box;
  const auto largest = static_cast<double>(box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff());
  int bits = kUsual;
  while (bits > 0 && std::ldexp(largest, bits) > kMostSteps) --bits;
  if (largest > kMostSteps) {
    throw std::invalid_argument(
        fmt::format("{}: a position of {} is beyond the range of SPZ, {}; expected a smaller --scale or a --crop",
                    output.file, largest, kMostSteps));
  }
  return bits;
}

constexpr int kFirstBits = 5;  // what all writers take
constexpr int kHigherBits = 4;

std::vector<int> bits_of(const SplatOutput& output) {
  std::vector<int> bits(splat_bands_squared(output.degree), output.spz.higher_bits.value_or(kHigherBits));
  std::fill_n(bits.begin(), std::min<std::size_t>(4, bits.size()), output.spz.first_bits.value_or(kFirstBits));
  return bits;
}

SpzHeader header_of(const SplatOutput& output) {
  const SpzHeader* like = output.input == nullptr ? nullptr : output.input->spz();
  const int version = output.spz.version.value_or(like == nullptr ? 3 : like->version);
  if (version < 2 || version > 4) {
    throw std::invalid_argument(fmt::format("--spz-version {}: expected 2, 3 or 4", version));
  }
  for (const int bits : {output.spz.first_bits.value_or(kFirstBits), output.spz.higher_bits.value_or(kHigherBits)}) {
    if (bits < 1 || bits > 8) throw std::invalid_argument(fmt::format("--sh-bits {}: expected 1 to 8", bits));
  }
  if (output.degree > 3 && version < 4) {
    throw std::invalid_argument(
        fmt::format("{}: SPZ of version {} holds degree 0 to 3, got {}; expected --spz-version 4 "
                    "or --degree 3",
                    output.file, version, output.degree));
  }
  if (output.summary.count > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(
        fmt::format("{}: an SPZ file holds 2^32 - 1 splats, got {}", output.file, output.summary.count));
  }
  return {version, static_cast<std::uint32_t>(output.summary.count), output.degree, fractional_bits(output),
          like == nullptr ? 0 : like->flags & kSpzAntialiased};
}

class SpzWriter : public SplatWriter {
 public:
  explicit SpzWriter(const SplatOutput& output)
      : bits_(bits_of(output)), signs_(splat_signs(output.degree)), file_(output.file) {
    data_.header = header_of(output);
    for (std::size_t part = 0; part < kSpzParts; ++part) {
      data_.parts[part].reserve(output.summary.count * spz_size(static_cast<SpzPart>(part), data_.header));
    }
  }

  [[nodiscard]] SplatPieces encode(const SplatBlock& block) const override {
    SplatPieces pieces(kSpzParts);
    for (std::size_t part = 0; part < kSpzParts; ++part) {
      pieces[part].resize(block.count * spz_size(static_cast<SpzPart>(part), data_.header));
    }
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < block.count; ++i) {
      put(block, i, pieces);
      clamped += is_clamped(block, i) ? 1 : 0;
    }
    clamped_ += clamped;
    return pieces;
  }

  void append(const SplatPieces& pieces) override {
    for (std::size_t part = 0; part < kSpzParts; ++part) data_.parts[part] += pieces[part];
  }

  void finish() override {
    for (const std::string& piece : spz_file(data_)) file_.write(piece.data(), piece.size());
    file_.commit();
  }

  [[nodiscard]] std::string losses() const override {
    return clamped_ == 0
               ? ""
               : fmt::format("{} splats have numbers beyond the ranges of SPZ, which were clamped", clamped_.load());
  }

 private:
  // Where a code is further away than rounding takes it: colors, scales and higher coefficients.
  [[nodiscard]] bool is_clamped(const SplatBlock& block, std::size_t i) const {
    constexpr float kMostColor = 3.347F;  // half a step beyond the last code
    constexpr float kMostHarmonic = 1.004F;
    constexpr float kLeastLogScale = -10.032F;
    constexpr float kMostLogScale = 5.969F;
    const std::size_t size = signs_.size();
    bool clamped = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const float s = block.log_scale[3 * i + k];
      const float* c = &block.harmonics[(3 * i + k) * size];
      clamped |= s < kLeastLogScale || s > kMostLogScale || std::abs(c[0]) > kMostColor;
      for (std::size_t j = 1; j < size; ++j) clamped |= std::abs(c[j]) > kMostHarmonic;
    }
    return clamped;
  }

  void put(const SplatBlock& block, std::size_t i, SplatPieces& pieces) const {
    const auto at = [&](SpzPart part) { return &pieces[part_index(part)][i * spz_size(part, data_.header)]; };
    char* position = at(SpzPart::kPosition);
    char* color = at(SpzPart::kColor);
    char* scale = at(SpzPart::kScale);
    for (std::size_t k = 0; k < 3; ++k) {
      encode_spz_position(block.position[3 * i + k], data_.header.fractional_bits, position + 3 * k);
      scale[k] = static_cast<char>(encode_spz_scale(block.log_scale[3 * i + k]));
    }
    *at(SpzPart::kOpacity) = static_cast<char>(encode_spz_opacity(block.opacity[i]));
    encode_spz_rotation(&block.rotation[4 * i], data_.header.version, at(SpzPart::kRotation));
    const std::size_t size = signs_.size();
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float* c = &block.harmonics[(3 * i + channel) * size];
      color[channel] = static_cast<char>(encode_spz_color(c[0] * signs_[0]));
      for (std::size_t k = 1; k < size; ++k) {
        at(SpzPart::kHarmonics)[3 * (k - 1) + channel] =
            static_cast<char>(encode_spz_harmonic(c[k] * signs_[k], bits_[k]));
      }
    }
  }

  std::vector<int> bits_;  // of each coefficient
  std::vector<float> signs_;
  SpzData data_;
  mutable std::atomic<std::size_t> clamped_{0};
  output::AtomicFile file_;
};

}  // namespace

std::unique_ptr<SplatReader> read_spz_splats(const std::string& file) { return std::make_unique<SpzReader>(file); }

std::unique_ptr<SplatWriter> write_spz_splats(const SplatOutput& output) { return std::make_unique<SpzWriter>(output); }

}  // namespace sh::prt
