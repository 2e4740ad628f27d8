#include "prt/transfer/kept_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

KeptBands KeptBands::within(int degree) const {
  return {std::min(visibility, 2 * degree), std::min(result, degree), std::min(light, degree)};
}

KeptBands kept_by(const Transfer& transfer) {
  KeptBands kept;
  const std::vector<std::uint32_t>& columns = transfer.shape.storage.kept;
  if (!columns.empty()) kept.visibility = static_cast<int>(std::sqrt(static_cast<double>(columns.back())));
  if (transfer.kind->stores_matrices()) {
    kept.result = transfer.indirect_shape.result_degree;
    kept.light = transfer.indirect_shape.degree;
  }
  return kept.within(transfer.degree());
}

TransferShape with_bands(TransferShape shape, const KeptBands& kept) {
  if (shape.meets == Meets::kOperator) {
    const bool all = kept.visibility >= shape.function_degree();
    shape.storage.kept.resize(all ? 0 : coefficient_count(kept.visibility));
    std::iota(shape.storage.kept.begin(), shape.storage.kept.end(), 0U);
  } else if (shape.meets == Meets::kDot && !shape.holds_cosine) {
    shape.degree = std::min(shape.degree, kept.light);
    shape.result_degree = std::min(shape.result_degree, kept.result);
  }
  return shape;
}

void append_lower(const float* numbers, const TransferShape& whole, const TransferShape& part,
                  std::vector<float>& low) {
  for (std::size_t c = 0; c < part.channels; ++c) {
    for (std::size_t r = 0; r < part.rows(); ++r) {
      const float* from = numbers + c * whole.count() + r * whole.columns();
      low.insert(low.end(), from, from + part.columns());
    }
  }
}

void keep_bands(const KeptBands& kept, Transfer& transfer) {
  transfer.shape = with_bands(transfer.shape, kept);
  const std::size_t some = transfer.shape.storage.kept.size();
  for (std::size_t v = 0; some > 0 && transfer.shape.meets == Meets::kOperator && v < transfer.receivers(); ++v) {
    std::fill(transfer.row(v) + some, transfer.row(v) + transfer.shape.length(), 0.0F);
  }
  if (transfer.indirect.empty()) return;
  const TransferShape whole = transfer.indirect_shape;
  transfer.indirect_shape = with_bands(whole, kept);
  std::vector<float> low;
  low.reserve(transfer.receivers() * transfer.indirect_shape.length());
  for (std::size_t first = 0; first < transfer.indirect.size(); first += whole.length()) {
    append_lower(transfer.indirect.data() + first, whole, transfer.indirect_shape, low);
  }
  transfer.indirect = std::move(low);
}

}  // namespace sh::prt
