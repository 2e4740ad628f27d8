#include "prt/emit/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sh::prt {

namespace {

using namespace std::string_view_literals;
constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "emit_texts.inc"
};

}  // namespace

EmittedRows emitted_rows(const Transfer& transfer, const EmitOptions& options) {
  if (transfer.mesh.positions.empty()) throw std::invalid_argument("a transfer without vertices: nothing to emit");
  EmittedRows rows;
  rows.shape = transfer.shape;
  rows.kept = transfer.shape.storage.kept;
  if (rows.kept.empty()) {
    rows.kept.resize(transfer.shape.columns());
    std::iota(rows.kept.begin(), rows.kept.end(), 0U);
  }
  if (transfer.shape.meets == Meets::kNothing) return rows;
  if (transfer.shape.meets == Meets::kDot && !options.light.empty()) {
    std::erase_if(rows.kept, [&](std::uint32_t i) {
      return std::find(options.light.begin(), options.light.end(), i) == options.light.end();
    });
    if (rows.kept.empty()) throw std::invalid_argument("the transfer keeps no coefficient that the lights have");
  }
  rows.shape.storage.kept = rows.is_masked() ? rows.kept : std::vector<std::uint32_t>();
  rows.channels = rows.shape.storage.one_channel ? 1 : rows.shape.channels;
  Encoded made;
  const Encoded& all = transfer.encoded_rows(made);
  rows.encoded = rows.is_masked() ? with_columns(all, transfer.shape, rows.kept) : all;
  return rows;
}

Encoded emitted_matrices(const Transfer& transfer) {
  if (transfer.indirect_shape.storage.element == Element::kByte) {
    throw std::invalid_argument("matrices of 8 bits: expected single or half precision");
  }
  Encoded made;
  return transfer.encoded_matrices(made);
}

EmittedKernels::EmittedKernels(const Transfer& transfer, const EmitOptions& options, const EmittedRows& rows,
                               const EmittedBrdfs& brdfs, std::string language)
    : transfer_(transfer),
      options_(options),
      rows_(rows),
      brdfs_(brdfs),
      language_(std::move(language)),
      degree_(transfer.degree()) {
  transfer.kind->is_glossy() ? add_glossy() : add_diffuse();
}

bool EmittedKernels::has(std::string_view macro) const {
  return std::any_of(all_.begin(), all_.end(), [&](const Use& use) { return use.macro == macro; });
}

void EmittedKernels::add_diffuse() {
  Nonzero nonzero;
  if (rows_.is_masked()) nonzero = {rows_.kept, rows_.kept};
  const char* colored = rows_.channels == 3 ? "relight_colored" : "relight_rgb";
  use("SH_EMITTED_RELIGHT", emitted_kernel(colored, degree_, language_, nonzero), times_a_vertex(rows_.shape, 3));
  use("SH_EMITTED_RELIGHT_WHITE", emitted_kernel("relight", degree_, language_, nonzero));
}

void EmittedKernels::add_glossy() {
  if (!brdfs_.serve_all) use("SH_EMITTED_ZONAL", emitted_kernel("zonal", degree_, language_));
  if (!brdfs_.numbers.empty()) use("SH_EMITTED_ROTATE", emitted_rotation(degree_, language_));
  use("SH_EMITTED_GATHER", emitted_kernel("relight_rgb", degree_, language_));
  if (transfer_.shape.meets == Meets::kOperator) add_operator();
  if (!has_matrices(transfer_)) return;
  const TransferShape& matrices = transfer_.indirect_shape;
  std::vector<std::uint32_t> light = options_.light;
  std::erase_if(light, [&](std::uint32_t i) { return i >= matrices.columns(); });
  const char* row = matrices.channels == 3 ? "relight_colored" : "relight_rgb";
  use("SH_EMITTED_MATRIX_ROW", emitted_kernel(row, matrices.degree, language_, {light, light}),
      times_a_vertex(matrices, 3 * matrices.rows()) * static_cast<int>(matrices.rows()));
}

// The quadrature with the light's samples, or the product with fewer coefficients, whichever has fewer operations.
void EmittedKernels::add_operator() {
  const std::vector<std::uint32_t> kept = rows_.is_masked() ? rows_.kept : std::vector<std::uint32_t>();
  const EmittedKernel apply = emitted_kernel("transfer_apply_rgb", degree_, language_, {kept, {}});
  if (!options_.light.empty()) {
    constexpr int kChannels = 3;
    EmittedKernel product = emitted_product(degree_, language_, {kept, options_.light});
    if (kChannels * product.operations < apply.operations) {
      const int times = times_a_vertex(rows_.shape, kChannels * coefficient_count(degree_));
      use("SH_EMITTED_PRODUCT", product);
      cost_.operations += times * kChannels * product.operations;
      cost_.unmasked += times * apply.unmasked;
      return;
    }
  }
  use("SH_EMITTED_APPLY", apply, times_a_vertex(rows_.shape, 3 * coefficient_count(degree_)));
  use("SH_EMITTED_PREPARE", emitted_kernel("transfer_prepare", degree_, language_));
}

// How often a vertex runs the kernels of its rows: the light meets clusters beforehand, and a vertex mixes `numbers`.
int EmittedKernels::times_a_vertex(const TransferShape& shape, std::size_t numbers) {
  if (!shape.storage.is_clustered()) return 1;
  const auto mixing = static_cast<int>(2 * shape.storage.vectors * numbers);
  cost_.operations += mixing;
  cost_.unmasked += mixing;
  return 0;
}

void EmittedKernels::use(std::string_view macro, const EmittedKernel& kernel, int times_for_the_light) {
  cost_.operations += times_for_the_light * kernel.operations;
  cost_.unmasked += times_for_the_light * kernel.unmasked;
  all_.push_back({macro, kernel});
}

bool has_matrices(const Transfer& transfer) {
  return transfer.matrices().count() > 0 || !transfer.indirect_clusters.empty();
}

std::string emitted_comment(const Transfer& transfer, const EmittedRows& rows, const EmittedCost& cost) {
  const PlanRecord& plan = transfer.plan;
  const std::size_t numbers = transfer.shape.meets == Meets::kNothing ? 0 : rows.channels * rows.kept.size();
  const Storage& storage = transfer.shape.storage;
  const std::string clusters =
      storage.is_clustered()
          ? fmt::format("{} weights and the number of a cluster a vertex; clusters of ", storage.vectors)
          : "";
  std::string text = fmt::format(
      "// The run time of one transfer file: {} of degree {}, {} vertices.\n//\n"
      "// Generated by: prt emit; relight.bin holds its numbers.\n// Licence:      MIT-0; paste it anywhere.\n//\n"
      "// Rows:         {}{} numbers{}, {} precision\n"
      "// Cost:         {} operations a vertex for the light; {} without the mask\n",
      transfer.kind->letters, transfer.degree(), transfer.mesh.positions.size(), clusters, numbers,
      storage.is_clustered() ? "" : " a vertex",
      kElementNames[static_cast<std::size_t>(transfer.shape.storage.element)], cost.operations, cost.unmasked);
  if (has_matrices(transfer)) {
    const TransferShape& matrices = transfer.indirect_shape;
    text += fmt::format("// Matrices:     {} of {} x {} numbers, {} precision{}\n", matrices.channels, matrices.rows(),
                        matrices.columns(), kElementNames[static_cast<std::size_t>(matrices.storage.element)],
                        matrices.storage.is_clustered() ? ", in clusters" : " a vertex");
  }
  if (plan.budget > 0.0) {
    return text + fmt::format("// Error:        {:.2g} of the largest unshadowed radiance, as the bake's plan states\n",
                              plan.error);
  }
  return text + "// Error:        that of rounding; each kernel states its own\n";
}

std::vector<float> flat(const std::vector<Eigen::Vector3f>& values) {
  std::vector<float> numbers;
  for (const Eigen::Vector3f& value : values) numbers.insert(numbers.end(), value.data(), value.data() + 3);
  return numbers;
}

bool any_above_zero(const std::vector<Eigen::Vector3f>& values) {
  return std::any_of(values.begin(), values.end(), [](const Eigen::Vector3f& value) { return !value.isZero(0.0F); });
}

std::string_view emitted_text(std::string_view file) {
  return std::find_if(std::begin(kTexts), std::end(kTexts), [&](const auto& text) { return text.first == file; })
      ->second;
}

}  // namespace sh::prt
