// The shape of a row of a probe: the numbers of a vertex, followed by its matrices where bounces between lobes make them.
#pragma once
#include <cstddef>
#include <optional>

#include "prt/bake/glossy_exit.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/transfer/kept_bands.hpp"

namespace sh::prt {

struct RowShape {
  RowShape(TransferShape shape) : numbers(std::move(shape)) {}  // NOLINT(google-explicit-constructor): without matrices
  RowShape(const TransferKind& kind, const Mesh& mesh, int degree) : numbers(kind.shape(degree)) {
    if (kind.indirect != nullptr) matrices = glossy_matrix_shape(mesh, degree);
  }

  TransferShape numbers;
  std::optional<TransferShape> matrices;

  /// The same with these bands.
  [[nodiscard]] RowShape with(const KeptBands& kept) const {
    RowShape some = *this;
    some.numbers = with_bands(numbers, kept);
    if (matrices) some.matrices = with_bands(*matrices, kept);
    return some;
  }
  [[nodiscard]] std::size_t length() const { return numbers.length() + (matrices ? matrices->length() : 0); }
  /// The bytes that a file has for all receivers.
  [[nodiscard]] std::size_t stored_bytes(std::size_t receivers) const {
    return numbers.stored_bytes(receivers) + (matrices ? matrices->stored_bytes(receivers) : 0);
  }
};

}  // namespace sh::prt
