// Cuts a face along the middles of some of its edges.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "prt/mesh/halving.hpp"

namespace sh::prt {

using Triangle = std::array<Eigen::Vector3f, 3>;

inline Eigen::Vector3f middle_of(const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return 0.5F * (a + b); }

/// Up to four faces, as points: 0..2 is a corner of the cut face; 3 + k is the middle of edge k, which runs from corner k to
/// k + 1.
struct CutFaces {
  std::array<std::array<std::size_t, 3>, 4> faces;
  std::size_t count;

  [[nodiscard]] std::size_t size() const { return count; }
  [[nodiscard]] const std::array<std::size_t, 3>& operator[](std::size_t i) const { return faces[i]; }
  [[nodiscard]] auto begin() const { return faces.begin(); }
  [[nodiscard]] auto end() const { return faces.begin() + count; }
};

struct FaceParts {
  std::array<bool, 3> is_split{};
  CutForm form = CutForm::kNone;
  std::size_t first = 0;  // the edge whose middle is made first
  CutFaces faces = {{{{0, 1, 2}}}, 1};
};

/// The parts of a face that is cut so.
inline CutFaces faces_of_cut(CutForm form, std::size_t first) {
  const std::array<std::size_t, 3> f = {first, (first + 1) % 3, (first + 2) % 3};
  const std::size_t m = 3 + f[0];
  const std::size_t n = 3 + f[1];
  switch (form) {
    case CutForm::kNone:
      return {{{{0, 1, 2}}}, 1};
    case CutForm::kHalves:
      return {{{{f[0], m, f[2]}, {m, f[1], f[2]}}}, 2};
    case CutForm::kEarFromStart:
      return {{{{m, f[1], n}, {f[0], m, n}, {f[0], n, f[2]}}}, 3};
    case CutForm::kEarFromEnd:
      return {{{{m, f[1], n}, {f[0], m, f[2]}, {m, n, f[2]}}}, 3};
    case CutForm::kQuarters:
      break;
  }
  return {{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}}, 4};
}

/// Cuts a face with these corners at the middles of the edges that parts.is_split names.
inline void split_face(const Triangle& corners, FaceParts& parts) {
  const auto count = std::count(parts.is_split.begin(), parts.is_split.end(), true);
  parts.first = 0;
  parts.form = count == 0 ? CutForm::kNone : count == 3 ? CutForm::kQuarters : CutForm::kHalves;
  if (count == 1 || count == 2) {
    // Edge `first` is the only split one, or the edge before it is the only whole one.
    std::size_t& first = parts.first;
    while (count == 1 ? !parts.is_split[first] : parts.is_split[(first + 2) % 3]) ++first;
    if (count == 2) {  // the quadrilateral that is left is cut along its shorter diagonal
      const Eigen::Vector3f& start = corners[first];
      const Eigen::Vector3f& ear = corners[(first + 1) % 3];
      const Eigen::Vector3f& end = corners[(first + 2) % 3];
      const bool from_start = (start - middle_of(ear, end)).norm() <= (middle_of(start, ear) - end).norm();
      parts.form = from_start ? CutForm::kEarFromStart : CutForm::kEarFromEnd;
    }
  }
  parts.faces = faces_of_cut(parts.form, parts.first);
}

}  // namespace sh::prt
