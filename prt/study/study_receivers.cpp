// The part of the study about fewer receivers (prt/plan/decide_receivers.cpp).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"
#include "prt/mesh/keep_vertices.hpp"
#include "prt/plan/plan.hpp"
#include "prt/study/study_setup.hpp"

namespace sh::prt {

namespace {

constexpr std::array kPlanErrors = {0.2, 0.1, 0.05, 0.02, 0.01, 0.005};

// Vertices that halving makes if only edges longer than this are halved.
std::vector<std::uint8_t> with_longest_edge(const Mesh& mesh, float longest) {
  std::vector<std::uint8_t> kept(mesh.positions.size(), 1);
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (!mesh.halving.is_middle(v)) continue;
    const auto [a, b] = mesh.halving.ends[v];
    kept[v] = (mesh.positions[a] - mesh.positions[b]).norm() > longest ? 1 : 0;
  }
  return with_ends(mesh, kept);
}

float shortest_halved_edge(const Mesh& mesh) {
  float shortest = std::numeric_limits<float>::max();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.halving.is_middle(v)) continue;
    const auto [a, b] = mesh.halving.ends[v];
    shortest = std::min(shortest, (mesh.positions[a] - mesh.positions[b]).norm());
  }
  return shortest;
}

// The marks of a plan that takes no other decision; all of them if it keeps all.
std::vector<std::uint8_t> of_plan(const StudySetup& setup, double error) {
  Scene scene = setup.scene;
  scene.bake.kind = &kShadowed;
  scene.bake.directions = setup.options.bounce_directions;
  scene.plan = {.mode = PlanMode::kLossy, .error = error, .turns = LightTurns::kNone};
  for (const std::string_view name : kDecisionNames) {
    if (name != kReceiversDecision) scene.plan.without.emplace_back(name);
  }
  std::vector<std::uint8_t> kept;
  on_threads(0, [&] { kept = make_plan(scene, setup.options.instruction_set).receivers; });
  return kept.empty() ? std::vector<std::uint8_t>(setup.scene.mesh.positions.size(), 1) : kept;
}

class ReceiverStudy {
 public:
  explicit ReceiverStudy(const StudySetup& setup) : setup_(setup), order_(ends_first(setup.scene.mesh.halving)) {
    colors_ = shaded(shadowed(setup, degree(), setup.options.bounce_directions), setup.light, degree());
  }

  [[nodiscard]] StudyPoint measure(const std::vector<std::uint8_t>& kept) const {
    Mesh mesh = setup_.scene.mesh;
    keep_vertices(mesh, kept);
    const double before = process_seconds();
    const Transfer transfer = shadowed(setup_, degree(), setup_.options.bounce_directions, mesh);
    const double seconds = process_seconds() - before;
    const Radiances receivers = shaded(transfer, setup_.light, degree());
    const Radiances shown = shown_by_kept(setup_.scene.mesh.halving, order_, kept, receivers);
    const auto count = static_cast<double>(receivers.size());
    return {
        .at = count,
        .error = vertex_errors(setup_.scene.mesh, setup_.scene.camera, shown, colors_).error,
        .seconds_a_vertex = seconds / count,
        .seconds = seconds,
        .bake_seconds = seconds,
        .bytes_a_vertex = count * static_cast<double>(transfer.shape.row_bytes()) / static_cast<double>(kept.size())};
  }

 private:
  [[nodiscard]] int degree() const { return setup_.scene.bake.degree; }

  const StudySetup& setup_;
  std::vector<std::uint32_t> order_;
  Radiances colors_;
};

}  // namespace

StudyPart study_receivers(const StudySetup& setup) {
  const Mesh& mesh = setup.scene.mesh;
  StudyPart part{.name = "receivers",
                 .axis = "receivers",
                 .reference = fmt::format("all {} vertices, along as many directions", mesh.positions.size())};
  if (mesh.halving.empty() || !mesh.atlases.heads.empty()) return part;
  constexpr int kEdges = 6;
  const ReceiverStudy study(setup);
  output::Progress progress("study: receivers", kEdges + kPlanErrors.size());
  StudySeries edges{.name = "longer edges everywhere"};
  float longest = 0.99F * shortest_halved_edge(mesh);
  for (int i = 0; i < kEdges; ++i) {
    longest *= 2.0F;
    StudyPoint point = study.measure(with_longest_edge(mesh, longest));
    point.label = fmt::format("{:.2g}", static_cast<double>(longest) * mesh.frame.unit);
    edges.points.push_back(std::move(point));
    progress.advance();
  }
  StudySeries plans{.name = "as plans choose them"};
  for (const double error : kPlanErrors) {
    StudyPoint point = study.measure(of_plan(setup, error));
    point.label = fmt::format("{}", error);
    plans.points.push_back(std::move(point));
    progress.advance();
  }
  progress.finish();
  part.series = {std::move(edges), std::move(plans)};
  return part;
}

}  // namespace sh::prt
