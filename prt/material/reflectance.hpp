// Isotropic BRDFs as tables: for each angle of view, the SH coefficients of BRDF times clamped cosine, a function of the
// direction of the light [SloanKautzSnyder02, section 4.2; KautzSloanSnyder02]. The radiance that leaves towards the eye
// is the dot product of these coefficients and of the radiance that arrives, both in the frame of the surface: z is the
// normal, and the eye stands over x >= 0, y = 0. There the function is even in y: only coefficients with m >= 0 remain.
// The table is exact in the view but for interpolation, and exact in the light up to its degree.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "prt/arrays.hpp"
#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// The angles of view, equidistant from 0 to pi/2.
inline constexpr int kViews = 65;

/// The colored functions whose sum is the reflection.
inline constexpr std::size_t kReflectionParts = 3;

/// Y_lm with 0 <= m <= l <= degree, at l(l+1)/2 + m.
constexpr std::size_t even_count(int degree) {
  return (static_cast<std::size_t>(degree) + 1) * (static_cast<std::size_t>(degree) + 2) / 2;
}

/// The coefficients of degree l with m >= 0 in such a row: l+1 numbers.
template <class T>
auto even_band(T* row, int l) {
  return as_array(row + (l > 0 ? even_count(l - 1) : 0), static_cast<std::size_t>(l) + 1);
}

/// The most tables of a mesh, of 51,480 bytes each.
inline constexpr std::size_t kMostBrdfs = 1000;

/// (kViews, kReflectionParts, even_count(kMaxDegree)) coefficients.
using ReflectanceTable = std::vector<float>;
inline constexpr std::size_t kReflectanceTableSize = kViews * kReflectionParts * even_count(kMaxDegree);

/// A table where it stands, or none.
struct BrdfTable {
  const float* rows = nullptr;
  bool is_measured = false;
  explicit operator bool() const { return rows != nullptr; }
};

/// The colors of the parts: albedo, white and black for a surface model; red, green and blue for a measured BRDF, which
/// has no other color.
std::array<Eigen::Vector3f, kReflectionParts> colors_of_parts(bool is_measured, const Eigen::Vector3f& albedo);

struct Reflectance {
  std::string name;  // for people
  bool is_measured = false;
  ReflectanceTable table;
  bool operator==(const Reflectance&) const = default;
};

/// The tables of a mesh, one after another, as in files.
struct Reflectances {
  struct Head {
    std::string name;
    bool is_measured = false;
  };
  std::vector<Head> heads;
  ReflectanceTable rows;

  [[nodiscard]] BrdfTable table(std::size_t number) const {
    return {rows.data() + number * kReflectanceTableSize, heads[number].is_measured};
  }
  /// The number of an equal one, which is added if there is none. Throws std::runtime_error for more than kMostBrdfs.
  std::size_t number_of(const Reflectance& reflectance);
  [[nodiscard]] Reflectance at(std::size_t number) const;
};

/// out (kReflectionParts, even_count(degree)) = the coefficients at an angle between the normal and the view, in
/// radians, by cubic interpolation; from pi/2 on those of grazing view. Precondition: angle >= 0.
void reflectance_at(const float* table, int degree, float angle, float* out);

/// The part of the function that the bands 0 .. degree hold, 0..1, in squares, when the eye is at 45 degrees; of all that
/// kMaxDegree holds. A surface model has albedo 0.5 here.
double share_of_bands(const BrdfTable& table, int degree);

/// The hemispherical reflectance under constant light, a number for each part, at a number of view: 1 = all is reflected.
Eigen::Vector3d hemispherical_reflectance(const float* table, int view);

}  // namespace sh::prt
