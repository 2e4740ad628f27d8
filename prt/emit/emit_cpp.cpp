// relight.hpp: comment, kernels, sizes, and the loops of prt/emit/text.
#include <fmt/format.h>

#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/emit/blocks.hpp"
#include "prt/emit/parts.hpp"
#include "prt/material/lobe.hpp"
#include "prt/runtime/file_shaders.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

constexpr std::string_view kElementWords[] = {"kSingle", "kHalf", "kByte"};

std::string element_of(std::string_view name, const TransferShape& shape) {
  return fmt::format("inline constexpr Element {} = Element::{};\n", name,
                     kElementWords[static_cast<std::size_t>(shape.storage.element)]);
}

class CppEmitter {
 public:
  CppEmitter(const Transfer& transfer, const EmitOptions& options)
      : transfer_(transfer),
        options_(options),
        rows_(emitted_rows(transfer, options)),
        brdfs_(emitted_brdfs(transfer)),
        kernels_(transfer, options, rows_, brdfs_, "cpp"),
        data_(transfer.mesh.positions.size()) {}

  Emitted run() {
    constant("kVertices", transfer_.mesh.positions.size());
    constant("kBlocks", emitted_blocks(transfer_.mesh.positions.size()));
    constant("kCoefficients", coefficient_count(transfer_.degree()));
    add_rows();
    const bool glossy = transfer_.kind->is_glossy();
    if (!glossy) constant("kAlbedoAt", transfer_.shape.holds_albedo ? 0 : data_.add(flat(transfer_.mesh.albedo)));
    constant("kEmittedAt", transfer_.emitted.empty() ? 0 : data_.add(flat(transfer_.emitted)));
    if (glossy) add_glossy();
    const std::string file = data_.file();
    constant("kBytes", file.size());
    constants_ += fmt::format("inline constexpr std::uint64_t kChecksum = {}ULL;\n", data_.checksum());
    return {{{"relight.hpp", header()}, {"relight.bin", file}}, kernels_.cost()};
  }

 private:
  void constant(std::string_view name, std::size_t value) {
    constants_ += fmt::format("inline constexpr std::size_t {} = {};\n", name, value);
  }

  // A section of colors, unless all are black.
  void add_colors(std::string_view name, const std::vector<Eigen::Vector3f>& colors) {
    constant(name, any_above_zero(colors) ? data_.add(flat(colors)) : 0);
  }

  // Floats with all digits.
  void numbers(std::string_view name, const std::vector<float>& values) {
    std::vector<std::string> texts;
    for (const float value : values) texts.push_back(fmt::format("{:.9e}F", value));
    constants_ += fmt::format("inline constexpr float {}[] = {{{}}};\n", name, fmt::join(texts, ", "));
  }

  std::size_t add(const Encoded& encoded, const TransferShape& shape) {
    const std::size_t rows = shape.stored_rows(transfer_.mesh.positions.size());
    return data_.add(encoded.data.data(), shape.stored_length(), bytes_of(shape.storage.element), rows);
  }

  // The clusters of rows or of matrices; their basis is in the place of the rows.
  void add_clusters(const Clusters& clusters, std::string_view prefix) {
    if (clusters.empty()) return;
    clustered_ += fmt::format("#define SH_EMITTED_{}CLUSTERS\n", prefix.empty() ? "" : "MATRIX_");
    constant(fmt::format("k{}ClusterRows", prefix), clusters.count() * (1 + clusters.vectors));
    constant(fmt::format("k{}Vectors", prefix), clusters.vectors);
    const std::size_t vertices = clusters.receivers();
    constant(fmt::format("k{}ClusterAt", prefix),
             data_.add(clusters.cluster.data(), 1, sizeof clusters.cluster[0], vertices));
    constant(fmt::format("k{}WeightsAt", prefix), data_.add(clusters.weights.data(), clusters.vectors, 1, vertices));
  }

  void add_rows() {
    const bool are_there = transfer_.shape.meets != Meets::kNothing;
    constant("kRowsAt", are_there ? add(rows_.encoded, rows_.shape) : 0);
    constant("kRow", std::max<std::size_t>(1, rows_.shape.columns()));
    constant("kChannels", rows_.channels);
    constant("kKeptCount", rows_.kept.size());
    constants_ += fmt::format("inline constexpr std::size_t kKept[] = {{{}}};\n",
                              are_there ? fmt::format("{}", fmt::join(rows_.kept, ", ")) : "0");
    elements_ = element_of("kElement", rows_.shape);
    add_clusters(transfer_.clusters, "");
    const std::vector<float>& scale = rows_.encoded.scale;
    if (are_there) numbers("kScale", scale.empty() ? std::vector<float>{1.0F} : scale);
  }

  void add_glossy() {
    const Mesh& mesh = transfer_.mesh;
    constant("kBands", static_cast<std::size_t>(transfer_.degree()) + 1);
    constant("kNormalAt", data_.add(flat(mesh.normals)));
    constant("kPositionAt", data_.add(flat(mesh.positions)));
    add_colors("kAlbedoAt", brdfs_.of_lobes(mesh.albedo));
    if (kernels_.has("SH_EMITTED_ZONAL")) add_lobes();
    if (kernels_.has("SH_EMITTED_ROTATE")) add_brdfs();
    if (kernels_.has("SH_EMITTED_PREPARE")) constant("kSamples", sample_count(transfer_.degree()));
    if (!has_matrices(transfer_)) return;
    add_clusters(transfer_.indirect_clusters, "Matrix");
    constant("kMatricesAt", add(emitted_matrices(transfer_), transfer_.indirect_shape));
    constant("kMatrixChannels", transfer_.indirect_shape.channels);
    constant("kMatrixRows", transfer_.indirect_shape.rows());
    constant("kMatrixColumns", transfer_.indirect_shape.columns());
    elements_ += element_of("kMatrixElement", transfer_.indirect_shape);
  }

  void add_lobes() {
    const Mesh& mesh = transfer_.mesh;
    const int degree = transfer_.degree();
    const std::vector<Eigen::Vector3f> specular = brdfs_.of_lobes(mesh.specular);
    const bool lobes = any_above_zero(specular);
    add_colors("kSpecularAt", specular);
    std::vector<float> lobe;
    for (std::size_t v = 0; lobes && v < mesh.exponent.size(); ++v) {
      for (int l = 0; l <= degree; ++l) {
        lobe.push_back(static_cast<float>(zonal_unit(l) * phong_factor(l, static_cast<double>(mesh.exponent[v]))));
      }
    }
    constant("kLobeAt", lobes ? data_.add(lobe) : 0);
    std::vector<float> cosine;
    for (int l = 0; l <= degree; ++l) {
      cosine.push_back(
          static_cast<float>(zonal_unit(l) * numeric::clamped_cosine_factor<double>(l) / std::numbers::pi));
    }
    numbers("kCosine", cosine);
  }

  void add_brdfs() {
    constant("kViews", kViews);
    constant("kEven", even_count(transfer_.degree()));
    constant("kTablesAt", data_.add_shared(brdfs_.tables));
    constant("kBrdfAt", data_.add(brdfs_.numbers.data(), 1, sizeof brdfs_.numbers[0], brdfs_.numbers.size()));
    add_colors("kBaseAt", brdfs_.of_bases(transfer_.mesh.albedo));
  }

  // The loops over the vertices.
  [[nodiscard]] std::string loops() const {
    if (!transfer_.kind->is_glossy()) return std::string(emitted_text("diffuse.hpp"));
    std::string text(emitted_text("glossy.hpp"));
    if (kernels_.has("SH_EMITTED_ZONAL")) text.append(emitted_text("lobes.hpp"));
    if (kernels_.has("SH_EMITTED_ROTATE")) text.append(emitted_text("brdfs.hpp"));
    return text.append(emitted_text("glossy_relight.hpp"));
  }

  // The file of a kernel, unless another run time has brought it.
  static std::string once(const EmittedKernel& kernel) {
    const std::string pragma = "#pragma once\n";
    std::string text = kernel.text;
    text.erase(text.find(pragma), pragma.size());
    return fmt::format("\n#ifndef SH_KERNEL_{0}\n#define SH_KERNEL_{0}\n{1}#endif\n", kernel.function, text);
  }

  [[nodiscard]] std::string header() const {
    std::string text = emitted_comment(transfer_, rows_, kernels_.cost());
    text += "//               relight.bin: blocks of 16 vertices, one number of all of them after the other\n";
    text += "#pragma once\n\n#include <cmath>\n#include <cstddef>\n#include <cstdint>\n#include <cstring>\n";
    text += clustered_.empty() ? "#include <type_traits>\n" : "#include <type_traits>\n#include <vector>\n";
    for (const auto& use : kernels_.all()) text += once(use.kernel);
    text.append("\n").append(emitted_text("lanes.hpp"));
    for (const auto& use : kernels_.all()) text += fmt::format("#define {} ::sh::{}\n", use.macro, use.kernel.function);
    text += clustered_;
    text += fmt::format("\nnamespace sh_{} {{\n\nenum class Element {{ kSingle, kHalf, kByte }};\n{}{}", options_.name,
                        elements_, constants_);
    text.append(emitted_text("rows.hpp"));
    if (!clustered_.empty()) text.append(emitted_text("clusters.hpp"));
    text.append(loops());
    text += fmt::format("\n}}  // namespace sh_{}\n\n", options_.name);
    for (const auto& use : kernels_.all()) text += fmt::format("#undef {}\n", use.macro);
    if (!clustered_.empty()) text += "#undef SH_EMITTED_CLUSTERS\n#undef SH_EMITTED_MATRIX_CLUSTERS\n";
    return text;
  }

  const Transfer& transfer_;
  const EmitOptions& options_;
  EmittedRows rows_;
  EmittedBrdfs brdfs_;
  EmittedKernels kernels_;
  EmittedData data_;
  std::string constants_;
  std::string elements_;
  std::string clustered_;  // macros of what is in clusters
};

}  // namespace

Emitted emit_cpp(const Transfer& transfer, const EmitOptions& options) {
  if (options.per_pixel) throw std::invalid_argument("C++ has no pixels to shade; expected GLSL, or vertices");
  return CppEmitter(transfer, options).run();
}

}  // namespace sh::prt
