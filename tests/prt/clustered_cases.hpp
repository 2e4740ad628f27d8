// Transfers in clusters, with the radiance that emitted run times have to give.
#pragma once
#include "prt/bake/compress.hpp"
#include "tests/prt/emitted_cases.hpp"

namespace sh::prt::test {

/// As a file holds it.
inline Transfer in_clusters(Transfer transfer, ClusterCounts counts) {
  compress(transfer, counts);
  if (!transfer.shape.storage.is_clustered()) {  // files keep visibility in half precision then
    transfer.coefficients = decode(encode(transfer.coefficients, transfer.shape), transfer.shape);
  }
  return transfer;
}

// Rows of one channel and of three, masked, of 8 bits; visibility; matrices; one cluster, without vectors, too.
inline std::vector<EmittedCase> clustered_cases() {
  std::vector<EmittedCase> all;
  const auto add = [&](const char* name, const Transfer& transfer, ClusterCounts counts,
                       std::vector<std::uint32_t> light = {}) {
    all.push_back({name, in_clusters(transfer, counts), std::move(light)});
  };
  add("clusters", random_transfer(kShadowed, 4, 45), {3, 6});
  add("clusters_colored_zonal", random_transfer(kInterreflected, 2, 37), {2, 5}, {0, 2, 6});
  add("cluster", random_transfer(kShadowed, 1, 16), {1, 0});
  add("clusters_of_one", random_transfer(kShadowed, 0, 1), {1, 1});
  add("clusters_for_each", random_transfer(kShadowed, 2, 19), {19, 1});
  Transfer emitting = random_transfer(kInterreflected, 1, 20);
  emitting.emitted = emitting.mesh.albedo;
  add("clusters_emitting", emitting, {2, 3});
  add("clusters_glossy", with_lobes(kGlossyShadowed, 4, 35), {2, 8});
  add("clusters_glossy_constant", with_lobes(kGlossyShadowed, 0, 17), {2, 1});
  add("clusters_glossy_zonal", with_lobes(kGlossyShadowed, 4, 20), {3, 2}, {0, 2, 6, 12, 20});
  add("clusters_bounces", with_lobes(kGlossyInterreflected, 2, 33, matrices(2, 3, Element::kSingle)), {3, 4});
  add("clusters_bounces_gray", with_lobes(kGlossyInterreflected, 1, 18, matrices(1, 1, Element::kHalf)), {2, 2},
      {0, 2});
  const auto bounces = [](std::size_t channels, const KeptBands& kept) {
    return keeping(with_lobes(kGlossyInterreflected, 2, 33, matrices(2, channels, Element::kSingle)), kept);
  };
  add("clusters_few_columns", bounces(3, {4, 2, 1}), {3, 4});
  add("clusters_few_rows", bounces(1, {3, 1, 2}), {2, 3});
  add("clusters_kept", keeping(with_lobes(kGlossyShadowed, 3, 21), {4}), {2, 5});
  return all;
}

}  // namespace sh::prt::test
