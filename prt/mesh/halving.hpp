// How the faces of a mesh were halved: the faces before, the tree of their cuts, and for each vertex that halving made, the
// edge whose middle it is. With these, a mesh can do without some of its vertices (prt/mesh/keep_vertices.hpp), and rays can be
// traced against the few faces before (prt/rays/whole_faces.hpp).
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

/// The first face of a part, and the one behind its last.
std::uint32_t first_face(const std::vector<FaceCut>& cuts, std::uint32_t part);
std::uint32_t end_of_faces(const std::vector<FaceCut>& cuts, std::uint32_t part);

struct Halving {
  /// A face before its edges were halved. One that was not cut is its own part.
  struct Whole {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t part;
    bool is_turned = false;  // its parts are wound the other way: it is a back, cut as its front is
  };
  std::vector<std::array<std::uint32_t, 2>> ends;  // (vertices) of the edge; kNoVertex for vertices of the files
  std::vector<Whole> faces;                        // that were cut, in the order of their parts, which stand together
  std::vector<FaceCut> cuts;                       // of all faces
  std::vector<std::array<std::uint32_t, 3>> middles;  // (cuts) of the edges of the cut face; kNoVertex: it is whole

  [[nodiscard]] bool empty() const { return cuts.empty(); }
  [[nodiscard]] bool is_middle(std::size_t vertex) const { return ends[vertex][0] != kNoVertex; }
  [[nodiscard]] std::uint32_t first_face(std::uint32_t part) const { return prt::first_face(cuts, part); }
};

/// Calls `visit` with every face before its edges were halved, in the order of `faces`, the faces of the mesh.
template <class Visit>
void visit_wholes(const Halving& halving, const std::vector<std::array<std::uint32_t, 3>>& faces, const Visit& visit) {
  std::uint32_t next = 0;
  const auto visit_uncut = [&](std::size_t end) {
    for (; next < end; ++next) visit(Halving::Whole{faces[next], next | FaceCut::kIsFace});
  };
  for (const Halving::Whole& face : halving.faces) {
    visit_uncut(halving.first_face(face.part));
    visit(face);
    next = end_of_faces(halving.cuts, face.part);
  }
  visit_uncut(faces.size());
}

/// Replaces the number of a vertex, unless it is kNoVertex.
inline void renumber(const std::vector<std::uint32_t>& numbers, std::uint32_t& vertex) {
  if (vertex != kNoVertex) vertex = numbers[vertex];
}

/// Adds those of backs, (vertices) and (faces) of the fronts; kNoVertex and kNoFace where there is none.
void add_backs(Halving& halving, const std::vector<std::uint32_t>& backs, const std::vector<std::uint32_t>& back_faces);

/// Appends that of a part, before its vertices and faces are there.
void append_halving(Mesh& mesh, const Mesh& part);

}  // namespace sh::prt
