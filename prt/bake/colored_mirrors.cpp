#include "prt/bake/colored_mirrors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace sh::prt {

namespace {

Scene with_mirrors_of_channel(Scene scene, Eigen::Index channel) {
  for (Eigen::Vector3f& mirror : scene.mesh.mirror) mirror.setConstant(mirror[channel]);
  return scene;
}

// Copies channel `c` of `from` to channel `c` of `to`.
void take_channel(const Transfer& from, std::size_t c, Transfer& to) {
  const std::size_t count = to.shape.count();
  for (std::size_t v = 0; v < to.mesh.positions.size(); ++v) {
    std::copy_n(from.row(v) + c * count, count, to.row(v) + c * count);
  }
  const auto channel = static_cast<Eigen::Index>(c);
  for (std::size_t v = 0; v < to.emitted.size(); ++v) to.emitted[v][channel] = from.emitted[v][channel];
}

// Takes the worse value of each number.
void take_report(const BounceReport& from, BounceReport& to) {
  to.applications = std::max(to.applications, from.applications);
  to.certified = to.certified && from.certified;
  to.bound = std::max(to.bound, from.bound);
  to.residual = std::max(to.residual, from.residual);
  to.largest = std::max(to.largest, from.largest);
  to.spectral_bound = std::max(to.spectral_bound, from.spectral_bound);
  to.emitted_bound = std::max(to.emitted_bound, from.emitted_bound);
  to.emitted_largest = std::max(to.emitted_largest, from.emitted_largest);
}

}  // namespace

bool has_colored_mirrors(const Mesh& mesh) {
  return std::any_of(mesh.mirror.begin(), mesh.mirror.end(),
                     [](const Eigen::Vector3f& mirror) { return (mirror.array() != mirror.x()).any(); });
}

Transfer bake_by_channel(const Scene& scene, const std::function<Transfer(const Scene&)>& bake_grey) {
  if (scene.bake.kind->shape(scene.bake.degree).channels == 1) {
    throw std::invalid_argument(fmt::format(
        "{}: its mirrors have colors, which shadowed transfer cannot hold; expected gray mirrors, or interreflected",
        scene.name));
  }
  Transfer transfer = bake_grey(with_mirrors_of_channel(scene, 0));
  for (std::size_t c = 1; c < 3; ++c) {
    const Transfer channel = bake_grey(with_mirrors_of_channel(scene, static_cast<Eigen::Index>(c)));
    take_channel(channel, c, transfer);
    take_report(channel.bounces, transfer.bounces);
  }
  transfer.mesh.mirror = scene.mesh.mirror;
  return transfer;
}

}  // namespace sh::prt
