#include "prt/bake/unshadowed.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/bake/chunks.hpp"
#include "prt/basis.hpp"

namespace sh::prt {

namespace {

void unshadowed(int degree, const Eigen::Vector3f& normal, float* out) {
  evaluate_basis(degree, normal.x(), normal.y(), normal.z(), out);
  for (std::ptrdiff_t l = 0; l <= degree; ++l) {
    const auto factor =
        static_cast<float>(numeric::clamped_cosine_factor<double>(static_cast<int>(l)) / std::numbers::pi);
    std::for_each(out + l * l, out + (l + 1) * (l + 1), [&](float& value) { value *= factor; });
  }
}

}  // namespace

std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals) {
  const auto bands = static_cast<std::size_t>(degree) + 1;
  const std::size_t count = bands * bands;
  std::vector<float> transfer(normals.size() * count);
  for_chunks(normals.size(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, normals.size());
    for (std::size_t v = range.first; v < range.last; ++v) unshadowed(degree, normals[v], transfer.data() + v * count);
  });
  return transfer;
}

}  // namespace sh::prt
