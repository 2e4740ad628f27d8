// Glossy transfers that keep fewer bands, and the same transfers with zeros in place of the numbers that are left out.
#pragma once
#include <tuple>
#include <vector>

#include "tests/prt/emitted_cases.hpp"

namespace sh::prt::test {

/// Random visibility, and matrices of so many channels where the kind has them.
inline Transfer random_glossy(const TransferKind& kind, int degree, std::size_t channels, std::size_t vertices) {
  return with_lobes(kind, degree, vertices, matrices(degree, channels, Element::kHalf));
}

/// The transfer with complete rows, whose numbers beyond `kept` are zeros: counted here by band, one by one.
inline Transfer with_zeros(Transfer transfer, const KeptBands& kept) {
  const auto beyond = [](std::size_t i, int band) { return i >= coefficient_count(band); };
  for (std::size_t i = 0; i < transfer.coefficients.size(); ++i) {
    if (beyond(i % transfer.shape.columns(), kept.visibility)) transfer.coefficients[i] = 0.0F;
  }
  const std::size_t n = coefficient_count(transfer.degree());
  for (std::size_t i = 0; i < transfer.indirect.size(); ++i) {
    if (beyond(i % n, kept.light) || beyond(i / n % n, kept.result)) transfer.indirect[i] = 0.0F;
  }
  return transfer;
}

/// Complete rows in place of clusters and of bands that are left out.
inline Transfer complete(Transfer transfer) {
  for (auto [clusters, shape, numbers] :
       {std::tuple(&transfer.clusters, &transfer.shape, &transfer.coefficients),
        std::tuple(&transfer.indirect_clusters, &transfer.indirect_shape, &transfer.indirect)}) {
    if (!clusters->empty()) *numbers = clusters->rows();
    *clusters = {};
    shape->storage.clusters = shape->storage.vectors = 0;
  }
  if (transfer.indirect.empty()) return transfer;
  const TransferShape small = transfer.indirect_shape;
  TransferShape& whole = transfer.indirect_shape;
  whole.degree = whole.result_degree = transfer.degree();
  std::vector<float> all(transfer.mesh.positions.size() * whole.length(), 0.0F);
  for (std::size_t i = 0; i < transfer.indirect.size(); ++i) {
    const std::size_t row = i / small.columns();
    all[(row / small.rows() * whole.rows() + row % small.rows()) * whole.columns() + i % small.columns()] =
        transfer.indirect[i];
  }
  transfer.indirect = std::move(all);
  return transfer;
}

}  // namespace sh::prt::test
