// Cuts a face along the middles of some of its edges.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sh::prt {

using Triangle = std::array<Eigen::Vector3f, 3>;

inline Eigen::Vector3f middle_of(const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return 0.5F * (a + b); }

// The parts of a face. Point 0..2 is a corner; point 3 + k is the middle of edge k, which runs from corner k to k + 1.
struct FaceParts {
  std::vector<std::array<std::size_t, 3>> faces;
  std::size_t first = 0;  // the edge whose middle is made first
  std::array<bool, 3> is_split{};
};

/// Cuts a face with these corners at the middles of the edges that parts.is_split names.
inline void split_face(const Triangle& corners, FaceParts& parts) {
  parts.faces.clear();
  parts.first = 0;
  const auto count = std::count(parts.is_split.begin(), parts.is_split.end(), true);
  if (count == 0) {
    parts.faces.assign(1, {0, 1, 2});
  } else if (count == 3) {
    parts.faces.assign({{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}});
  } else {
    // Edge `first` is the only split one, or the edge before it is the only whole one.
    std::size_t& first = parts.first;
    while (count == 1 ? !parts.is_split[first] : parts.is_split[(first + 2) % 3]) ++first;
    const std::array<std::size_t, 3> f = {first, (first + 1) % 3, (first + 2) % 3};
    const std::size_t m = 3 + f[0];
    if (count == 1) {
      parts.faces.assign({{f[0], m, f[2]}, {m, f[1], f[2]}});
      return;
    }
    // The quadrilateral f0 m n f2 is cut along its shorter diagonal.
    const std::size_t n = 3 + f[1];
    const Eigen::Vector3f at_m = middle_of(corners[f[0]], corners[f[1]]);
    const Eigen::Vector3f at_n = middle_of(corners[f[1]], corners[f[2]]);
    parts.faces.assign(1, {m, f[1], n});
    if ((corners[f[0]] - at_n).norm() <= (at_m - corners[f[2]]).norm()) {
      parts.faces.insert(parts.faces.end(), {{f[0], m, n}, {f[0], n, f[2]}});
    } else {
      parts.faces.insert(parts.faces.end(), {{f[0], m, f[2]}, {m, n, f[2]}});
    }
  }
}

}  // namespace sh::prt
