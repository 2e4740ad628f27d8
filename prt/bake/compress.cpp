#include "prt/bake/compress.hpp"

#include <algorithm>
#include <cmath>

#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

bool fits_half(const std::vector<float>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](float number) {
    return std::isfinite(encoding_error(Element::kHalf, std::abs(static_cast<double>(number))));
  });
}

void cluster_rows(ClusterCounts counts, std::vector<float>& rows, TransferShape& shape, Clusters& clusters) {
  shape.storage.element = Element::kSingle;
  if (!shape.storage.kept.empty()) rows = decode(encode(rows, shape), shape);  // no vectors for columns that files lose
  shape.storage.element = Element::kHalf;
  clusters = clustered(rows, shape.length(), counts, [&](const std::vector<float>& basis) {
    if (!fits_half(basis)) shape.storage.element = Element::kSingle;
    return decode(encode(basis, shape), shape);
  });
  shape.storage.clusters = static_cast<std::uint32_t>(clusters.count());
  shape.storage.vectors = static_cast<std::uint32_t>(clusters.vectors);
  rows = {};
}

}  // namespace

void compress(Transfer& transfer, ClusterCounts counts) {
  if (transfer.kind->indirect == nullptr) {
    return cluster_rows(counts, transfer.coefficients, transfer.shape, transfer.clusters);
  }
  Element& element = transfer.shape.storage.element;
  if (element == Element::kSingle) element = Element::kHalf;
  cluster_rows(counts, transfer.indirect, transfer.indirect_shape, transfer.indirect_clusters);
}

}  // namespace sh::prt
