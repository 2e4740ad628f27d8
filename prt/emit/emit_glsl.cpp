// relight.vert: comment, kernels, sizes, and the shaders of prt/emit/text; relight.json: how relight.bin is laid out.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/zonal.hpp"
#include "prt/emit/parts.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kTextureWidth = 2048;
constexpr std::size_t kTextureHeight = 16384;  // that OpenGL 4.5 promises
constexpr std::size_t kAlignment = 64;
constexpr std::string_view kFormats[] = {"R32F", "R16F", "R8_SNORM"};
constexpr float kNormalized = 127.0F;  // R8_SNORM reads q / 127

class GlslEmitter {
 public:
  GlslEmitter(const Transfer& transfer, const EmitOptions& options, bool es)
      : transfer_(transfer),
        rows_(emitted_rows(transfer, options)),
        brdfs_(emitted_brdfs(transfer)),
        kernels_(transfer, options, rows_, brdfs_, es ? "glsl-es" : "glsl"),
        es_(es) {
    if (transfer.shape.storage.is_clustered() || transfer.indirect_shape.storage.is_clustered()) {
      throw std::invalid_argument("rows in clusters have no emitted shader yet; expected `--lang cpp`");
    }
    if (!brdfs_.numbers.empty()) {
      throw std::invalid_argument("tables of BRDFs have no emitted shader yet; expected `--lang cpp`");
    }
  }

  Emitted run() {
    const bool glossy = transfer_.kind->is_glossy();
    json_["vertices"] = transfer_.mesh.positions.size();
    define("COUNT", coefficient_count(transfer_.degree()));
    if (transfer_.shape.meets != Meets::kNothing) add_texture(glossy ? "rows" : "transfer", rows_.encoded, rows_.shape);
    glossy ? add_glossy() : add_diffuse();
    add_attribute("position", 0, transfer_.mesh.positions);
    if (!transfer_.shape.holds_albedo) add_attribute("albedo", 1, transfer_.mesh.albedo);
    if (!transfer_.emitted.empty()) add_attribute("emitted", 3, transfer_.emitted);
    for (const auto& use : kernels_.all()) define_kernel(use);
    const auto shader = text(glossy ? "glossy.vert" : "relight_rows.vert");
    return {{{"relight.vert", shader}, {"relight.bin", bytes_}, {"relight.json", json_.dump(2) + "\n"}},
            kernels_.cost()};
  }

 private:
  template <class Value>
  void define(std::string_view name, const Value& value) {
    defines_ += fmt::format("#define {} {}\n", name, value);
  }

  // SH_EMITTED_RELIGHT -> RELIGHT; not those that only C++ calls.
  void define_kernel(const EmittedKernels::Use& use) {
    if (use.macro == "SH_EMITTED_PREPARE" || use.macro == "SH_EMITTED_RELIGHT_WHITE") return;
    functions_ += "\n" + use.kernel.text;
    define(use.macro.substr(std::string_view("SH_EMITTED_").size()), use.kernel.function);
  }

  std::size_t add(const void* data, std::size_t size) {
    const std::size_t offset = bytes_.size();
    bytes_.append(static_cast<const char*>(data), size);
    bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
    return offset;
  }

  void add_texture(std::string_view name, Encoded encoded, const TransferShape& shape) {
    const std::size_t row = kTextureWidth * bytes_of(shape.storage.element);
    const std::size_t height = (encoded.data.size() + row - 1) / row;
    if (height > kTextureHeight) {
      throw std::invalid_argument(
          fmt::format("a texture of {} numbers for {}: expected at most {}; bake a lower degree",
                      encoded.data.size() / bytes_of(shape.storage.element), name, kTextureWidth * kTextureHeight));
    }
    encoded.data.resize(height * row);
    json_["textures"].push_back({{"name", name},
                                 {"offset", add(encoded.data.data(), encoded.data.size())},
                                 {"format", kFormats[static_cast<std::size_t>(shape.storage.element)]},
                                 {"width", kTextureWidth},
                                 {"height", height}});
  }

  void add_numbers(std::string_view name, int location, int components, const std::vector<float>& numbers) {
    json_["attributes"].push_back({{"name", name},
                                   {"location", location},
                                   {"components", components},
                                   {"offset", add(numbers.data(), numbers.size() * sizeof(float))}});
  }

  void add_attribute(std::string_view name, int location, const std::vector<Eigen::Vector3f>& values) {
    add_numbers(name, location, 3, flat(values));
  }

  void add_diffuse() {
    define("CHANNELS", rows_.channels);
    define("KEPT_COUNT", rows_.kept.size());
    if (!transfer_.shape.holds_albedo) defines_ += "#define RECOLORABLE\n";
    if (rows_.is_masked()) {
      functions_ +=
          fmt::format("\nconst int kept[{0}] = int[{0}]({1});\n", rows_.kept.size(), fmt::join(rows_.kept, ", "));
    }
    define("KEPT(k)", rows_.is_masked() ? "kept[k]" : "(k)");
    json_["light"] = rows_.kept;
    std::vector<float> factors = rows_.encoded.scale;
    for (float& factor : factors) factor *= kNormalized;
    if (!factors.empty()) json_["light_factors"] = factors;  // (channels, kept)
  }

  void add_glossy() {
    const Mesh& mesh = transfer_.mesh;
    const int degree = transfer_.degree();
    define("BANDS", degree + 1);
    std::vector<double> cosine;
    for (int l = 0; l <= degree; ++l) {
      cosine.push_back(zonal_unit(l) * numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
    }
    define("COSINE", fmt::format("float[{}]({:.9e})", cosine.size(), fmt::join(cosine, ", ")));
    if (transfer_.shape.meets != Meets::kNothing) define("ROW", rows_.shape.columns());
    if (kernels_.has("SH_EMITTED_APPLY")) define("SAMPLES", sample_count(degree));
    add_attribute("normal", 2, mesh.normals);
    if (!mesh.specular.empty()) {
      add_attribute("specular", 4, mesh.specular);
      add_numbers("exponent", 5, 1, mesh.exponent);
    }
    if (transfer_.indirect.empty()) return;
    define("MATRIX_CHANNELS", transfer_.indirect_shape.channels);
    add_texture("matrices", emitted_matrices(transfer_), transfer_.indirect_shape);
  }

  [[nodiscard]] std::string text(std::string_view shader) const {
    std::string all = es_ ? "#version 300 es\n" : "#version 450 core\n";
    all += emitted_comment(transfer_, rows_, kernels_.cost());
    if (es_) all += "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
    return all.append(functions_).append("\n").append(defines_).append("\n").append(emitted_text(shader));
  }

  const Transfer& transfer_;
  EmittedRows rows_;
  EmittedBrdfs brdfs_;
  EmittedKernels kernels_;
  bool es_;
  Json json_;
  std::string defines_;
  std::string functions_;
  std::string bytes_;
};

}  // namespace

Emitted emit_glsl(const Transfer& transfer, const EmitOptions& options, bool es) {
  return GlslEmitter(transfer, options, es).run();
}

}  // namespace sh::prt
