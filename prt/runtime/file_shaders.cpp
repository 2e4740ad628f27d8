#include "prt/runtime/file_shaders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "numeric/oracle/zonal.hpp"
#include "prt/material/reflectance.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/shader_texts.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {
namespace {

/// A shader in the making: generated functions, macros, and the texts that use them.
class ShaderWriter {
 public:
  template <class Value>
  void define(std::string_view name, const Value& value) {
    defines_ += fmt::format("#define {} {}\n", name, value);
  }
  /// The generated function of a family under the name `macro`.
  void use(std::string_view macro, std::string_view family, int degree) {
    const std::string name = kernel_name(family, degree);
    if (functions_.find(fmt::format(" {}(", name)) == std::string::npos) {
      functions_ += shader_text(name + ".glsl");  // may serve twice
    }
    define(macro, name);
  }
  void declare(std::string_view text) { defines_ += text; }
  void add(std::string_view file) { texts_ += shader_text(file); }
  [[nodiscard]] std::string text(const Transfer& transfer) const {
    return fmt::format(
        "#version 300 es\n// Relights transfer {} of degree {} from the numbers of its file.\n"
        "#define PACKED\n{}{}\n{}{}",
        transfer.kind->letters, transfer.degree(), shader_text("numbers.glsl"), functions_, defines_, texts_);
  }

 private:
  std::string functions_;
  std::string defines_;
  std::string texts_;
};

class FileShadersWriter {
 public:
  explicit FileShadersWriter(const Transfer& transfer) : transfer_(transfer) {
    relight_.define("COUNT", coefficient_count(transfer.degree()));
  }

  FileShaders run(bool has_pixels) {
    if (transfer_.kind->is_glossy()) {
      add_glossy();
      if (has_pixels) add_pixels();
      add_exit(relight_);
      relight_.add("glossy_relight.vert");
    } else if (transfer_.shape.rows() > 1) {
      add_medium();
    } else {
      add_diffuse();
    }
    shaders_.relight = relight_.text(transfer_);
    return std::move(shaders_);
  }

 private:
  /// Writes a pass in which the light meets clusters, if rows are clustered; `write` adds what meets it. Without clusters
  /// `write` adds to the relighting shader itself.
  template <class Write>
  void meet(const TransferShape& shape, std::size_t given, std::string_view prefix, const Write& write) {
    if (!shape.storage.is_clustered()) return write(relight_);
    const std::size_t parts = (3 * given + 3) / 4;
    const std::size_t rows = shape.stored_rows(0);
    ShaderWriter lit;
    lit.define("COUNT", coefficient_count(transfer_.degree()));
    lit.define("NUMBERS", 3 * given);
    lit.define("LIT_PART", 1);
    write(lit);
    lit.add("lit.glsl");
    if (shaders_.lit.empty()) relight_.define("NUMBERS", transfer_.kind->is_glossy() ? "(3 * COUNT)" : "3");
    relight_.define(fmt::format("{}LIT_PART", prefix), 1);
    relight_.define(fmt::format("{}CLUSTER_ROWS", prefix), rows);
    relight_.define(fmt::format("{}VECTORS", prefix), shape.storage.vectors);
    shaders_.lit.push_back({lit.text(transfer_), prefix.empty() ? "lit" : "lit_matrices", rows, parts});
  }

  void define_kept(ShaderWriter& shader) const {
    const std::vector<std::uint32_t>& kept = transfer_.shape.storage.kept;
    shader.define("KEPT_COUNT", kept.empty() ? transfer_.shape.columns() : kept.size());
    if (!kept.empty()) {
      shader.declare(fmt::format("const int kept[{0}] = int[{0}]({1});\n", kept.size(), fmt::join(kept, ", ")));
    }
    shader.define("KEPT(k)", kept.empty() ? "(k)" : "kept[k]");
  }

  void add_diffuse() {
    const TransferShape& shape = transfer_.shape;
    const bool is_clustered = shape.storage.is_clustered();
    meet(shape, 1, "", [&](ShaderWriter& shader) {
      const std::size_t channels = shape.storage.one_channel ? 1 : shape.channels;
      shader.define("CHANNELS", channels);
      define_kept(shader);
      shader.use("RELIGHT", channels == 3 ? "relight_colored" : "relight_rgb", shape.degree);
      shader.add("row_sums.glsl");
      if (is_clustered) shader.add("light_row_diffuse.glsl");
    });
    if (is_clustered) {
      relight_.add("clusters.glsl");
      relight_.add("mixed_rows.glsl");
    }
    if (!shape.holds_albedo) relight_.declare("#define RECOLORABLE\n");
    relight_.add("relight_rows.vert");
  }

  /// Rows are not clustered: those of media never are.
  void add_medium() {
    const TransferShape& shape = transfer_.shape;
    const PointGrid& grid = transfer_.grid.value();
    relight_.define("CHANNELS", shape.channels);
    relight_.define("ROWS", shape.rows());
    relight_.define("ROW_OF(n, c)", "(((n) / ROWS * CHANNELS + (c)) * ROWS + (n) % ROWS)");
    define_kept(relight_);
    relight_.use("RELIGHT", "relight_colored", shape.degree);
    relight_.use("BASIS", "basis", shape.result_degree);
    const Eigen::Vector3d cell = grid.spacing();
    relight_.declare(fmt::format("const ivec2 grid = ivec2({}, {});\nconst vec3 cell = vec3({:.9e}, {:.9e}, {:.9e});\n",
                                 grid.counts[0], grid.counts[1], cell.x(), cell.y(), cell.z()));
    relight_.add("row_sums.glsl");
    relight_.add("relight_medium.vert");
  }

  void add_glossy() {
    const TransferShape& shape = transfer_.shape;
    const TransferShape& matrices = transfer_.indirect_shape;
    const bool has_matrices = transfer_.kind->stores_matrices();
    const auto direct = [&](ShaderWriter& shader) { add_visibility(shader); };
    const auto indirect = [&](ShaderWriter& shader) { add_matrices(shader); };
    const bool meets_light = !shape.storage.is_clustered() || (has_matrices && !matrices.storage.is_clustered());
    meet(shape, coefficient_count(transfer_.degree()), "", [&](ShaderWriter& shader) {
      direct(shader);
      if (&shader == &relight_) return;
      shader.add("glossy_light.glsl");
      shader.add("light_row_direct.glsl");
    });
    if (has_matrices) {
      meet(matrices, matrices.rows(), "MATRIX_", [&](ShaderWriter& shader) {
        indirect(shader);
        if (&shader == &relight_) return;
        shader.add("glossy_light.glsl");
        shader.add("light_row_matrix.glsl");
      });
      relight_.define("MATRIX_ROWS", matrices.rows());
    }
    if (meets_light) relight_.add("glossy_light.glsl");
    if (!shaders_.lit.empty()) relight_.add("clusters.glsl");
    relight_.define("LOBES", 1);
    if (!transfer_.mesh.brdfs.heads.empty()) relight_.define("BRDFS", 1);
    relight_.add("glossy.vert");
  }

  /// The two shaders of pixels, from what the vertex shader has so far.
  void add_pixels() {
    ShaderWriter vertex = relight_;
    ShaderWriter pixel;
    pixel.define("COUNT", coefficient_count(transfer_.degree()));
    pixel.define("LOBES", 1);
    if (!transfer_.mesh.brdfs.heads.empty()) pixel.define("BRDFS", 1);
    vertex.define("BETWEEN", "out");
    pixel.define("BETWEEN", "in");
    const auto both = [&](std::string_view name, std::size_t value) {
      vertex.define(name, value);
      pixel.define(name, value);
    };
    if (!transfer_.emitted.empty()) both("EMITTED", 1);
    if (const std::size_t carried = vectors_carried(transfer_); carried > 0) {
      both("CARRIED", carried);
    } else {
      pixel.add("glossy_light.glsl");
    }
    if (!transfer_.mesh.albedo_map.empty()) both("PICTURES", 1);
    const bool has_maps = !transfer_.mesh.normal_map.empty();
    if (has_maps) both("MAPS", 1);
    std::optional<LitPass> texels;
    if (!transfer_.mesh.atlases.heads.empty()) {
      both("ATLASES", 1);
      texels = add_texels(pixel);
    }
    vertex.add("pixels.glsl");
    vertex.add("glossy_pixels.vert");
    pixel.add("pixels.glsl");
    if (has_maps) {
      pixel.declare(places_of_maps(transfer_.mesh.normal_maps));
      pixel.add("normal_maps.glsl");
    }
    add_exit(pixel);
    pixel.add("glossy_pixel.glsl");
    shaders_.pixels = PixelShaders{vertex.text(transfer_), pixel.text(transfer_), vectors_between(transfer_), texels};
  }

  /// The pass that gathers what the pixels of atlases read, and their functions.
  LitPass add_texels(ShaderWriter& pixel) const {
    const std::size_t receivers = transfer_.mesh.positions.size();
    const std::size_t carried = vectors_carried(transfer_);
    const std::size_t parts = carried + 1;
    pixel.define("VERTICES", receivers);
    pixel.define("OF_TEXEL", parts);
    pixel.add("atlas.glsl");
    pixel.add("texels.glsl");
    ShaderWriter receiver = relight_;
    if (carried > 0) receiver.define("CARRIED", carried);
    receiver.add("of_texels.vert");
    return {receiver.text(transfer_), "of_texels", receivers, parts};
  }

  void add_visibility(ShaderWriter& shader) const {
    if (transfer_.shape.meets == Meets::kNothing) return;
    shader.define("ROW", transfer_.shape.columns());
    define_kept(shader);
    if (transfer_.shape.storage.element == Element::kByte) {
      shader.declare("uniform float row_scale[KEPT_COUNT];\n#define ROW_SCALE 1\n");
    }
    shader.define("SAMPLES", sample_count(transfer_.degree()));
    shader.use("APPLY", "transfer_apply_rgb", transfer_.degree());
  }

  void add_matrices(ShaderWriter& shader) const {
    const TransferShape& matrices = transfer_.indirect_shape;
    shader.define("MATRIX_CHANNELS", matrices.channels);
    shader.define("MATRIX_COLUMNS", matrices.columns());
    if (&shader != &relight_) shader.define("MATRIX_ROWS", matrices.rows());
    shader.use("MATRIX_ROW", matrices.channels == 3 ? "relight_colored" : "relight_rgb", matrices.degree);
  }

  /// What leaves a place.
  void add_exit(ShaderWriter& shader) const {
    const int degree = transfer_.degree();
    shader.add("exit.glsl");
    shader.use("GATHER", "relight_rgb", degree);
    shader.define("BANDS", degree + 1);
    std::vector<double> cosine;
    for (int l = 0; l <= degree; ++l) {
      cosine.push_back(zonal_unit(l) * numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
    }
    shader.define("COSINE", fmt::format("float[{}]({:.9e})", cosine.size(), fmt::join(cosine, ", ")));
    shader.use("ZONAL", "zonal", degree);
    shader.add("lobes.glsl");
    if (!transfer_.mesh.brdfs.heads.empty()) {
      shader.define("VIEWS", kViews);
      shader.define("EVEN", even_count(degree));
      shader.use("ROTATE", "rotate", degree);
      shader.add("brdfs.glsl");
    }
    shader.add("exit_radiance.glsl");
  }

  const Transfer& transfer_;
  ShaderWriter relight_;
  FileShaders shaders_;
};

}  // namespace

std::size_t vectors_carried(const Transfer& transfer) {
  const bool is_uniform = transfer.shape.meets == Meets::kNothing;
  return is_uniform ? 0 : (3 * coefficient_count(transfer.degree()) + 3) / 4;
}

std::size_t vectors_between(const Transfer& transfer) {
  constexpr std::size_t kOthers = 6;  // position, normal, albedo, lobe, BRDF, emitted
  constexpr std::size_t kOfMaps = 3;
  constexpr std::size_t kOfPictures = 2;
  return vectors_carried(transfer) + kOthers + (transfer.mesh.normal_map.empty() ? 0 : kOfMaps) +
         (transfer.mesh.albedo_map.empty() ? 0 : kOfPictures) + (transfer.mesh.atlases.heads.empty() ? 0 : 1);
}

std::string places_of_maps(const NormalMaps& maps) {
  std::vector<std::size_t> first{0};
  std::vector<int> width;
  std::vector<int> height;
  for (const NormalMaps::Head& head : maps.heads) {
    width.push_back(head.width);
    height.push_back(head.height);
    first.push_back(first.back() + static_cast<std::size_t>(head.width) * static_cast<std::size_t>(head.height));
  }
  first.pop_back();
  const auto constant = [](std::string_view name, const auto& values) {
    return fmt::format("const int {0}[{1}] = int[{1}]({2});\n", name, values.size(), fmt::join(values, ", "));
  };
  return constant("map_first", first) + constant("map_width", width) + constant("map_height", height);
}

FileShaders file_shaders(const Transfer& transfer) {
  return FileShadersWriter(transfer).run(has_one_finish(transfer.mesh));
}

}  // namespace sh::prt
