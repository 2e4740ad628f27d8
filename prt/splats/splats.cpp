#include "prt/splats/splats.hpp"

#include <algorithm>

namespace sh::prt {
namespace {

template <class T>
void keep_rows(std::vector<T>& values, std::size_t row, const std::vector<std::size_t>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(rows[i] * row);
    std::copy(from, from + static_cast<std::ptrdiff_t>(row), values.begin() + static_cast<std::ptrdiff_t>(i * row));
  }
  values.resize(rows.size() * row);
}

}  // namespace

void SplatBlock::resize(std::size_t splats, int coefficients_degree) {
  count = splats;
  degree = coefficients_degree;
  position.resize(3 * count);
  normal.assign(3 * count, 0.0F);
  rotation.resize(4 * count);
  log_scale.resize(3 * count);
  opacity.resize(count);
  harmonics.resize(3 * bands_squared() * count);
}

void SplatBlock::keep(const std::vector<std::size_t>& splats) {
  if (splats.size() == count) return;
  keep_rows(position, 3, splats);
  keep_rows(normal, 3, splats);
  keep_rows(rotation, 4, splats);
  keep_rows(log_scale, 3, splats);
  keep_rows(opacity, 1, splats);
  keep_rows(harmonics, 3 * bands_squared(), splats);
  keep_rows(records, record_size, splats);
  count = splats.size();
}

}  // namespace sh::prt
