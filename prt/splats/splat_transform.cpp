#include "prt/splats/splat_transform.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "generated/batch/batch.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::prt {
namespace {

using numeric::coefficient_index;

/// The rotation of a splat under an orthogonal matrix: with a mirrored ellipsoid -M M' serves as well as M M', as an
/// ellipsoid is its own image under inversion.
Eigen::Matrix3d proper(const Eigen::Matrix3d& turn) { return turn.determinant() < 0.0 ? Eigen::Matrix3d(-turn) : turn; }

void transform_vectors(const Similarity& similarity, std::vector<float>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); i += 3) {
    Eigen::Map<Eigen::Vector3f> v(&vectors[i]);
    v = similarity.apply(v.cast<double>()).cast<float>();
  }
}

void turn_rotations(const Eigen::Matrix3d& turn, std::vector<float>& rotations) {
  const Eigen::Quaterniond q(proper(turn));
  for (std::size_t i = 0; i < rotations.size(); i += 4) {
    float* r = &rotations[i];
    const Eigen::Vector4d old = Eigen::Map<const Eigen::Vector4f>(r).cast<double>();
    const Eigen::Quaterniond turned = q * Eigen::Quaterniond(old[0], old[1], old[2], old[3]);
    const Eigen::Vector4d now(turned.w(), turned.x(), turned.y(), turned.z());
    Eigen::Map<Eigen::Vector4f>(r, 4) = now.cast<float>();
  }
}

/// The factor of each coefficient when the axes are flipped: Y_lm is odd or even in x, y and z.
std::vector<float> signs_of_flips(const Eigen::Matrix3d& flips, int degree) {
  std::vector<float> signs(splat_bands_squared(degree));
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const bool odd_x = m < 0 ? m % 2 == 0 : m % 2 != 0;
      const bool odd_y = m < 0;
      const bool odd_z = (l + m) % 2 != 0;
      const bool negative =
          (odd_x && flips(0, 0) < 0.0) != ((odd_y && flips(1, 1) < 0.0) != (odd_z && flips(2, 2) < 0.0));
      signs[static_cast<std::size_t>(coefficient_index(l, m))] = negative ? -1.0F : 1.0F;
    }
  }
  return signs;
}

void scale_coefficients(const std::vector<float>& factors, std::vector<float>& harmonics) {
  for (std::size_t i = 0; i < harmonics.size(); i += factors.size()) {
    for (std::size_t k = 0; k < factors.size(); ++k) harmonics[i + k] *= factors[k];
  }
}

void turn_harmonics(const Eigen::Matrix3d& turn, SplatBlock& block) {
  if (block.degree == 0) return;
  if (turn.cwiseAbs().isIdentity(0.0)) return scale_coefficients(signs_of_flips(turn, block.degree), block.harmonics);
  const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> rows = proper(turn).cast<float>();
  float* all = block.harmonics.data();
  batch::rotate(block.degree, 3 * block.count, batch::shared(rows.data()), batch::plain(all), batch::plain(all));
  if (turn.determinant() < 0.0) {  // and the inversion
    scale_coefficients(signs_of_flips(-Eigen::Matrix3d::Identity(), block.degree), block.harmonics);
  }
}

}  // namespace

Similarity Similarity::after(const Similarity& first) const {
  return {turn * first.turn, scale * first.scale, scale * (turn * first.move) + move};
}

SplatParts Similarity::changes() const {
  const bool turns = !turn.isIdentity(0.0);
  const bool scales = scale != 1.0;
  return {!is_identity(), turns, scales, turns, false};
}

Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& matrix, const char* name) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  constexpr double kRounded = 1e-3;
  if (!matrix.allFinite() || !((matrix - nearest).cwiseAbs().maxCoeff() <= kRounded)) {
    throw std::invalid_argument(
        fmt::format("{}: expected a rotation matrix, whose rows have length 1 and are at right angles; a uniform scale "
                    "belongs to --scale",
                    name));
  }
  if (nearest.determinant() < 0.0) {
    throw std::invalid_argument(
        fmt::format("{}: expected a rotation matrix of determinant 1, got a reflection; other axes belong to "
                    "--axes-in and --axes-out",
                    name));
  }
  constexpr double kExact = 1e-14;
  return (matrix - nearest).cwiseAbs().maxCoeff() <= kExact ? matrix : nearest;
}

void transform(const Similarity& similarity, SplatBlock& block) {
  const SplatParts changes = similarity.changes();
  transform_positions(similarity, block);
  if (changes.rotation) {
    transform_vectors({similarity.turn}, block.normal);
    turn_rotations(similarity.turn, block.rotation);
  }
  if (changes.scale) {
    const auto more = static_cast<float>(std::log(similarity.scale));
    for (float& s : block.log_scale) s += more;
  }
  if (changes.harmonics) turn_harmonics(similarity.turn, block);
}

void transform_positions(const Similarity& similarity, SplatBlock& block) {
  if (similarity.is_identity()) return;
  transform_vectors(similarity, block.position);
}

void crop(const Eigen::AlignedBox3d& box, const Similarity& placement, SplatBlock& block) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < block.count; ++i) {
    const Eigen::Vector3d position = Eigen::Map<const Eigen::Vector3f>(&block.position[3 * i]).cast<double>();
    if (box.contains(placement.apply(position))) inside.push_back(i);
  }
  block.keep(inside);
}

void change_degree(int degree, SplatBlock& block) {
  if (degree == block.degree) return;
  const std::size_t before = block.bands_squared();
  const std::size_t now = splat_bands_squared(degree);
  std::vector<float> harmonics(3 * block.count * now, 0.0F);
  for (std::size_t row = 0; row < 3 * block.count; ++row) {
    std::copy_n(&block.harmonics[row * before], std::min(before, now), &harmonics[row * now]);
  }
  block.harmonics = std::move(harmonics);
  block.degree = degree;
}

}  // namespace sh::prt
