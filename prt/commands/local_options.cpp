// `--local`: samples near lights at several points.
#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "prt/commands/subject.hpp"
#include "prt/light/local_light.hpp"

namespace sh::prt {
namespace {

LightSamples samples_named(const std::string& local, const Mesh& mesh) {
  if (local == "octahedron") return samples_on_octahedron(mesh.positions);
  int k = 0;
  const auto end = std::from_chars(local.data(), local.data() + local.size(), k);
  if (end.ec != std::errc() || end.ptr != local.data() + local.size() || k < 1 || k > kMaxLightSamples) {
    throw std::runtime_error(
        fmt::format("--local {}: expected `octahedron` or a number of points from 1 to {}", local, kMaxLightSamples));
  }
  return samples_by_distance(mesh.positions, k);
}

}  // namespace

LocalLighting::LocalLighting(const SubjectOptions& options, const Stage& stage, bool is_stage,
                             const std::vector<Light>& lights)
    : transfer_(*stage.objects.front().transfer), lights_(lights), shading_(options.shading) {
  const auto refuse = [&](const char* why) {
    throw std::runtime_error(fmt::format("{}: --local {}: {}", options.file, options.local, why));
  };
  if (is_stage) refuse("a stage takes distant light only; a transfer file is needed");
  if (transfer_.kind->has_bounces()) {
    refuse("the bake has bounces, whose light comes from other places too; bake unshadowed or shadowed transfer");
  }
  samples_ = samples_named(options.local, transfer_.mesh);
  if (!varies(lights_)) {
    report_flaw(
        options.light.on_flaw(),
        fmt::format("--local {}: no light is a sphere or a polygon, so that it changes nothing", options.local));
  }
}

std::vector<Eigen::Vector3f> LocalLighting::radiance(const Eigen::Matrix3d& light_turn) const {
  std::vector<LightCoefficients> at_points =
      project_at(turned(lights_, light_turn), samples_.points, shading_.degree_for(transfer_.degree()));
  for (LightCoefficients& light : at_points) light = shading_.chosen(light);
  return relight_locally(transfer_, samples_, at_points, shading_);
}

}  // namespace sh::prt
