#include "prt/runtime/lightmap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "generated/cpp/lightmap.hpp"
#include "prt/mesh/corners.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kBandsOfLightmap = 4;

// An edge of a face as seen from its front: the vertices at its ends.
using Edge = std::array<std::uint32_t, 2>;

// The ends in space, in an order that both faces at an edge have.
using Place = std::array<std::array<std::uint32_t, 3>, 2>;
Place place_of(const Mesh& mesh, const Edge& edge) {
  Place place = {bits_of(mesh.positions[edge[0]]), bits_of(mesh.positions[edge[1]])};
  if (place[1] < place[0]) std::swap(place[0], place[1]);
  return place;
}

bool is_smooth(const Mesh& mesh, const Edge& a, const Edge& b) {
  constexpr float kAlike = 0.9962F;  // 5 degrees
  return mesh.normals[a[0]].dot(mesh.normals[b[0]]) > kAlike && mesh.normals[a[1]].dot(mesh.normals[b[1]]) > kAlike;
}

}  // namespace

std::vector<ExrChannel> channels_of(const SurfaceReceivers& receivers, std::size_t atlas,
                                    const std::vector<Eigen::Vector3f>& values, const std::string& prefix) {
  std::vector<ExrChannel> channels;
  for (int c = 0; c < 3; ++c) {
    ExrChannel& channel = channels.emplace_back(ExrChannel{prefix + "RGB" [c], {}});
    for (const std::uint32_t vertex : receivers.pixels(atlas)) channel.values.push_back(values[vertex][c]);
  }
  return channels;
}

std::vector<Eigen::Vector3f> irradiance_of(const Transfer& transfer, const std::vector<Eigen::Vector3f>& radiance,
                                           const std::vector<Eigen::Vector3f>& albedo) {
  std::vector<Eigen::Vector3f> irradiance = without_albedo(radiance, transfer.emitted, albedo);
  for (Eigen::Vector3f& value : irradiance) value *= std::numbers::pi_v<float>;
  return irradiance;
}

std::array<std::vector<Eigen::Vector3f>, 4> directional_irradiance(const Transfer& transfer,
                                                                   const TransferredRadiance& reaching) {
  const auto bands = coefficient_count(reaching.degree());
  std::array<std::vector<Eigen::Vector3f>, kBandsOfLightmap> directional;
  directional.fill(std::vector<Eigen::Vector3f>(transfer.mesh.positions.size()));
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<float, kBandsOfLightmap> e{};
      std::copy_n(reaching.at(v) + c * bands, std::min(bands, kBandsOfLightmap), e.begin());
      sh::lightmap<1>(e.data(), e.data());
      for (std::size_t k = 0; k < e.size(); ++k) directional[k][v][static_cast<Eigen::Index>(c)] = e[k];
    }
  }
  return directional;
}

Seams measure_seams(const Mesh& mesh, const SurfaceReceivers& receivers, const std::vector<Eigen::Vector3f>& values) {
  constexpr int kSamples = 8;  // along an edge
  std::map<Place, Edge> open;  // edges with one face so far
  Seams seams;
  double squares = 0.0;
  double differences = 0.0;
  double length = 0.0;
  const auto at = [&](const Edge& edge, float part) {
    const Eigen::Vector2f place = (1.0F - part) * mesh.chart[edge[0]] + part * mesh.chart[edge[1]];
    return receivers.in_atlas(mesh.atlas[edge[0]] - std::size_t{1}, place).mean(values);
  };
  const auto compare = [&](const Edge& a, const Edge& b) {  // both from one end to the other
    const auto weight = static_cast<double>((mesh.positions[a[1]] - mesh.positions[a[0]]).norm());
    for (int i = 0; i < kSamples; ++i) {
      const float part = (static_cast<float>(i) + 0.5F) / kSamples;
      const Eigen::Vector3f first = at(a, part);
      const Eigen::Vector3f second = at(b, part);
      differences += weight * static_cast<double>((first - second).squaredNorm());
      squares += weight * 0.5 * static_cast<double>(first.squaredNorm() + second.squaredNorm());
    }
    length += weight * kSamples;
    ++seams.edges;
  };
  for (const Face& face : mesh.faces) {
    if (mesh.atlas.empty() || mesh.atlas[face[0]] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge own = {face[k], face[(k + 1) % 3]};
      const auto [entry, added] = open.try_emplace(place_of(mesh, own), own);
      if (added) continue;
      const Edge other = {entry->second[1], entry->second[0]};  // runs the other way around its face
      const bool is_joined = mesh.chart[own[0]] == mesh.chart[other[0]] && mesh.chart[own[1]] == mesh.chart[other[1]] &&
                             mesh.atlas[own[0]] == mesh.atlas[other[0]];
      const bool is_alike = mesh.positions[own[0]] == mesh.positions[other[0]];
      if (!is_joined && is_alike && is_smooth(mesh, own, other)) compare(own, other);
      open.erase(entry);
    }
  }
  if (length > 0.0) {
    seams.difference = std::sqrt(differences / length);
    seams.value = std::sqrt(squares / length);
  }
  return seams;
}

}  // namespace sh::prt
