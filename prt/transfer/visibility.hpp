// Products of visibility and light, projected, by the generated kernels `transfer_prepare` and `transfer_apply`: equation
// 11 of [SloanKautzSnyder02] without its matrix, and exact.
#pragma once
#include <cstddef>
#include <vector>

#include "prt/transfer/rows.hpp"
#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// A light (3, bands^2) of this degree as `times_visibility` takes it. Precondition: 0 <= degree <= kHighestProduct.
std::vector<float> prepared_light(int degree, const float* light);

/// out (rows, 3, bands^2) = visibility (rows, (2 degree + 1)^2) times the prepared light. In parallel; the same bits on one
/// instruction set (generated/batch/records.hpp).
void times_visibility(int degree, const Rows& visibility, const std::vector<float>& prepared, float* out);

/// The same where light and result may have different degrees, by a shape that meets the light by `operator`:
/// out (rows, 3, (result_degree+1)^2) = visibility (rows, shape.columns()) times light (3, (degree+1)^2).
/// Precondition: both degrees are 0 to kHighestProduct.
void transfer_light(const TransferShape& shape, const Rows& visibility, const std::vector<float>& light, float* out);

}  // namespace sh::prt
