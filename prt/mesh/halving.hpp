// How the faces of a mesh were halved: the faces before, the tree of their cuts, and for each vertex that halving made, the
// edge whose middle it is. With these, a mesh can do without some of the vertices, whose values are interpolated along the
// edges, and rays can be traced against the few faces before.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sh::prt {

struct Mesh;

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;

/// How a face with corners f0, f1, f2 is cut; m and n are the middles of f0 f1 and f1 f2:
///   kHalves        f0 m f2, m f1 f2
///   kEarFromStart  m f1 n, f0 m n, f0 n f2
///   kEarFromEnd    m f1 n, f0 m f2, m n f2
///   kQuarters      three corners, and the middle
enum class CutForm : std::uint8_t { kNone, kHalves, kEarFromStart, kEarFromEnd, kQuarters };

constexpr std::size_t part_count(CutForm form) {
  return form == CutForm::kQuarters ? 4 : form == CutForm::kHalves ? 2 : form == CutForm::kNone ? 0 : 3;
}

/// A cut of a face into parts. A part is a face of the mesh, with kIsFace, or another cut, which has a larger number.
struct FaceCut {
  static constexpr std::uint32_t kIsFace = 0x80000000U;
  std::array<std::uint32_t, 4> parts = {};
  CutForm form = CutForm::kNone;
  std::uint8_t first = 0;  // the corner f0
};

/// A place in a face of a mesh: the parts of its corners.
struct PlaceInFace {
  std::uint32_t face;
  std::array<double, 3> weights;
};

/// The face that has a place in the face that `part` cuts, whose corners have these weights.
PlaceInFace located(const std::vector<FaceCut>& cuts, std::uint32_t part, std::array<double, 3> weights);

struct Halving {
  /// A face before its edges were halved.
  struct Whole {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t part;
    bool is_turned = false;  // its parts are wound the other way: it is a back, cut as its front is
  };
  std::vector<std::array<std::uint32_t, 2>> ends;     // (vertices) of the edge; kNoVertex for vertices of the files
  std::vector<Whole> faces;                           // in the order of their parts, which stand together
  std::vector<FaceCut> cuts;                          // of all faces
  std::vector<std::array<std::uint32_t, 3>> middles;  // (cuts) of the edges of the cut face; kNoVertex: it is whole

  [[nodiscard]] bool empty() const { return cuts.empty(); }
  [[nodiscard]] bool is_middle(std::size_t vertex) const { return ends[vertex][0] != kNoVertex; }
  /// The first face of a part; the others follow.
  [[nodiscard]] std::uint32_t first_face(std::uint32_t part) const;
};

/// Faces in place of those of a halved mesh: they cover the same surface, and each has the cuts into the faces of the mesh.
/// They are as large as single precision allows: no cut of them is deeper than kDeepestCut.
inline constexpr int kDeepestCut = 8;
std::vector<Halving::Whole> faces_for_rays(const Halving& halving);

/// Adds those of backs, (vertices) and (faces) of the fronts; kNoVertex and kNoFace where there is none.
void add_backs(Halving& halving, const std::vector<std::uint32_t>& backs, const std::vector<std::uint32_t>& back_faces);

/// Appends that of a part, before its vertices and faces are there. Faces of a mesh without any count as whole.
void append_halving(Mesh& mesh, const Mesh& part);

/// All vertices in an order in which the ends of an edge come before its middle.
std::vector<std::uint32_t> ends_first(const Halving& halving);

/// The marks (vertices; 1: kept) with what they need: vertices that no halving made, the ends of the edges of kept
/// middles, and the other vertices at the places of kept ones, so that faces on both sides of an edge agree.
std::vector<std::uint8_t> with_ends(const Mesh& mesh, std::vector<std::uint8_t> kept);

/// Leaves out the vertices that are not kept, and halves faces at the kept ones only. What is left keeps its order, and has
/// its halving. The marks are as with_ends() makes them, else it throws std::invalid_argument, as it does
/// for a mesh with an atlas, whose texels stand in place of vertices.
void keep_vertices(Mesh& mesh, const std::vector<std::uint8_t>& kept);

/// Sets the values of vertices that are not kept to the mean of the values at the ends of their edges, which interpolation
/// over the faces that keep_vertices() leaves gives in the middle of an edge. `order` is that of ends_first().
template <class Values>
void interpolate_left_out(const Halving& halving, const std::vector<std::uint32_t>& order,
                          const std::vector<std::uint8_t>& kept, Values& values) {
  for (const std::uint32_t v : order) {
    if (kept[v] != 0) continue;
    const auto [a, b] = halving.ends[v];
    values[v] = (values[a] + values[b]) / 2;
  }
}

/// A vertex as it is shown: kept vertices with their parts, which sum to 1.
using Blend = std::vector<std::pair<std::uint32_t, double>>;

/// What interpolate_left_out() makes of these vertices, one after another.
std::vector<Blend> blends_of(const Halving& halving, const std::vector<std::uint8_t>& kept,
                             const std::vector<std::uint32_t>& vertices);

}  // namespace sh::prt
