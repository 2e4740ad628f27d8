// Glossy transfer under a light at rest [SloanKautzSnyder02, section 4.2, fixed light]: the radiance that reaches a vertex
// and its convolution with the vertex's lobe stay, and so does what leaves diffusely. A new eye costs one evaluation a
// vertex, by the generated driver `evaluate_rgb`.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/runtime/glossy.hpp"

namespace sh::prt {

class LightAtRest {
 public:
  /// `albedo` (vertices) serves in place of the mesh's. `transfer` must outlive the result.
  LightAtRest(const Transfer& transfer, TransferredRadiance reaching, std::vector<Eigen::Vector3f> albedo);

  /// That of exit_radiance() (prt/runtime/glossy.hpp), to rounding.
  [[nodiscard]] std::vector<Eigen::Vector3f> exit_radiance(const Eigen::Vector3d& eye) const;

  /// What a frame reads, bytes a vertex.
  [[nodiscard]] std::size_t bytes_of_vertex() const;

 private:
  const Transfer& transfer_;
  TransferredRadiance reaching_;
  std::vector<Eigen::Vector3f> albedo_;
  std::vector<Eigen::Vector3f> constant_;  // (vertices): diffuse and emitted
  std::vector<float> lobes_;               // (vertices, 3, bands^2) in blocks; empty where no vertex has a lobe
};

}  // namespace sh::prt
