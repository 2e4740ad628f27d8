// A convention of spherical harmonics as a value: its functions and the places of its coefficients.
//
// Ours is the default value: real, orthonormal, no Condon-Shortley phase, index l(l+1)+m, z up. The functions Y' of any
// other convention follow from ours, band by band: Y'_l(s) = A_l Y_l(s), with
//     A_l = (normalization, phase) * (complex or real) * D_l(axes).
// Coefficients go the other way: the function f = sum c Y = sum c' Y' is the same, so c' = A^-T c; then come the folded
// factors.
#pragma once

#include <cln/rational.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic {

// Axes: the 48 signed permutations of x, y, z, and the band matrices that they induce.
//
// A convention may name the axes in another way: y up instead of z, a left-handed frame. Its coordinates are s' = P s;
// each of them is one of our coordinates with a sign. The functions follow Y_l(P s) = D_l(P) Y_l(s): a signed
// permutation in bands 0 and 1, a full matrix with surds from band 2 on. P may be a reflection: D_l(-1) = (-1)^l.

class SignedPermutation {
 public:
  /// The identity: x, y, z.
  SignedPermutation() = default;
  /// "x,z,-y" says x' = x, y' = z, z' = -y. Throws std::invalid_argument unless each axis occurs once.
  explicit SignedPermutation(std::string_view text);

  /// Coordinate `row` of s' is sign(row) * (coordinate axis(row) of s).
  [[nodiscard]] int axis(int row) const { return axes_[row]; }
  [[nodiscard]] int sign(int row) const { return signs_[row]; }
  /// +1 keeps the handedness, -1 changes it.
  [[nodiscard]] int determinant() const;
  [[nodiscard]] Matrix<cln::cl_RA> matrix() const;  // (3, 3)
  [[nodiscard]] SignedPermutation inverse() const;
  [[nodiscard]] std::string to_string() const;

  /// First b, then a.
  friend SignedPermutation operator*(const SignedPermutation& a, const SignedPermutation& b);
  friend bool operator==(const SignedPermutation&, const SignedPermutation&) = default;

 private:
  std::array<int, 3> axes_{0, 1, 2};
  std::array<int, 3> signs_{1, 1, 1};
};

/// All 48, in a fixed order, the identity first.
std::vector<SignedPermutation> all_signed_permutations();

/// The rational part T_l(P) of D_l(P), D_mn = (k_m/k_n) T_mn, by the recursion in R_ij; the surd
/// matrix is surd_entries(degree, ...). Throws std::invalid_argument beyond degree 20.
Matrix<cln::cl_RA> axes_band(const SignedPermutation& axes, int degree);

/// Size of a function. With a = |m|, P_l^a without the Condon-Shortley sign; complex functions lack the 2 - delta.
enum class Normalization {
  kOrthonormal,   ///< integral of |Y|^2 = 1
  kFourPi,        ///< integral = 4 pi: geodesy's 4-pi, ambisonics' N3D; Y_00 = 1
  kSchmidt,       ///< integral = 4 pi / (2l+1): Schmidt semi-normalized; Y_00 = 1
  kSn3d,          ///< integral = 1 / (2l+1): SN3D as the ambiX paper prints it, with 1/(4 pi) under the root
  kUnnormalized,  ///< P_l^a cos or sin (real only)
  kPrimitive,     ///< the reduced polynomial with coprime integer coefficients: 1, y, z, x, xy, yz, 3z^2-1, ... (real
                  ///< only)
  kFuMa,          ///< largest value 1, for W 1/sqrt 2: Furse-Malham weights (real only, to degree 3)
};

/// How an array holds the coefficients of degree 0..L.
enum class IndexOrder {
  kAcn,              ///< l(l+1)+m: -l .. l in each band
  kZeroFirst,        ///< bands in order, inside 0, 1, -1, 2, -2, ...
  kCosineSineBands,  ///< bands in order, inside 0, 1, .., l, -1, .., -l
  kCosineSineArray,  ///< array (2, L+1, L+1): [m < 0][l][|m|], with holes that hold zero
  kFuMa,             ///< W XYZ RSTUV KLMNOPQ: band 1 as 1, -1, 0, other bands as kZeroFirst
};

/// The factors that the coefficients include.
enum class Folded {
  kNothing,
  kCosineOverPi,  ///< A_l / pi: coefficients of irradiance / pi, to evaluate at a normal; to degree 2
};

struct Convention {
  Normalization normalization = Normalization::kOrthonormal;
  bool condon_shortley = false;  ///< factor (-1)^m: real functions, both signs of m; complex, m > 0
  bool complex = false;
  IndexOrder order = IndexOrder::kAcn;
  SignedPermutation axes{};  ///< its coordinates of a direction: s' = axes s
  Folded folded = Folded::kNothing;

  friend bool operator==(const Convention&, const Convention&) = default;
};

inline constexpr int kMaxConventionDegree = 20;

/// The largest degree of a convention: 20, 2 with the cosine folded in, since A_3 = 0 cannot be undone, or 3 with
/// Furse-Malham weights.
int largest_degree(const Convention& convention);

/// Throws std::invalid_argument for parts that contradict each other (complex, and unnormalized, primitive or
/// Furse-Malham) and for a degree outside 0 to largest_degree.
void require_convention(const Convention& convention, int degree);

/// Number of array elements for degree 0..L, holes included.
int storage_size(IndexOrder order, int max_degree);
/// The place of coefficient (l, m) in the array for degree 0..max_degree.
int storage_position(IndexOrder order, int max_degree, int degree, int order_m);

/// The real factor of Y'_lm before its real function S_lm or P_l^a exp(i m phi), phase included.
Surd convention_factor(const Convention& convention, int degree, int order);

/// Y'_lm written out in the convention's own coordinates: factor * (re + i im), rational polynomials, every term of
/// degree l; on the unit sphere it equals the function. im is zero for real conventions.
struct ConventionFunction {
  Surd factor;
  Polynomial re;
  Polynomial im;
};
ConventionFunction convention_function(const Convention& convention, int degree, int order);

/// A_l, (2l+1, 2l+1), rows and columns -l .. l, and its inverse.
Matrix<RadicalSum> basis_change(const Convention& convention, int degree);
Matrix<RadicalSum> basis_change_inverse(const Convention& convention, int degree);

/// The factor of band l in coefficients.
Surd folded_factor(Folded folded, int degree);

// Complex and real spherical harmonics: the unitary W between them.
//
// Both orthonormal. Complex: Y_lm = e_m k P_l^|m|(cos theta) exp(i m phi), e_m = (-1)^m for m > 0 with the
// Condon-Shortley phase, else 1; so Y_l,-m = (-1)^m conj(Y_lm), or conj(Y_lm) without the phase. Real: as
// symbolic/basis/basis.hpp. In each band Y_real = W Y_complex, with
//     Y_real,m = (e_m Y_m + Y_-m) / sqrt 2,   Y_real,-m = (e_m Y_m - Y_-m) / (i sqrt 2),   Y_real,0 = Y_0   (m > 0).
// If Y_complex(R s) = D Y_complex(s), the real matrix is W D W* [Brown04]. Coefficients transform with the conjugate:
// f = sum c Y gives c_complex = W^T c_real, c_real = conj(W) c_complex.

/// W of one band, (2l+1, 2l+1): row l+m real, column l+m complex.
Matrix<RadicalSum> real_from_complex(int degree, bool condon_shortley);

/// The conjugate transpose.
Matrix<RadicalSum> adjoint(const Matrix<RadicalSum>& m);

// Conventions in use: engines, file formats, libraries. Each preset is the convention as its source writes it, in the
// source's own coordinates x, y, z. Its axes are the identity where z is the polar axis of the source.

struct Preset {
  std::string name;
  Convention convention;
  SignedPermutation world;  ///< the axes in place of those of the convention, for directions of our world
  std::string source;       ///< the file or page that documents the convention
  std::string covers;       ///< the meaning of the coefficients, and the limits of the preset

  /// The convention with `world` as its axes.
  [[nodiscard]] Convention in_world() const;
};

/// All presets; the first is this project's own convention, "shforge".
const std::vector<Preset>& presets();

/// The preset of that name; throws std::invalid_argument with the names that exist.
const Preset& find_preset(std::string_view name);

}  // namespace sh::symbolic
