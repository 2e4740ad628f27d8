// Compression by clusters (prt/transfer/clusters.hpp) of the embedded scene's vectors with bounces and of the matrices of
// the room of prt/scenes: bytes, error, and the time of relighting, one core. Bakes both, which takes minutes. Exit 0
// whether the targets are met or not.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

#include "prt/bake/bake.hpp"
#include "prt/bake/compress.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/visibility.hpp"
#include "tests/bench/harness.hpp"

namespace {

using sh::bench::Table;
using namespace sh::prt;

constexpr double kNano = 1e9;
constexpr int kPasses = 15;

Transfer baked(Scene scene, const TransferKind& kind) {
  scene.bake.kind = &kind;
  scene.bake.degree = 4;
  return bake({std::move(scene)});
}

LightCoefficients made_up_light(int degree) {
  LightCoefficients light = LightCoefficients::zero(degree);
  for (std::size_t i = 0; i < light.values.size(); ++i) light.values[i] = 1.0 / (1.0 + static_cast<double>(i));
  return light;
}

std::string bytes_text(const TransferShape& shape, std::size_t vertices) {
  const auto all = static_cast<double>(shape.stored_bytes(vertices)) / static_cast<double>(vertices);
  return fmt::format("{} bytes a vertex and {:.2f} MiB for all: {:.1f} a vertex of {}", shape.receiver_bytes(),
                     static_cast<double>(shape.stored_rows(0) * shape.row_bytes()) / 1048576.0, all, vertices);
}

/// Prints the times of two ways to relight.
template <class Ours, class Rows>
void compare_times(Table& table, std::size_t vertices, const Ours& ours, const Rows& rows) {
  const std::vector<double> t = sh::bench::least_times({ours, rows}, kPasses);
  const double ns = kNano / static_cast<double>(vertices);
  table.remark(fmt::format("relit in {:.1f} ns a vertex; from rows in single precision {:.1f}", t[0] * ns, t[1] * ns));
}

void vectors(Table& table, const Transfer& rows, ClusterCounts counts, bool is_target) {
  Transfer transfer = rows;
  compress(transfer, counts);
  const std::size_t vertices = rows.mesh.positions.size();
  const auto share = static_cast<double>(transfer.shape.stored_bytes(vertices)) /
                     static_cast<double>(rows.shape.stored_bytes(vertices));
  const std::string what = fmt::format("DI, embedded scene, {} x {}: ", transfer.clusters.count(), counts.vectors);
  if (is_target) {
    table.figure(what + "share of the bytes", "", share, 0.09);
    table.figure(what + "error, rms over rms", "", transfer.clusters.error, 0.012);
  }
  table.remark(fmt::format("{}{:.2f} % of the bytes, error {:.5f}; {}", what, 100.0 * share, transfer.clusters.error,
                           bytes_text(transfer.shape, vertices)));
  const LightCoefficients light = made_up_light(4);
  std::vector<Eigen::Vector3f> radiance(vertices);
  compare_times(
      table, vertices, [&] { relight_into(transfer, light, radiance); }, [&] { relight_into(rows, light, radiance); });
}

/// The rms of the matrices of all vertices, those of the visibility included, over the rms of the reflected part alone:
/// columns are what lights of one coefficient give.
double total_over_indirect(const Transfer& transfer) {
  const std::size_t columns = transfer.indirect_shape.columns();
  const std::size_t rows = transfer.indirect_shape.rows();
  const std::size_t vertices = transfer.mesh.positions.size();
  std::vector<float> direct(3 * rows * vertices);
  double total = 0.0;
  double indirect = 0.0;
  for (std::size_t k = 0; k < columns; ++k) {
    std::vector<float> light(3 * columns, 0.0F);
    for (std::size_t c = 0; c < 3; ++c) light[c * columns + k] = 1.0F;
    times_visibility(transfer.degree(), transfer.rows(), prepared_light(transfer.degree(), light.data()),
                     direct.data());
    for (std::size_t v = 0; v < vertices; ++v) {
      for (std::size_t c = 0; c < transfer.indirect_shape.channels; ++c) {
        for (std::size_t i = 0; i < rows; ++i) {
          const float* matrices = transfer.indirect.data() + v * transfer.indirect_shape.length();
          const auto reflected = static_cast<double>(matrices[(c * rows + i) * columns + k]);
          indirect += reflected * reflected;
          total += std::pow(reflected + static_cast<double>(direct[(v * 3 + c) * rows + i]), 2);
        }
      }
    }
  }
  return std::sqrt(total / indirect);
}

void matrices(Table& table, const Transfer& rows, double total, ClusterCounts counts, bool is_target) {
  Transfer transfer = rows;
  compress(transfer, counts);
  const std::size_t vertices = rows.mesh.positions.size();
  const double error = transfer.indirect_clusters.error / total;
  const std::string what =
      fmt::format("GI matrices, room, {} x {}: ", transfer.indirect_clusters.count(), counts.vectors);
  if (is_target) {
    table.figure(what + "bytes a vertex", "bytes", static_cast<double>(transfer.indirect_shape.receiver_bytes()), 20.0);
    table.figure(what + "error, rms over total rms", "", error, 0.006);
  }
  table.remark(
      fmt::format("{}error {:.5f} of the total; {}", what, error, bytes_text(transfer.indirect_shape, vertices)));
  const LightCoefficients light = made_up_light(4);
  compare_times(
      table, vertices, [&] { sh::bench::keep(TransferredRadiance(transfer, light)); },
      [&] { sh::bench::keep(TransferredRadiance(rows, light)); });
}

void run(Table& table, const std::string& scenes) {
  table.section("Clusters, one core", "error of the numbers; total: with the matrices of the visibility");
  const Transfer box = baked(load_scene("demo", OnFlaw::kMend), kInterreflected);
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  vectors(table, box, {128, 8}, true);
  vectors(table, box, {256, 8}, false);
  vectors(table, box, {128, 12}, false);
  const Transfer room = baked(load_scene(scenes + "/room.json", OnFlaw::kMend), kGlossyInterreflected);
  const double total = total_over_indirect(room);
  matrices(table, room, total, {64, 8}, true);
  matrices(table, room, total, {64, 16}, false);
  matrices(table, room, total, {32, 8}, false);
}

}  // namespace

int main() {
  try {
    Table table;
    run(table, SHFORGE_SCENES);
    table.summary();
  } catch (const std::exception& error) {
    fmt::print(stderr, "cluster_bench: {}\n", error.what());
    return 2;
  }
  return 0;
}
