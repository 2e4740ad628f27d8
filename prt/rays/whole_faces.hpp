// The faces of a mesh before their edges were halved, as rays see them: the same surface, with a smaller tree and shorter
// ways through it. A hit finds its face of the mesh by its place.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/sheets.hpp"

namespace sh::prt {

/// A place in a face of a mesh: the parts of its corners.
struct PlaceInFace {
  std::uint32_t face;
  std::array<double, 3> weights;
};

/// The face that has a place in the face that `part` cuts, whose corners have these weights.
PlaceInFace located(const std::vector<FaceCut>& cuts, std::uint32_t part, std::array<double, 3> weights);

/// Faces in place of those that were cut, in their order: they cover the same surface, and each has the cuts into the faces of
/// the mesh. They are as large as single precision allows: no cut of them is deeper than kDeepestCut.
inline constexpr int kDeepestCut = 8;
std::vector<Halving::Whole> faces_for_rays(const Halving& halving);

/// The faces that rays see, in the order of those of the mesh.
class WholeFaces {
 public:
  /// Those of a mesh without cuts.
  WholeFaces() = default;
  explicit WholeFaces(const Mesh& mesh);
  [[nodiscard]] bool any() const { return !runs_.empty(); }

  /// The traced faces for those of the mesh. Corners are its vertices.
  [[nodiscard]] std::vector<Face> traced(const std::vector<Face>& faces) const;
  /// How many traced faces come before a face of the mesh.
  [[nodiscard]] std::uint32_t count_before(std::uint32_t face) const;
  /// The hit of the mesh for a hit of the traced faces.
  [[nodiscard]] Hit hit_of_mesh(const Hit& hit) const;

 private:
  // Traced faces with cuts. Those between runs are faces of the mesh; runs have few others.
  struct Run {
    std::uint32_t traced;  // the number of the first traced face
    std::size_t whole;     // the place of the first in wholes_
    std::uint32_t count;
    std::uint32_t face;  // the first face of the mesh
    std::uint32_t end;   // and the one behind the last

    // The number of a traced face behind the run that is this face of the mesh.
    [[nodiscard]] std::uint32_t behind(std::uint32_t of_mesh) const { return traced + count + (of_mesh - end); }
  };

  // Copies the cuts of a part, so that those of a place stand together in memory. Returns the part.
  std::uint32_t copy(const std::vector<FaceCut>& from, std::uint32_t part);

  std::vector<Run> runs_;
  std::vector<Halving::Whole> wholes_;
  std::vector<FaceCut> cuts_;
};

}  // namespace sh::prt
