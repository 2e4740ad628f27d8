// Gaussian splats in memory: a block of splats that follow one another in a file [Kerbl, Kopanas, Leimkuehler,
// Drettakis 2023].
//
// A splat is the Gaussian of covariance R S S^T R^T about its position, with an opacity and a color that depends on the
// direction d from the eye to it: color(d) = 1/2 + sum_i c_i Y_i(d), display-referred. In a block the coefficients c
// are in this project's convention (numeric/README.md); positions, rotations and coefficients are in the axes of the
// file. Scales are logarithms and opacities logits, as the formats of training hold them, so that nothing is lost
// between them.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

/// The highest degree of coefficients that any format holds.
inline constexpr int kHighestSplatDegree = 4;

/// Coefficients of one color channel.
constexpr std::size_t splat_bands_squared(int degree) { return std::size_t(degree + 1) * std::size_t(degree + 1); }

struct SplatBlock {
  std::size_t first = 0;  // number of the first splat in the input file
  std::size_t count = 0;
  int degree = 0;
  std::vector<float> position;   // (count, 3)
  std::vector<float> normal;     // (count, 3); no format gives it a meaning, but it turns with the splats
  std::vector<float> rotation;   // (count, 4): w, x, y, z; of any length but zero
  std::vector<float> log_scale;  // (count, 3); -infinity: a flat splat
  std::vector<float> opacity;    // (count): log(a / (1 - a)); may be infinite
  std::vector<float> harmonics;  // (count, 3, bands^2): red, green, blue
  std::size_t record_size = 0;
  std::vector<char> records;  // (count, record_size): the bytes of a PLY file, for what else it holds

  /// Normals become zeros; all other numbers have any value.
  void resize(std::size_t splats, int coefficients_degree);
  [[nodiscard]] std::size_t bands_squared() const { return splat_bands_squared(degree); }
  /// Keeps the splats whose numbers are given, in their order.
  void keep(const std::vector<std::size_t>& splats);
};

/// Parts of the numbers of a splat: what an edit changes. A writer leaves the rest as the input file has it, to the
/// bit.
struct SplatParts {
  bool position = false;
  bool rotation = false;  // and normal
  bool scale = false;
  bool harmonics = false;  // coefficients of degree 1 and above
  bool rest = false;       // opacity, and coefficients of degree 0
};
inline constexpr SplatParts kAllSplatParts = {true, true, true, true, true};

/// What holds for all splats of a file, or of what remains of it.
struct SplatSummary {
  std::size_t count = 0;
  Eigen::AlignedBox3f box;  // of the positions; empty without splats
};

}  // namespace sh::prt
