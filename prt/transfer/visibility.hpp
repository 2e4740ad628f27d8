// Products of visibility and light, projected, by the generated kernels `transfer_prepare` and `transfer_apply`: equation
// 11 of [SloanKautzSnyder02] without its matrix, and exact.
#pragma once
#include <cstddef>
#include <vector>

namespace sh::prt {

/// A light (3, bands^2) of this degree as `times_visibility` takes it. Precondition: 0 <= degree <= kHighestProduct.
std::vector<float> prepared_light(int degree, const float* light);

/// out (vertices, 3, bands^2) = visibility (vertices, (2 degree + 1)^2) times the prepared light. In parallel; the same bits
/// on one instruction set (generated/batch/records.hpp).
void times_visibility(int degree, std::size_t vertices, const float* visibility, const std::vector<float>& prepared,
                      float* out);

}  // namespace sh::prt
