// The part of the study about bounces: the error of stopping the series early. The operator is linear, so that three
// columns for the exit radiance under the scene's lights represent all coefficients; the time is that of all
// coefficients.
#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/row_tracer.hpp"
#include "prt/chunks.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr double kConverged = 1e-7;  // of the largest radiance
constexpr int kMostApplications = 2000;
constexpr double kShownError = 1e-5;  // no points below

struct Direct {
  Panel radiance;  // (vertices, 3): light that leaves without bounces
  FormFactors factors;
  double seconds = 0.0;
};

Direct trace_mesh(const StudySetup& setup, const BakeOptions& options) {
  const Mesh& mesh = setup.scene.mesh;
  const std::size_t vertices = mesh.positions.size();
  const std::size_t count = coefficient_count(options.degree);
  std::vector<float> transfer = unshadowed_transfer(options.degree, mesh.normals);
  Direct direct{Panel(vertices, 3), FormFactors(vertices)};
  const RaySetup rays(mesh, options, 0, setup.options.instruction_set);
  output::Progress progress("study: hits", vertices);
  tbb::enumerable_thread_specific<RowTracer> tracers([&] { return RowTracer(rays); });
  std::vector<Sight> sight(vertices);
  const double start = process_seconds();
  for_vertices(vertices, [&](std::size_t v) {
    RowTracer& tracer = tracers.local();
    const Gathered& seen = tracer.gatherer().gather(v);
    control_with_unshadowed(seen, count, transfer.data() + v * count);
    tracer.meet(v);
    direct.factors.keep(v, tracer.row(v));
    sight[v] = tracer.gatherer().sight(v, seen.fraction());
    progress.advance();
  });
  Fill fill(closed_vertices(mesh, sight));
  fill.apply(transfer.data(), count, count);
  direct.factors.fill_with(std::move(fill));
  const LightCoefficients light = first_bands(setup.light, options.degree);
  for (std::size_t v = 0; v < vertices; ++v) {
    as_array(direct.radiance.row(v), 3) =
        mesh.albedo[v].cast<double>().array() * integral_with(&transfer[v * count], 1, light).array();
  }
  direct.seconds = process_seconds() - start;
  progress.finish();
  return direct;
}

Radiances radiances_of(const Panel& panel) {
  Radiances radiances;
  for (std::size_t v = 0; v < panel.rows; ++v) {
    radiances.emplace_back(panel.row(v)[0], panel.row(v)[1], panel.row(v)[2]);
  }
  return radiances;
}

// One application for all coefficients, the least of two.
double seconds_of_application(const Direct& direct, const BounceLayout& layout) {
  Panel x(direct.factors.size(), layout.columns());
  Panel y(direct.factors.size(), layout.columns());
  std::fill(x.values.begin(), x.values.end(), 1.0);
  double least = 1e300;
  for (int pass = 0; pass < 2; ++pass) {
    const double start = process_seconds();
    direct.factors.apply(x, y);
    least = std::min(least, process_seconds() - start);
  }
  return least;
}

struct PartialSum {
  int terms;
  Radiances radiances;
};

// 1, 2, 3, 4, 6, 8, 12, 16, ...: powers of two and three halves of them.
bool is_shown(int terms) {
  while (terms > 3 && terms % 2 == 0) terms /= 2;
  return terms <= 3;
}

// Some of the partial sums x_k = b + A x_(k-1), and the last, which changes no more.
std::vector<PartialSum> partial_sums(const Mesh& mesh, const Direct& direct) {
  std::vector<PartialSum> sums = {{1, radiances_of(direct.radiance)}};
  Panel x = direct.radiance;
  Panel y(x.rows, 3);
  output::Progress progress("study: bounces", kMostApplications);
  for (int k = 1; k <= kMostApplications; ++k) {
    direct.factors.apply(x, y);
    double change = 0.0;
    double largest = 0.0;
    for (std::size_t v = 0; v < x.rows; ++v) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double next = direct.radiance.row(v)[c] + static_cast<double>(mesh.albedo[v][c]) * y.row(v)[c];
        change = std::max(change, std::abs(next - x.row(v)[c]));
        largest = std::max(largest, std::abs(next));
        x.row(v)[c] = next;
      }
    }
    progress.advance();
    const bool settled = change <= kConverged * largest || k == kMostApplications;
    if (is_shown(k + 1) || settled) sums.push_back({k + 1, radiances_of(x)});
    if (settled) break;
  }
  progress.finish();
  return sums;
}

}  // namespace

StudyPart study_bounces(const StudySetup& setup) {
  BakeOptions options = setup.scene.bake;
  options.directions = setup.options.bounce_directions;
  options.sampler = Sampler::kFibonacci;
  const Mesh& mesh = setup.scene.mesh;
  const Direct direct = trace_mesh(setup, options);
  const double each = seconds_of_application(direct, BounceLayout{coefficient_count(options.degree)});
  const std::vector<PartialSum> sums = partial_sums(mesh, direct);
  const StudiedVertices all = choose_vertices(mesh, setup.scene.camera, mesh.positions.size());
  StudyPart part{
      .name = "bounces",
      .axis = "terms of the series (bounces + 1)",
      .reference = fmt::format("the sum of {} terms, which changes by less than {:g}; {} directions, all vertices",
                               sums.back().terms, kConverged, options.directions)};
  StudySeries& series = part.series.emplace_back(StudySeries{.name = "bounces left out"});
  for (std::size_t i = 0; i + 1 < sums.size(); ++i) {
    const double seconds = direct.seconds + (sums[i].terms - 1) * each;
    series.points.push_back({.at = static_cast<double>(sums[i].terms),
                             .error = radiance_error(all, sums[i].radiances, sums.back().radiances),
                             .seconds_a_vertex = seconds / static_cast<double>(mesh.positions.size()),
                             .seconds = seconds});
    if (series.points.back().error.rms < kShownError) break;
  }
  if (sums.size() > 2) {
    part.fields.push_back(field_of(setup, "bounces", "no bounces (DS) against all of them (DI)", sums.front().radiances,
                                   sums.back().radiances));
  }
  return part;
}

}  // namespace sh::prt
