// A cloud of 32^3 voxels at degree 4 with 384 directions, one thread: the direct pass against marching through the same
// cells alone, and the light between voxels against the direct pass. All tasks take turns, and the least of several passes
// counts. Exit 1 if a target is missed by more than the noise.
#include <oneapi/tbb/task_arena.h>

#include <cstdint>
#include <cstdio>
#include <limits>

#include "prt/medium/made_density.hpp"
#include "prt/medium/scattering.hpp"
#include "tests/bench/harness.hpp"

namespace {

using namespace sh::prt;

constexpr int kAlong = 32;
constexpr int kPasses = 3;

double sink = 0.0;

// Optical depths along all paths; the count of cells.
std::uint64_t march(const Scattering& scattering) {
  std::uint64_t cells = 0;
  double sum = 0.0;
  const Density& density = scattering.density();
  for (const VoxelPath& path : scattering.paths()) {
    for (std::size_t v = 0; v < density.size(); ++v) {
      const Counts place = density.place(v);
      const std::size_t start = scattering.padded().index(place[0], place[1], place[2]);
      const std::size_t length = path.length(place);
      for (std::size_t k = 0; k < length; ++k) {
        sum += VoxelPath::optical_depth(path.cells()[k], scattering.padded(), start);
      }
      cells += length;
    }
  }
  sink += sum;
  return cells;
}

// Whether the targets are met.
bool measure() {
  const Counts counts = {kAlong, kAlong, kAlong};
  std::vector<float> values = make_density(MadeDensity::kCloud, counts, 4);
  for (float& value : values) value *= 14.0F;
  const Eigen::AlignedBox3d box(Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0));
  const Density density = Density::in_box(counts, box, std::move(values));
  const Scattering scattering(density, medium_directions(4));
  std::uint64_t cells = 0;
  const std::vector<double> t = sh::bench::least_times(
      {[&] { cells = march(scattering); }, [&] { sink += double(scattering.direct(4)[0]); }}, kPasses);
  const FormFactors factors = scattering.between_voxels(0);
  Panel x(density.size(), 78);
  Panel y(density.size(), 78);
  std::fill(x.values.begin(), x.values.end(), 1.0);
  const double order = sh::bench::least_times({[&] { factors.apply(x, y); }}, 1)[0];
  sh::bench::Table table;
  table.section("Light in a cloud of 32^3 voxels, degree 4, 384 directions, one thread",
                "control: optical depths of the same cells alone");
  char text[128];
  std::snprintf(text, sizeof text, "%.3g million cells, %.3g ns each", double(cells) * 1e-6,
                t[0] / double(cells) * 1e9);
  table.remark(text);
  table.ratio("direct light", "s", t[1], t[0], "cells alone", 1.25);
  table.figure("direct light", "s", t[1], 10.0);
  std::snprintf(text, sizeof text, "one order of scattering, form factors made anew: %.3g s, %.3g times direct light",
                order, order / t[1]);
  table.remark(text);
  return table.summary();
}

}  // namespace

int main() {
  const bool met = tbb::task_arena(1).execute(measure);
  return met && sink < std::numeric_limits<double>::infinity() ? 0 : 1;
}
