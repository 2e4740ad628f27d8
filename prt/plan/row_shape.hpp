// The shape of a row of a probe: the numbers of a vertex, followed by its matrices where bounces between lobes make them.
#pragma once
#include <cstddef>
#include <optional>

#include "prt/bake/glossy_exit.hpp"
#include "prt/kinds/kinds.hpp"

namespace sh::prt {

struct RowShape {
  RowShape(TransferShape shape) : numbers(std::move(shape)) {}  // NOLINT(google-explicit-constructor): without matrices
  RowShape(const TransferKind& kind, const Mesh& mesh, int degree) : numbers(kind.shape(degree)) {
    if (kind.indirect != nullptr) matrices = glossy_matrix_shape(mesh, degree);
  }

  TransferShape numbers;
  std::optional<TransferShape> matrices;

  [[nodiscard]] std::size_t length() const { return numbers.length() + (matrices ? matrices->length() : 0); }
  /// The bytes that a file has for all receivers.
  [[nodiscard]] std::size_t stored_bytes(std::size_t receivers) const {
    return numbers.stored_bytes(receivers) + (matrices ? matrices->stored_bytes(receivers) : 0);
  }
};

}  // namespace sh::prt
