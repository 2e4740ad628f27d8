// relight.vert: comment, kernels, sizes, and the shaders of prt/emit/text; relight.json: how relight.bin is laid out.
#include <fmt/format.h>

#include <deque>
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

// The most vec4s of a vertex that OpenGL ES 3.0 captures.
constexpr std::size_t kCaptured = 15;

/// A shader in the making: its kernels, the macros of its texts, and these files of prt/emit/text.
struct Shader {
  std::string file;
  std::string functions;
  std::string defines;
  std::vector<std::string_view> texts;

  template <class Value>
  void define(std::string_view name, const Value& value) {
    defines += fmt::format("#define {} {}\n", name, value);
  }
  // SH_EMITTED_RELIGHT -> RELIGHT.
  void use(const EmittedKernels& kernels, std::string_view macro) {
    for (const auto& use : kernels.all()) {
      if (use.macro.substr(std::string_view("SH_EMITTED_").size()) != macro) continue;
      functions += "\n" + use.kernel.text;
      define(macro, use.kernel.function);
    }
  }
};

class GlslEmitter {
 public:
  GlslEmitter(const Transfer& transfer, const EmitOptions& options, bool es)
      : transfer_(transfer),
        rows_(emitted_rows(transfer, options)),
        brdfs_(emitted_brdfs(transfer)),
        kernels_(transfer, options, rows_, brdfs_, es ? "glsl-es" : "glsl"),
        es_(es) {
    if (!brdfs_.numbers.empty()) {
      throw std::invalid_argument("tables of BRDFs have no emitted shader yet; expected `--lang cpp`");
    }
    relight_.define("COUNT", coefficient_count(transfer.degree()));
  }

  Emitted run() {
    const bool glossy = transfer_.kind->is_glossy();
    json_["vertices"] = transfer_.mesh.positions.size();
    glossy ? add_glossy() : add_diffuse();
    add_attribute("position", 0, transfer_.mesh.positions);
    if (!transfer_.shape.holds_albedo) add_attribute("albedo", 1, transfer_.mesh.albedo);
    if (!transfer_.emitted.empty()) add_attribute("emitted", 3, transfer_.emitted);
    Emitted emitted{{{relight_.file, text(relight_)}, {"relight.bin", bytes_}}, kernels_.cost()};
    emitted.files.push_back({"relight.json", json_.dump(2) + "\n"});
    for (const Shader& shader : lit_) emitted.files.push_back({shader.file, text(shader)});
    return emitted;
  }

 private:
  std::size_t add(const void* data, std::size_t size) {
    const std::size_t offset = bytes_.size();
    bytes_.append(static_cast<const char*>(data), size);
    bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
    return offset;
  }

  static std::size_t height_of(std::string_view name, std::size_t texels) {
    const std::size_t height = std::max<std::size_t>(1, (texels + kTextureWidth - 1) / kTextureWidth);
    if (height <= kTextureHeight) return height;
    throw std::invalid_argument(fmt::format("a texture of {} numbers for {}: expected at most {}; bake a lower degree",
                                            texels, name, kTextureWidth * kTextureHeight));
  }

  void add_texture(std::string_view name, Element element, const void* numbers, std::size_t bytes) {
    const std::size_t height = height_of(name, bytes / bytes_of(element));
    std::string all(static_cast<const char*>(numbers), bytes);
    all.resize(height * kTextureWidth * bytes_of(element));
    json_["textures"].push_back({{"name", name},
                                 {"offset", add(all.data(), all.size())},
                                 {"format", kFormats[static_cast<std::size_t>(element)]},
                                 {"width", kTextureWidth},
                                 {"height", height}});
  }

  void add_texture(std::string_view name, const Encoded& encoded, const TransferShape& shape) {
    add_texture(name, shape.storage.element, encoded.data.data(), encoded.data.size());
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

  // The shader that meets the light with rows of clusters: relight_ itself where rows are those of vertices, else a
  // shader of its own, whose results relight_ mixes. prefix: "" or "matrix_".
  Shader& meeting(const Clusters& clusters, std::string_view prefix) {
    if (clusters.empty()) return relight_;
    const bool is_matrix = !prefix.empty();
    const std::size_t fours = ((transfer_.kind->is_glossy() ? coefficient_count(transfer_.degree()) : 1) * 3 + 3) / 4;
    const std::size_t parts = (fours + kCaptured - 1) / kCaptured;
    const std::size_t part = (fours + parts - 1) / parts;
    const std::size_t rows = clusters.count() * (1 + clusters.vectors);
    Shader lit{is_matrix ? "lit_matrices.vert" : "lit.vert", {}, {}, {}};
    lit.define("COUNT", coefficient_count(transfer_.degree()));
    for (Shader* shader : {&relight_, &lit}) {
      if (shader == &relight_ && !lit_.empty()) continue;
      shader->define("NUMBERS", transfer_.kind->is_glossy() ? "(3 * COUNT)" : "3");
      shader->define("LIT_PART", part);
    }
    relight_.define(is_matrix ? "MATRIX_CLUSTER_ROWS" : "CLUSTER_ROWS", rows);
    relight_.define(is_matrix ? "MATRIX_VECTORS" : "VECTORS", clusters.vectors);
    const std::string texture = is_matrix ? "lit_matrices" : "lit";
    json_["lit"].push_back({{"shader", lit.file},
                            {"rows", rows},
                            {"parts", parts},
                            {"texture", texture},
                            {"format", "RGBA32F"},
                            {"width", kTextureWidth},
                            {"height", height_of(texture, parts * part * rows)}});
    add_texture(fmt::format("{}weights", prefix), Element::kByte, clusters.weights.data(), clusters.weights.size());
    add_numbers(fmt::format("{}cluster", prefix), is_matrix ? 7 : 6, 1,
                {clusters.cluster.begin(), clusters.cluster.end()});
    return lit_.emplace_back(std::move(lit));
  }

  void add_diffuse() {
    Shader& shader = meeting(transfer_.clusters, "");
    shader.define("CHANNELS", rows_.channels);
    shader.define("KEPT_COUNT", rows_.kept.size());
    if (rows_.is_masked()) {
      shader.functions +=
          fmt::format("\nconst int kept[{0}] = int[{0}]({1});\n", rows_.kept.size(), fmt::join(rows_.kept, ", "));
    }
    shader.define("KEPT(k)", rows_.is_masked() ? "kept[k]" : "(k)");
    shader.use(kernels_, "RELIGHT");
    shader.texts = {"row_sums.glsl"};
    add_texture("transfer", rows_.encoded, rows_.shape);
    json_["light"] = rows_.kept;
    std::vector<float> factors = rows_.encoded.scale;
    for (float& factor : factors) factor *= kNormalized;
    if (!factors.empty()) json_["light_factors"] = factors;  // (channels, kept)
    if (!lit_.empty()) {
      shader.texts.insert(shader.texts.end(), {"light_row_diffuse.glsl", "lit.glsl"});
      relight_.texts = {"clusters.glsl", "mixed_rows.glsl"};
    }
    if (!transfer_.shape.holds_albedo) relight_.defines += "#define RECOLORABLE\n";
    relight_.texts.push_back("relight_rows.vert");
  }

  void add_glossy() {
    const Mesh& mesh = transfer_.mesh;
    add_rows();
    add_matrices();
    const bool meets_light = transfer_.clusters.empty() || !transfer_.indirect.empty();
    if (meets_light) relight_.texts.push_back("glossy_light.glsl");
    if (!lit_.empty()) relight_.texts.push_back("clusters.glsl");
    relight_.texts.push_back("glossy.vert");
    add_attribute("normal", 2, mesh.normals);
    relight_.use(kernels_, "GATHER");
    const int degree = transfer_.degree();
    relight_.define("BANDS", degree + 1);
    std::vector<double> cosine;
    for (int l = 0; l <= degree; ++l) {
      cosine.push_back(zonal_unit(l) * numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
    }
    relight_.define("COSINE", fmt::format("float[{}]({:.9e})", cosine.size(), fmt::join(cosine, ", ")));
    relight_.use(kernels_, "ZONAL");
    if (mesh.specular.empty()) return;
    add_attribute("specular", 4, mesh.specular);
    add_numbers("exponent", 5, 1, mesh.exponent);
  }

  void add_rows() {
    if (transfer_.shape.meets == Meets::kNothing) return;
    Shader& shader = meeting(transfer_.clusters, "");
    add_texture("rows", rows_.encoded, rows_.shape);
    shader.define("ROW", rows_.shape.columns());
    if (kernels_.has("SH_EMITTED_APPLY")) shader.define("SAMPLES", sample_count(transfer_.degree()));
    shader.use(kernels_, "APPLY");
    shader.use(kernels_, "PRODUCT");
    if (&shader != &relight_) shader.texts = {"glossy_light.glsl", "light_row_direct.glsl", "lit.glsl"};
  }

  void add_matrices() {
    if (!has_matrices(transfer_)) return;
    Shader& shader = meeting(transfer_.indirect_clusters, "matrix_");
    add_texture("matrices", emitted_matrices(transfer_), transfer_.indirect_shape);
    shader.define("MATRIX_CHANNELS", transfer_.indirect_shape.channels);
    shader.use(kernels_, "MATRIX_ROW");
    if (&shader != &relight_) shader.texts = {"glossy_light.glsl", "light_row_matrix.glsl", "lit.glsl"};
  }

  [[nodiscard]] std::string text(const Shader& shader) const {
    std::string all = es_ ? "#version 300 es\n" : "#version 450 core\n";
    all += emitted_comment(transfer_, rows_, kernels_.cost());
    if (es_) all += "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
    all.append(shader.functions).append("\n").append(shader.defines);
    for (const std::string_view file : shader.texts) all.append(emitted_text(file));
    return all;
  }

  const Transfer& transfer_;
  EmittedRows rows_;
  EmittedBrdfs brdfs_;
  EmittedKernels kernels_;
  bool es_;
  Json json_;
  Shader relight_{"relight.vert", {}, {}, {}};
  std::deque<Shader> lit_;  // that the light meets clusters in
  std::string bytes_;
};

}  // namespace

Emitted emit_glsl(const Transfer& transfer, const EmitOptions& options, bool es) {
  return GlslEmitter(transfer, options, es).run();
}

}  // namespace sh::prt
