// Transfers whose vertices have BRDFs, seen from everywhere, with the radiance that emitted run times have to give.
#pragma once
#include "prt/material/microfacet.hpp"
#include "tests/prt/clustered_cases.hpp"

namespace sh::prt::test {

inline const Reflectance& surface_brdf() {
  static const Reflectance made = microfacet_reflectance(0.4F, 0.6F);
  return made;
}

/// Three parts that differ.
inline const Reflectance& measured_brdf() {
  static const Reflectance made = [] {
    Reflectance brdf = surface_brdf();
    brdf.is_measured = true;
    for (std::size_t i = 0; i < brdf.table.size(); ++i) {
      const std::size_t part = i / even_count(kMaxDegree) % kReflectionParts;
      if (part == 2) brdf.table[i] = 0.5F * brdf.table[i - 2 * even_count(kMaxDegree)];
    }
    return brdf;
  }();
  return made;
}

/// Vertex v has brdf[v % size]: 0 none, 1 a surface model, 2 a measured BRDF, 3 a metal that is otherwise not used.
inline Transfer coated(Transfer transfer, const std::vector<std::uint16_t>& brdf) {
  Mesh& mesh = transfer.mesh;
  mesh.brdfs.number_of(surface_brdf());
  mesh.brdfs.number_of(measured_brdf());
  Reflectance metal = surface_brdf();
  metal.name = "metal";
  for (float& number : metal.table) number *= 0.75F;
  mesh.brdfs.number_of(metal);
  const std::size_t vertices = mesh.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) mesh.brdf.push_back(brdf[v % brdf.size()]);
  // Seen head-on, at grazing view, from below, from another side, and from the vertex itself.
  const Eigen::Vector3f eye = kEye.cast<float>();
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f side = Eigen::Vector3f::UnitX();
  const std::vector<std::pair<Eigen::Vector3f, Eigen::Vector3f>> special = {
      {eye - 2.0F * up, up}, {eye - 2.0F * up, side}, {eye - 2.0F * up, -up}, {eye - 2.0F * side, side}, {eye, up}};
  for (std::size_t v = 0; v < std::min(special.size(), vertices); ++v) {
    mesh.positions[v] = special[v].first;
    mesh.normals[v] = special[v].second;
  }
  return transfer;
}

inline std::vector<EmittedCase> coated_cases() {
  std::vector<EmittedCase> all;
  all.push_back({"coated", coated(with_lobes(kGlossyShadowed, 4, 35), {1, 3, 1})});
  all.push_back({"coated_beside_lobes", coated(with_lobes(kGlossyShadowed, 3, 75), {1, 2, 0, 3})});
  all.push_back(
      {"coated_here_and_there", coated(random_transfer(kGlossyUnshadowed, 2, 49),
                                       std::vector<std::uint16_t>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                                                  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})});
  all.push_back({"coated_constant", coated(with_lobes(kGlossyShadowed, 0, 7), {1, 2})});
  all.push_back({"coated_vertex", coated(random_transfer(kGlossyShadowed, 1, 1), {2})});
  all.push_back({"measured", coated(random_transfer(kGlossyUnshadowed, kMaxDegree, 18), {2})});
  all.push_back({"coated_zonal", coated(random_transfer(kGlossyShadowed, 4, 17), {1, 2}), {0, 2, 6, 12, 20}});
  all.push_back({"coated_half", stored(coated(random_transfer(kGlossyShadowed, 2, 16), {2, 1}), Element::kHalf)});
  Transfer black = coated(with_lobes(kGlossyShadowed, 3, 20), {1, 2, 0});
  for (Eigen::Vector3f& albedo : black.mesh.albedo) albedo.setZero();
  all.push_back({"coated_black", black});
  Transfer emitting = coated(with_lobes(kGlossyInterreflected, 2, 21, matrices(2, 3, Element::kHalf)), {0, 1, 2, 3});
  emitting.emitted = emitting.mesh.albedo;
  all.push_back({"coated_bounces", emitting});
  all.push_back({"coated_clusters", in_clusters(coated(with_lobes(kGlossyShadowed, 2, 35), {1, 0}), {2, 4})});
  return all;
}

}  // namespace sh::prt::test
