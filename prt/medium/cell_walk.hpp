// The cells that a ray crosses, in a grid whose points have integer coordinates. A cell has 8 points as corners.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace sh::prt {

/// The share of each corner of a cell, x fastest, at a point in it: coordinates 0..1.
inline std::array<double, 8> trilinear(const Eigen::Array3d& p) {
  std::array<double, 8> share{};
  for (std::size_t c = 0; c < 8; ++c) {
    share[c] = ((c & 1U) != 0 ? p.x() : 1.0 - p.x()) * ((c & 2U) != 0 ? p.y() : 1.0 - p.y()) *
               ((c & 4U) != 0 ? p.z() : 1.0 - p.z());
  }
  return share;
}

/// A ray's piece in one cell.
struct CellPiece {
  std::array<int, 3> place{};  // the lowest corner
  double from = 0.0;           // along the ray, in its unit
  double to = 0.0;
  int axis = 0;          // the piece ends on a face perpendicular to it
  Eigen::Array3d enter;  // where, from the lowest corner: 0..1
  Eigen::Array3d leave;

  /// The integral of a trilinear function along the piece as shares of the corners. The function is a cubic there, which
  /// two nodes of Gauss and Legendre integrate exactly.
  [[nodiscard]] std::array<double, 8> integral() const {
    constexpr double kNode = 0.5 * std::numbers::inv_sqrt3;
    std::array<double, 8> sum{};
    for (const double at : {0.5 - kNode, 0.5 + kNode}) {
      const std::array<double, 8> share = trilinear((1.0 - at) * enter + at * leave);
      for (std::size_t c = 0; c < 8; ++c) sum[c] += 0.5 * (to - from) * share[c];
    }
    return sum;
  }
};

class CellWalk {
 public:
  /// The ray start + t step, t > 0; the step is not zero.
  CellWalk(const Eigen::Array3d& start, const Eigen::Array3d& step) : start_(start), step_(step) {
    for (Eigen::Index a = 0; a < 3; ++a) {
      plane_[static_cast<std::size_t>(a)] = step[a] < 0.0 ? std::ceil(start[a]) - 1.0 : std::floor(start[a]) + 1.0;
    }
    least_ = kLeastStep / step.abs().maxCoeff();
  }

  /// The next piece; those shorter than a part 1e-12 of a cell, at edges and corners, are left out.
  CellPiece next() {
    CellPiece piece;
    piece.from = at_;
    do {
      for (std::size_t a = 0; a < 3; ++a) {
        piece.place[a] = static_cast<int>(step_[Eigen::Index(a)] < 0.0 ? plane_[a] : plane_[a] - 1.0);
      }
      piece.axis = time(0) <= time(1) ? (time(0) <= time(2) ? 0 : 2) : (time(1) <= time(2) ? 1 : 2);
      piece.to = time(piece.axis);
      plane_[static_cast<std::size_t>(piece.axis)] += step_[piece.axis] < 0.0 ? -1.0 : 1.0;
    } while (piece.to - piece.from < least_);
    at_ = piece.to;
    const Eigen::Array3d corner(piece.place[0], piece.place[1], piece.place[2]);
    piece.enter = (start_ + piece.from * step_ - corner).max(0.0).min(1.0);
    piece.leave = (start_ + piece.to * step_ - corner).max(0.0).min(1.0);
    piece.leave[piece.axis] = step_[piece.axis] < 0.0 ? 0.0 : 1.0;
    return piece;
  }

 private:
  static constexpr double kLeastStep = 1e-12;

  [[nodiscard]] double time(int axis) const {
    const double step = step_[axis];
    return step == 0.0 ? std::numeric_limits<double>::infinity()
                       : (plane_[static_cast<std::size_t>(axis)] - start_[axis]) / step;
  }

  Eigen::Array3d start_;
  Eigen::Array3d step_;
  std::array<double, 3> plane_{};  // the next one along each axis
  double at_ = 0.0;
  double least_ = 0.0;
};

}  // namespace sh::prt
