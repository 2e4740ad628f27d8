// The BRDFs of an emitted run time: the tables that its vertices use, up to the degree of the file, in the parts that are
// not black.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The number of a vertex is 4 t + n: its n parts stand in the tables t, t + 1, ... Their colors are white for n = 1;
/// the albedo and white for n = 2; red, green and blue for n = 3, a measured BRDF; n = 0: a vertex without BRDF.
struct EmittedBrdfs {
  std::vector<float> tables;           // (parts of all, kViews, even_count(degree))
  std::vector<std::uint16_t> numbers;  // (vertices); empty: no vertex has a BRDF
  bool serve_all = false;              // no vertex is without

  /// `colors` (vertices) of those without BRDF, of the others black.
  [[nodiscard]] std::vector<Eigen::Vector3f> of_lobes(std::vector<Eigen::Vector3f> colors) const;
  /// `albedo` (vertices) of those whose BRDF has a part of this color, of the others black.
  [[nodiscard]] std::vector<Eigen::Vector3f> of_bases(std::vector<Eigen::Vector3f> albedo) const;
};

EmittedBrdfs emitted_brdfs(const Transfer& transfer);

}  // namespace sh::prt
