// Writes GLB files with KHR_gaussian_splatting; see glb_splats.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/srgb.hpp"
#include "numeric/output/version.hpp"
#include "prt/binary/glb_container.hpp"
#include "prt/splats/glb_attributes.hpp"
#include "prt/splats/glb_splats.hpp"
#include "prt/splats/splat_convention.hpp"
#include "prt/splats/splat_numbers.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColorSize = 4;

/// Bytes of a splat: all attributes, then the color of 8 bits.
std::size_t stride_of(const std::vector<GlbAttribute>& attributes) {
  std::size_t floats = 0;
  for (const GlbAttribute& attribute : attributes) floats += attribute.components;
  return floats * sizeof(float) + kColorSize;
}

Json json_of(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

Json document(const SplatOutput& output, const std::vector<GlbAttribute>& attributes) {
  const std::size_t count = output.summary.count;
  const std::size_t stride = stride_of(attributes);
  Json accessors = Json::array();
  Json indices = Json::object();
  std::size_t offset = 0;
  const auto add = [&](const std::string& name, int component, const std::string& type) -> Json& {
    indices[name] = accessors.size();
    accessors.push_back(
        {{"bufferView", 0}, {"byteOffset", offset}, {"componentType", component}, {"count", count}, {"type", type}});
    return accessors.back();
  };
  for (const GlbAttribute& attribute : attributes) {
    Json& accessor = add(attribute.name, kFloat, glb_type(attribute.components));
    if (attribute.part == GlbPart::kPosition) {
      accessor["min"] = json_of(output.summary.box.min());
      accessor["max"] = json_of(output.summary.box.max());
    }
    offset += attribute.components * sizeof(float);
  }
  add("COLOR_0", kUnsignedByte, "VEC4")["normalized"] = true;
  const Json extension = {{"kernel", "ellipse"}, {"colorSpace", "srgb_rec709_display"}};
  const Json primitive = {{"attributes", indices}, {"mode", 0}, {"extensions", {{kSplatExtension, extension}}}};
  return {
      {"asset", {{"version", "2.0"}, {"generator", output::version_of("shforge prt")}}},
      {"extensionsUsed", {kSplatExtension}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}}}},
      {"meshes", {{{"primitives", {primitive}}}}},
      {"accessors", accessors},
      {"bufferViews", {{{"buffer", 0}, {"byteLength", count * stride}, {"byteStride", stride}, {"target", kVertices}}}},
      {"buffers", {{{"byteLength", count * stride}}}}};
}

/// Header, JSON chunk, and the head of the binary chunk.
std::string front(const SplatOutput& output, const std::vector<GlbAttribute>& attributes) {
  try {
    return glb_front(document(output, attributes).dump(), std::uint64_t{output.summary.count} * stride_of(attributes));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", output.file, error.what()));
  }
}

class GlbWriter : public SplatWriter {
 public:
  explicit GlbWriter(const SplatOutput& output)
      : name_(output.file),
        attributes_(glb_attributes(output.degree)),
        stride_(stride_of(attributes_)),
        signs_(splat_signs(output.degree)),
        y00_(static_cast<float>(0.5 * std::sqrt(std::numbers::inv_pi))) {
    if (output.degree > kHighestGlbDegree || output.summary.count == 0) {
      throw std::invalid_argument(
          output.summary.count == 0
              ? fmt::format("{}: expected one splat at least, as a GLB file cannot hold none", output.file)
              : fmt::format("{}: {} holds degree 0 to {}, got {}; expected --degree {}", output.file, kSplatExtension,
                            kHighestGlbDegree, output.degree, kHighestGlbDegree));
    }
    const std::string start = front(output, attributes_);
    file_.emplace(output.file);
    file_->write(start.data(), start.size());
  }

  [[nodiscard]] SplatPieces encode(const SplatBlock& block) const override {
    std::string bytes(block.count * stride_, '\0');
    std::vector<float> row(stride_ / sizeof(float) - 1);
    for (std::size_t i = 0; i < block.count; ++i) {
      fill(block, i, row);
      char* to = &bytes[i * stride_];
      std::memcpy(to, row.data(), row.size() * sizeof(float));
      const std::array<std::uint8_t, kColorSize> color = color_of(block, i);
      std::memcpy(to + row.size() * sizeof(float), color.data(), color.size());
    }
    return {std::move(bytes)};
  }

  void append(const SplatPieces& pieces) override { file_->write(pieces[0].data(), pieces[0].size()); }
  void finish() override { file_->commit(); }

 private:
  // The attributes' order.
  void fill(const SplatBlock& block, std::size_t i, std::vector<float>& row) const {
    float* to = row.data();
    to = std::copy_n(&block.position[3 * i], 3, to);
    const Eigen::Vector4d q = Eigen::Map<const Eigen::Vector4f>(&block.rotation[4 * i]).cast<double>();
    const double length = q.norm();
    for (const int k : {1, 2, 3, 0}) *to++ = static_cast<float>(q[k] / length);
    for (std::size_t k = 0; k < 3; ++k) *to++ = scale(block.log_scale[3 * i + k]);
    *to++ = static_cast<float>(opacity_of_logit(block.opacity[i]));
    const std::size_t size = signs_.size();
    const float* c = &block.harmonics[3 * size * i];
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t channel = 0; channel < 3; ++channel) *to++ = c[channel * size + k] * signs_[k];
    }
  }

  [[nodiscard]] float scale(float log_scale) const {
    const float linear = to_single(scale_of_log(log_scale));
    if (std::isfinite(linear)) return linear;
    throw std::runtime_error(
        fmt::format("{}: the scale e^{} of a splat exceeds single precision; expected a smaller --scale", name_,
                    static_cast<double>(log_scale)));
  }

  // For viewers that show points: linear, as glTF wants it.
  [[nodiscard]] std::array<std::uint8_t, kColorSize> color_of(const SplatBlock& block, std::size_t i) const {
    const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(255.0F * v)); };
    std::array<std::uint8_t, kColorSize> color{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float c = block.harmonics[(3 * i + channel) * signs_.size()];
      color[channel] = byte(output::srgb_decode(std::clamp(0.5F + y00_ * c, 0.0F, 1.0F)));
    }
    color[3] = byte(static_cast<float>(opacity_of_logit(block.opacity[i])));
    return color;
  }

  std::string name_;
  std::vector<GlbAttribute> attributes_;
  std::size_t stride_;
  std::vector<float> signs_;
  float y00_;
  std::optional<output::AtomicFile> file_;
};

}  // namespace

std::unique_ptr<SplatWriter> write_glb_splats(const SplatOutput& output) { return std::make_unique<GlbWriter>(output); }

}  // namespace sh::prt
