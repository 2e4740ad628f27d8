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

/// Faces in place of those of a halved mesh, in their order: they cover the same surface, and each has the cuts into the faces of the mesh.
/// They are as large as single precision allows: no cut of them is deeper than kDeepestCut.
inline constexpr int kDeepestCut = 8;
std::vector<Halving::Whole> faces_for_rays(const Halving& halving);

class WholeFaces {
 public:
  /// None.
  WholeFaces() = default;
  explicit WholeFaces(const Halving& halving);
  [[nodiscard]] bool any() const { return !faces_.empty(); }

  /// A mesh of these faces, with positions and nothing else.
  [[nodiscard]] Mesh surface(const Mesh& mesh) const;
  /// The hit of the mesh for a hit of the surface.
  [[nodiscard]] Hit hit_of_mesh(const Hit& hit) const;

 private:
  // Copies the cuts of a part, so that those of a place stand together in memory. Returns the part.
  std::uint32_t copy(const std::vector<FaceCut>& from, std::uint32_t part);

  std::vector<Halving::Whole> faces_;
  std::vector<FaceCut> cuts_;
};

}  // namespace sh::prt
