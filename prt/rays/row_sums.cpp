#include "prt/rays/row_sums.hpp"

#include "prt/rays/widest.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kRowUnit = sizeof(FloatLanes) / sizeof(float);
static_assert(padded_row(1) == kRowUnit);

// sum (8 Count) = the weighted sum of the chosen rows, kept in registers.
template <std::size_t Count>
[[gnu::always_inline]] inline void sum_block(const float* values, std::size_t row_length, const std::uint32_t* chosen,
                                             std::size_t count, const float* weights, float* sum) {
  FloatLanes block[Count] = {};
  for (std::size_t k = 0; k < count; ++k) {
    const float weight = weights[chosen[k]];
    const auto* row = reinterpret_cast<const FloatLanesAnywhere*>(values + chosen[k] * row_length);
    for (std::size_t i = 0; i < Count; ++i) block[i] += weight * row[i].lanes;
  }
  auto* to = reinterpret_cast<FloatLanesAnywhere*>(sum);
  for (std::size_t i = 0; i < Count; ++i) to[i].lanes = block[i];
}

}  // namespace

SHFORGE_WIDEST void sum_rows(const float* values, std::size_t row_length, const std::uint32_t* chosen,
                             std::size_t count, const float* weights, float* sum) {
  std::size_t first = 0;
  for (; first + 8 * kRowUnit <= row_length; first += 8 * kRowUnit) {  // sums enough to hide how long an addition takes
    sum_block<8>(values + first, row_length, chosen, count, weights, sum + first);
  }
  for (; first + 4 * kRowUnit <= row_length; first += 4 * kRowUnit) {
    sum_block<4>(values + first, row_length, chosen, count, weights, sum + first);
  }
  for (; first + 2 * kRowUnit <= row_length; first += 2 * kRowUnit) {
    sum_block<2>(values + first, row_length, chosen, count, weights, sum + first);
  }
  for (; first + kRowUnit <= row_length; first += kRowUnit) {
    sum_block<1>(values + first, row_length, chosen, count, weights, sum + first);
  }
}

}  // namespace sh::prt
