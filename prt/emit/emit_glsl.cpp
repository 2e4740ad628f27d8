// relight.vert and relight.frag: comment, kernels, sizes, and the texts of prt/shaders; relight.json: how relight.bin is laid
// out.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/zonal.hpp"
#include "prt/emit/shaders.hpp"
#include "prt/runtime/file_shaders.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/shading_normals.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

// The most vec4s of a vertex that OpenGL ES 3.0 captures.
constexpr std::size_t kCaptured = 15;

// The most vec4s that graphics cards interpolate between vertices, of which OpenGL promises 15.
constexpr std::size_t kInterpolated = 31;

constexpr float kNormalized = 127.0F;  // R8_SNORM reads q / 127

class GlslEmitter {
 public:
  GlslEmitter(const Transfer& transfer, const EmitOptions& options, bool es)
      : transfer_(transfer),
        rows_(emitted_rows(transfer, options)),
        brdfs_(emitted_brdfs(transfer)),
        kernels_(transfer, options, rows_, brdfs_, es ? "glsl-es" : "glsl"),
        per_pixel_(options.per_pixel),
        es_(es) {
    relight_.define("COUNT", coefficient_count(transfer.degree()));
    if (per_pixel_) require_pixels();
  }

  Emitted run() {
    const bool glossy = transfer_.kind->is_glossy();
    data_.json["vertices"] = transfer_.mesh.positions.size();
    glossy ? add_glossy() : add_diffuse();
    data_.add_attribute("position", 0, transfer_.mesh.positions);
    if (!transfer_.shape.holds_albedo) data_.add_attribute("albedo", 1, transfer_.mesh.albedo);
    if (!transfer_.emitted.empty()) data_.add_attribute("emitted", 3, transfer_.emitted);
    Emitted emitted{{{relight_.file, text(relight_)}, {"relight.bin", data_.bytes()}}, kernels_.cost()};
    emitted.files.push_back({"relight.json", data_.json.dump(2) + "\n"});
    for (const Shader& shader : lit_) emitted.files.push_back({shader.file, text(shader)});
    if (per_pixel_) emitted.files.push_back({pixel_.file, text(pixel_)});
    return emitted;
  }

 private:
  void require_pixels() const {
    const Mesh& mesh = transfer_.mesh;
    if (!transfer_.kind->is_glossy()) {
      throw std::invalid_argument(
          fmt::format("transfer of kind {} is exit radiance, which pixels interpolate; expected a glossy kind, or the "
                      "shader of vertices",
                      transfer_.kind->letters));
    }
    if (!mesh.atlases.heads.empty()) {
      throw std::invalid_argument(
          "its receivers are texels of an atlas, between which its pixels do not interpolate; expected receivers at "
          "vertices alone, or the shader of vertices");
    }
    if (!has_one_finish(mesh)) {
      throw std::invalid_argument(
          "some of its faces have several BRDFs or lobes, between which a pixel cannot choose; expected one material a "
          "face, or the shader of vertices");
    }
  }

  // The shader that meets the light with rows of clusters: relight_ itself where rows are those of vertices, else a
  // shader of its own, whose results relight_ mixes. prefix: "" or "matrix_".
  Shader& meeting(const Clusters& clusters, std::string_view prefix) {
    if (clusters.empty()) return relight_;
    const bool is_matrix = !prefix.empty();
    const bool is_glossy = transfer_.kind->is_glossy();
    const std::size_t given = is_matrix   ? transfer_.indirect_shape.rows()
                              : is_glossy ? coefficient_count(transfer_.degree())
                                          : 1;
    const std::size_t fours = (3 * given + 3) / 4;
    const std::size_t most = es_ ? 1 : kCaptured;  // WebGL captures no arrays
    const std::size_t parts = (fours + most - 1) / most;
    const std::size_t part = (fours + parts - 1) / parts;
    const std::size_t rows = clusters.count() * (1 + clusters.vectors);
    Shader lit{is_matrix ? "lit_matrices.vert" : "lit.vert", {}, {}, {}};
    lit.define("COUNT", coefficient_count(transfer_.degree()));
    if (lit_.empty()) relight_.define("NUMBERS", is_glossy ? "(3 * COUNT)" : "3");
    relight_.define(is_matrix ? "MATRIX_LIT_PART" : "LIT_PART", part);
    lit.define("NUMBERS", 3 * given);
    lit.define("LIT_PART", part);
    relight_.define(is_matrix ? "MATRIX_CLUSTER_ROWS" : "CLUSTER_ROWS", rows);
    relight_.define(is_matrix ? "MATRIX_VECTORS" : "VECTORS", clusters.vectors);
    const std::string texture = is_matrix ? "lit_matrices" : "lit";
    data_.json["lit"].push_back({{"shader", lit.file},
                                 {"rows", rows},
                                 {"parts", parts},
                                 {"texture", texture},
                                 {"format", "RGBA32F"},
                                 {"width", kTextureWidth},
                                 {"height", ShaderData::height_of(texture, parts * part * rows)}});
    data_.add_texture(fmt::format("{}weights", prefix), Element::kByte, clusters.weights.data(),
                      clusters.weights.size());
    data_.add_number(fmt::format("{}cluster", prefix), is_matrix ? 7 : 6,
                     {clusters.cluster.begin(), clusters.cluster.end()});
    return lit_.emplace_back(std::move(lit));
  }

  void define_kept(Shader& shader) const {
    shader.define("KEPT_COUNT", rows_.kept.size());
    if (rows_.is_masked()) {
      shader.functions +=
          fmt::format("\nconst int kept[{0}] = int[{0}]({1});\n", rows_.kept.size(), fmt::join(rows_.kept, ", "));
    }
    shader.define("KEPT(k)", rows_.is_masked() ? "kept[k]" : "(k)");
  }

  void add_diffuse() {
    Shader& shader = meeting(transfer_.clusters, "");
    shader.define("CHANNELS", rows_.channels);
    define_kept(shader);
    shader.use(kernels_, "RELIGHT");
    shader.texts = {"row_sums.glsl"};
    data_.add_texture("transfer", rows_.encoded, rows_.shape);
    data_.json["light"] = rows_.kept;
    const std::vector<float> factors = scale_of_texels();
    if (!factors.empty()) data_.json["light_factors"] = factors;  // (channels, kept)
    if (!lit_.empty()) {
      shader.texts.insert(shader.texts.end(), {"light_row_diffuse.glsl", "lit.glsl"});
      relight_.texts = {"clusters.glsl", "mixed_rows.glsl"};
    }
    if (!transfer_.shape.holds_albedo) relight_.defines += "#define RECOLORABLE\n";
    relight_.texts.emplace_back("relight_rows.vert");
  }

  void add_glossy() {
    add_rows();
    add_matrices();
    const bool meets_light = transfer_.clusters.empty() || transfer_.matrices().count() > 0;
    if (meets_light) relight_.texts.emplace_back("glossy_light.glsl");
    if (!lit_.empty()) relight_.texts.emplace_back("clusters.glsl");
    relight_.texts.emplace_back("glossy.vert");
    data_.add_attribute("normal", 2, transfer_.mesh.normals);
    if (per_pixel_) add_pixels();
    add_exit(per_pixel_ ? pixel_ : relight_);
    relight_.texts.emplace_back(per_pixel_ ? "glossy_pixels.vert" : "glossy_relight.vert");
    if (per_pixel_) pixel_.texts.insert(pixel_.texts.end(), {"glossy_pixel.glsl", "glossy.frag"});
  }

  // What leaves a place.
  void add_exit(Shader& shader) {
    shader.texts.emplace_back("exit.glsl");
    shader.use(kernels_, "GATHER");
    shader.define("BANDS", transfer_.degree() + 1);
    if (kernels_.has("SH_EMITTED_ZONAL")) add_lobes(shader);
    if (kernels_.has("SH_EMITTED_ROTATE")) add_brdfs(shader);
    shader.texts.emplace_back("exit_radiance.glsl");
  }

  // Of both shaders.
  void define(std::string_view name) {
    relight_.define(name, 1);
    if (per_pixel_) pixel_.define(name, 1);
  }

  void add_pixels() {
    pixel_.define("COUNT", coefficient_count(transfer_.degree()));
    relight_.define("BETWEEN", "out");
    pixel_.define("BETWEEN", "in");
    if (!transfer_.emitted.empty()) define("EMITTED");
    const std::size_t carried = vectors_carried(transfer_);
    if (carried == 0) {
      pixel_.texts.emplace_back("glossy_light.glsl");
    } else {
      relight_.define("CARRIED", carried);
      pixel_.define("CARRIED", carried);
    }
    const bool has_maps = !transfer_.mesh.normal_map.empty();
    const std::size_t vectors = vectors_between(transfer_);
    if (vectors > kInterpolated) {
      throw std::invalid_argument(
          fmt::format("its vertices hand {} 4-vectors on to pixels, of which graphics cards take {}; expected a lower "
                      "degree, or the shader of vertices",
                      vectors, kInterpolated));
    }
    data_.json["between"] = {{"shader", pixel_.file}, {"vectors", vectors}};
    relight_.texts.emplace_back("pixels.glsl");
    pixel_.texts.emplace_back("pixels.glsl");
    data_.add_faces(transfer_.mesh.faces);
    if (has_maps) add_maps();
  }

  void add_maps() {
    const Mesh& mesh = transfer_.mesh;
    define("MAPS");
    std::vector<Eigen::Vector3f> places;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      places.emplace_back(mesh.texture[v].x(), mesh.texture[v].y(), static_cast<float>(mesh.normal_map[v]));
    }
    data_.add_attribute("texture_place", 9, places);
    const ShadingNormals normals(mesh);
    data_.add_attribute("tangent", 10, normals.tangents(false));
    data_.add_attribute("mirrored_tangent", 11, normals.tangents(true));
    pixel_.functions.append("\n").append(places_of_maps(mesh.normal_maps));
    data_.add_texture("normals", Element::kHalf, mesh.normal_maps.texels.data(),
                      mesh.normal_maps.texels.size() * sizeof(Eigen::half));
    pixel_.texts.emplace_back("normal_maps.glsl");
  }

  void add_lobes(Shader& shader) {
    define("LOBES");
    const int degree = transfer_.degree();
    std::vector<double> cosine;
    for (int l = 0; l <= degree; ++l) {
      cosine.push_back(zonal_unit(l) * numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
    }
    shader.define("COSINE", fmt::format("float[{}]({:.9e})", cosine.size(), fmt::join(cosine, ", ")));
    shader.use(kernels_, "ZONAL");
    shader.texts.emplace_back("lobes.glsl");
    if (transfer_.mesh.specular.empty()) return;
    data_.add_attribute("specular", 4, transfer_.mesh.specular);
    data_.add_number("exponent", 5, transfer_.mesh.exponent);
  }

  void add_brdfs(Shader& shader) {
    define("BRDFS");
    shader.define("VIEWS", kViews);
    shader.define("EVEN", even_count(transfer_.degree()));
    shader.use(kernels_, "ROTATE");
    shader.texts.emplace_back("brdfs.glsl");
    data_.add_texture("tables", Element::kSingle, brdfs_.tables.data(), brdfs_.tables.size() * sizeof(float));
    data_.add_number("brdf", 8, {brdfs_.numbers.begin(), brdfs_.numbers.end()});
  }

  // What a column's texels have to be multiplied with; nothing for rows of floats.
  [[nodiscard]] std::vector<float> scale_of_texels() const {
    std::vector<float> factors = rows_.encoded.scale;
    for (float& factor : factors) factor *= kNormalized;
    return factors;
  }

  void add_rows() {
    if (transfer_.shape.meets == Meets::kNothing) return;
    Shader& shader = meeting(transfer_.clusters, "");
    data_.add_texture("rows", rows_.encoded, rows_.shape);
    shader.define("ROW", rows_.shape.columns());
    define_kept(shader);
    if (const std::vector<float> scale = scale_of_texels(); !scale.empty()) {
      shader.functions +=
          fmt::format("\nconst float row_scale[{0}] = float[{0}]({1:.9e});\n", scale.size(), fmt::join(scale, ", "));
      shader.define("ROW_SCALE", 1);
    }
    if (kernels_.has("SH_EMITTED_APPLY")) shader.define("SAMPLES", sample_count(transfer_.degree()));
    shader.use(kernels_, "APPLY");
    shader.use(kernels_, "PRODUCT");
    if (&shader != &relight_) shader.texts = {"glossy_light.glsl", "light_row_direct.glsl", "lit.glsl"};
  }

  void add_matrices() {
    if (!has_matrices(transfer_)) return;
    Shader& shader = meeting(transfer_.indirect_clusters, "matrix_");
    data_.add_texture("matrices", emitted_matrices(transfer_), transfer_.indirect_shape);
    shader.define("MATRIX_CHANNELS", transfer_.indirect_shape.channels);
    shader.define("MATRIX_COLUMNS", transfer_.indirect_shape.columns());
    relight_.define("MATRIX_ROWS", transfer_.indirect_shape.rows());
    if (&shader != &relight_) shader.define("MATRIX_ROWS", transfer_.indirect_shape.rows());
    shader.use(kernels_, "MATRIX_ROW");
    if (&shader != &relight_) shader.texts = {"glossy_light.glsl", "light_row_matrix.glsl", "lit.glsl"};
  }

  [[nodiscard]] std::string text(const Shader& shader) const {
    std::string all = es_ ? "#version 300 es\n" : "#version 450 core\n";
    all += emitted_comment(transfer_, rows_, kernels_.cost());
    all.append(emitted_text("numbers.glsl")).append(shader.functions).append("\n").append(shader.defines);
    for (const std::string_view file : shader.texts) all.append(emitted_text(file));
    return all;
  }

  const Transfer& transfer_;
  EmittedRows rows_;
  EmittedBrdfs brdfs_;
  EmittedKernels kernels_;
  bool per_pixel_;
  bool es_;
  ShaderData data_;
  Shader relight_{"relight.vert", {}, {}, {}};
  Shader pixel_{"relight.frag", {}, {}, {}};  // if per_pixel_: what leaves the surfaces
  std::deque<Shader> lit_;                    // that the light meets clusters in
};

}  // namespace

Emitted emit_glsl(const Transfer& transfer, const EmitOptions& options, bool es) {
  return GlslEmitter(transfer, options, es).run();
}

}  // namespace sh::prt
