// Principal axes of rows, and the plane of few dimensions that is nearest to them. Double precision: in single precision
// the eigen-solver gives NaN for clusters of few rows.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace sh::prt {

using DoubleRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows in coordinates along few axes: row = origin + coordinates * axes, up to what other directions hold.
struct Reduced {
  DoubleRows coordinates;     // (rows, axes)
  DoubleRows axes;            // (axes, length), orthonormal
  Eigen::RowVectorXd origin;  // (length)
};

/// (rows, length) -> coordinates. Short rows keep all their dimensions; for long ones the axes are the principal ones of
/// rows at even steps.
Reduced reduced(const std::vector<float>& rows, std::size_t length);

/// The plane mean + span(axes) nearest to some rows.
struct Plane {
  Eigen::RowVectorXd mean;
  DoubleRows axes;      // (vectors, columns), orthonormal or zero, the longest first
  double error = 0.0;   // sum of squared distances
  double energy = 0.0;  // sum of squares of the rows
  /// True if another plane could hold some of its rows better: there is an error beyond rounding.
  [[nodiscard]] bool can_be_split() const;
};

Plane nearest_plane(const DoubleRows& rows, std::span<const std::uint32_t> members, std::size_t vectors);

/// The same plane for rows (.., length) in all their dimensions, by subspace iteration from the plane of their reduced
/// coordinates. `error` and `energy` are those of the coordinates.
Plane in_all_dimensions(const Plane& plane, const Reduced& reduced, const std::vector<float>& rows,
                        std::span<const std::uint32_t> members);

}  // namespace sh::prt
