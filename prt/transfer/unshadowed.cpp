#include "prt/transfer/unshadowed.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals) {
  const std::size_t count = coefficient_count(degree);
  std::vector<float> transfer(normals.size() * count);
  for_vertices(normals.size(), [&](std::size_t v) {
    float* row = transfer.data() + v * count;
    evaluate_basis(degree, normals[v].x(), normals[v].y(), normals[v].z(), row);
    for (int l = 0; l <= degree; ++l) {
      const auto factor = static_cast<float>(numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
      std::for_each(row + l * l, row + (l + 1) * (l + 1), [factor](float& value) { value *= factor; });
    }
  });
  return transfer;
}

}  // namespace sh::prt
