#include "prt/splats/splat_axes.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace sh::prt {

Eigen::Matrix3d splat_axes(std::string_view letters) {
  constexpr std::string_view kPositive = "RUB";
  constexpr std::string_view kNegative = "LDF";
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (std::size_t row = 0; row < letters.size() && row < 3; ++row) {
    const std::size_t plus = kPositive.find(letters[row]);
    const std::size_t minus = kNegative.find(letters[row]);
    if (plus < 3) axes(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(plus)) = 1.0;
    if (minus < 3) axes(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(minus)) = -1.0;
  }
  if (letters.size() != 3 || !(axes.transpose() * axes).isIdentity(0.0)) {
    throw std::invalid_argument(fmt::format(
        "axes {}: expected three letters for x, y and z, one each of R or L (right, left), U or D (up, down), F or B "
        "(front, back), such as RDF",
        letters));
  }
  return axes;
}

Eigen::Matrix3d between_axes(std::string_view from, std::string_view to) {
  return splat_axes(to) * splat_axes(from).transpose();
}

}  // namespace sh::prt
