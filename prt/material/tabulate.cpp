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

void ReflectanceRow::add(const Eigen::Vector3d& light, const Eigen::Vector3d& values) {
  BasisValues basis;
  evaluate_basis(kMaxDegree, light.x(), light.y(), light.z(), basis.data());
  for (int l = 0; l <= kMaxDegree; ++l) {
    sums_.middleCols(Eigen::Index(even_count(l)) - l - 1, l + 1) +=
        values.lazyProduct(band(basis.data(), l).tail(l + 1).matrix().transpose());
  }
}

void ReflectanceRow::add(const Eigen::Matrix3d& mix, const ReflectanceRow& other) { sums_ += mix * other.sums_; }

void ReflectanceRow::write(int view, ReflectanceTable& table) const {
  using Row = Eigen::Matrix<float, kReflectionParts, even_count(kMaxDegree), Eigen::RowMajor>;
  Eigen::Map<Row>(table.data() + view * sums_.size()) = sums_.cast<float>();
}

}  // namespace sh::prt
