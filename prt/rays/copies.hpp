// Copies: nodes of a mesh whose faces are those of an earlier node, moved. Rays test one tree for all of them (instancing),
// so that a forest takes the memory of its kinds of trees. Copies are found by their positions; nothing has to declare them.
#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// Faces that stand together.
struct FaceRun {
  std::uint32_t first;
  std::uint32_t count;
};

/// The run of faces of a node, which has this map from its own axes to those of the positions.
struct RunOfNode {
  FaceRun run;
  Eigen::Affine3d map;
};

/// An original and its copies. All have as many faces in the same order.
struct CopiedRun {
  struct Place {
    std::uint32_t first;            // face
    Eigen::Affine3f from_original;  // from the axes of the positions around `center`
  };
  FaceRun run;
  Eigen::Vector3f center;     // of the original
  std::vector<Place> places;  // the original itself comes first
};

/// The nodes of `least` faces or more that have copies. A copy has the positions of its original, moved by the maps of
/// both nodes, but for less than moves the start of a ray to the other side of a face. No mirror image is a copy.
std::vector<CopiedRun> find_copies(const std::vector<Eigen::Vector3f>& positions, const std::vector<Face>& faces,
                                   const std::vector<RunOfNode>& nodes, std::uint32_t least);

/// Takes runs out of a mesh, each with vertices of its own. Refers to the arguments.
class Parts {
 public:
  Parts(const std::vector<Eigen::Vector3f>& positions, const std::vector<Face>& faces)
      : positions_(positions), faces_(faces), numbers_(positions.size(), kNoVertex) {}
  /// Chooses a run; returns the number of its vertices.
  std::size_t choose(const FaceRun& run);
  /// Writes the vertices, relative to `center`, and the faces of the chosen run.
  void write(const Eigen::Vector3f& center, Eigen::Vector3f* positions, Face* faces) const;

 private:
  const std::vector<Eigen::Vector3f>& positions_;
  const std::vector<Face>& faces_;
  FaceRun run_ = {};
  std::vector<std::uint32_t> vertices_;  // of the run, in the order in which its faces come to them
  std::vector<std::uint32_t> numbers_;   // (vertices of the mesh) places in vertices_, or kNoVertex
};

}  // namespace sh::prt
