// The bands that files keep of glossy transfer. The visibility may end below twice the degree of the light; the numbers
// above are then zeros. The matrices may lead from fewer bands of the light to fewer bands of the radiance: 25 x 9 and
// 9 x 25 numbers as well as 25 x 25 [SloanKautzSnyder02, section 4.2]. In memory, too, they have only those numbers.
#pragma once
#include <vector>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

struct Transfer;

/// The highest bands to keep, 0 or more; those that a shape has if these are fewer.
struct KeptBands {
  int visibility = 2 * kMaxDegree;
  int result = kMaxDegree;  // of the radiance: rows of the matrices
  int light = kMaxDegree;   // columns of the matrices

  bool operator==(const KeptBands&) const = default;
  /// Those that transfer of this degree has.
  [[nodiscard]] KeptBands within(int degree) const;
};

/// The shape of visibility or of matrices of which a file keeps these bands; other shapes as they are.
TransferShape with_bands(TransferShape shape, const KeptBands& kept);

/// Appends the numbers of a receiver of shape `whole` that `part` has, whose degrees are no higher, to `low`.
void append_lower(const float* numbers, const TransferShape& whole, const TransferShape& part, std::vector<float>& low);

/// The bands that a transfer with visibility keeps.
KeptBands kept_by(const Transfer& transfer);

/// Leaves the other bands out. The transfer has rows, not clusters.
void keep_bands(const KeptBands& kept, Transfer& transfer);

}  // namespace sh::prt
