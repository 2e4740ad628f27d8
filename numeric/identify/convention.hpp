// Conventions of spherical harmonics: the values of each one's functions, from its definition alone.
//
// A convention's functions are Y'_lm(d) = size(l, m) * g_lm(axes d). g_lm is the oracle's real function
// (numeric/oracle/basis.hpp) or, complex, (C + i sign(m) S) / sqrt 2 of its cosine C = Y_l|m| and sine S = Y_l,-|m|.
// `size` holds normalization, phase and folded factors. symbolic/convention/ says the same exactly, and neither folder
// knows the other: tests/symbolic/identify_test.cpp compares the two.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

namespace sh::numeric::identify {

/// The size of a function; a = |m|, P_l^a without the Condon-Shortley sign.
enum class Normalization {
  kOrthonormal,   // integral of |Y|^2 = 1
  kFourPi,        // integral = 4 pi: geodesy's 4-pi, ambisonics' N3D
  kSchmidt,       // integral = 4 pi / (2l+1): Schmidt semi-normalized, SN3D with Y_00 = 1
  kSn3d,          // integral = 1 / (2l+1): SN3D with 1/(4 pi) under the root [Nachbar11]
  kUnnormalized,  // P_l^a cos(a phi) or sin(a phi); real only
  kPrimitive,     // the polynomial with coprime integer coefficients: 1, y, z, x, xy, yz, 3z^2-1, ...; real only
  kFuMa,          // Furse-Malham: largest value 1, for W 1/sqrt 2; real only, to degree 3
};

/// Where an array keeps degree l, order m.
enum class IndexOrder {
  kAcn,              // l(l+1)+m
  kZeroFirst,        // bands in order, inside 0, 1, -1, 2, -2, ...
  kCosineSineBands,  // bands in order, inside 0, 1, .., l, -1, .., -l
  kCosineSineArray,  // (2, L+1, L+1): [m < 0][l][|m|], the rest holes that hold zero
  kFuMa,             // bands in order, inside 1, -1, 0 in band 1, 0, 1, -1, 2, -2, ... in the others
};

/// The factor of each band: A_l of the clamped cosine (numeric/oracle/zonal.hpp).
enum class Folded { kNothing, kCosineOverPi, kCosine };

/// A signed permutation of the axes: coordinate `row` of d' is sign[row] * d[axis[row]].
struct Axes {
  std::array<int, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};

  [[nodiscard]] std::array<double, 3> apply(const std::array<double, 3>& d) const;
  [[nodiscard]] int determinant() const;        // -1: the handedness changes
  [[nodiscard]] std::string to_string() const;  // "x,z,-y"
  friend bool operator==(const Axes&, const Axes&) = default;
};

/// "x,z,-y"; throws std::invalid_argument unless the text names each axis once.
Axes parse_axes(const std::string& text);
/// All 48, the identity first.
const std::vector<Axes>& all_axes();

struct Convention {
  Normalization normalization = Normalization::kOrthonormal;
  bool condon_shortley = false;  // (-1)^m: real functions, both signs of m; complex, m > 0
  bool complex = false;
  IndexOrder order = IndexOrder::kAcn;
  Axes axes{};
  Folded folded = Folded::kNothing;  // into the functions

  friend bool operator==(const Convention&, const Convention&) = default;
};

inline constexpr int kMaxDegree = 20;

/// kMaxDegree, or 3 with Furse-Malham weights.
int largest_degree(const Convention& convention);

/// In words: "real, orthonormal, no Condon-Shortley phase, ACN order, axes x,y,z".
std::string describe(const Convention& convention);
std::string name_of(Normalization normalization);
std::string name_of(IndexOrder order);
std::string name_of(Folded folded);

/// Elements of an array for degrees 0 .. max_degree, holes included, and the place of (l, m) in it.
int storage_size(IndexOrder order, int max_degree);
int storage_position(IndexOrder order, int max_degree, int degree, int order_m);

/// The function that an array element holds; degree -1 marks a hole.
struct Function {
  int degree = -1;
  int order = 0;
  [[nodiscard]] bool is_hole() const { return degree < 0; }
};
std::vector<Function> functions_in_order(IndexOrder order, int max_degree);

/// `size` above, for l <= kMaxDegree: relative to the orthonormal function of the same kind. Relative error 1e-17.
long double relative_size(const Convention& convention, int degree, int order);
/// The factor that turns the polynomial of lowest integers into the orthonormal real function: its "constant", such as
/// 1.092548 in 1.092548 xy.
long double primitive_constant(int degree, int order);

/// The functions at a direction (scaled to length 1 in long double), in array order, holes zero. (storage_size)
std::vector<std::complex<double>> convention_values(const Convention& convention, int max_degree,
                                                    const std::array<double, 3>& direction);

/// A convention in use. Its functions are written in the source's own coordinates; `world` takes a direction of our
/// world (x right, y forward, z up, right-handed) to those.
struct Preset {
  std::string name;
  Convention convention;
  Axes world;
  std::string source;
  Folded coefficients_hold = Folded::kNothing;  // its coefficients hold the factor, its functions do not
};
const std::vector<Preset>& presets();

/// Presets that say the same as a convention, in their own coordinates or, where those differ, in our world's.
struct PresetNames {
  std::vector<std::string> own, world;
  [[nodiscard]] bool empty() const { return own.empty() && world.empty(); }
};

/// The presets whose convention is the `same` but for the axes and whose axes, own or world, are `same_axes`.
template <class Same, class SameAxes>
PresetNames preset_names(const Axes& axes, const Same& same, const SameAxes& same_axes) {
  PresetNames names;
  for (const Preset& preset : presets()) {
    if (!same(preset.convention)) continue;
    if (same_axes(axes, preset.convention.axes)) {
      names.own.push_back(preset.name);
    } else if (same_axes(axes, preset.world)) {
      names.world.push_back(preset.name);
    }
  }
  return names;
}

}  // namespace sh::numeric::identify
