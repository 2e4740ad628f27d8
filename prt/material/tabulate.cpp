#include "prt/material/tabulate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/basis.hpp"

namespace sh::prt {

Eigen::Vector3d view_direction(int view) {
  constexpr double kLeastCosine = 1e-4;
  const double angle = view * (std::numbers::pi / 2.0) / (kViews - 1);
  const double cosine = std::max(std::cos(angle), kLeastCosine);
  return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

std::array<Eigen::Vector3d, even_count(kMaxDegree)> ReflectanceRow::zeros() {
  std::array<Eigen::Vector3d, even_count(kMaxDegree)> all;
  all.fill(Eigen::Vector3d::Zero());
  return all;
}

void ReflectanceRow::add(const Eigen::Vector3d& light, const Eigen::Vector3d& values) {
  BasisValues basis;
  evaluate_basis(kMaxDegree, light.x(), light.y(), light.z(), basis.data());
  auto sum = sums_.begin();
  for (int l = 0; l <= kMaxDegree; ++l) {
    for (int m = 0; m <= l; ++m) *sum++ += basis[coefficient_index(l, m)] * values;
  }
}

void ReflectanceRow::add(const Eigen::Matrix3d& mix, const ReflectanceRow& other) {
  for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += mix * other.sums_[i];
}

void ReflectanceRow::write(int view, ReflectanceTable& table) const {
  float* to = table.data() + static_cast<std::size_t>(view) * kReflectionParts * sums_.size();
  for (Eigen::Index part = 0; part < static_cast<Eigen::Index>(kReflectionParts); ++part) {
    for (const Eigen::Vector3d& sum : sums_) *to++ = static_cast<float>(sum[part]);
  }
}

}  // namespace sh::prt
