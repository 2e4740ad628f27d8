#include "prt/transfer/visibility.hpp"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <utility>

#include "generated/batch/batch.hpp"
#include "generated/cpp/transfer_prepare.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kVerticesAtOnce = 2048;
constexpr std::size_t kPaddedAtOnce = 256;  // that stay in the cache beside their copies

}  // namespace

std::vector<float> prepared_light(int degree, const float* light) {
  std::vector<float> samples;
  at_degree(degree, [&](auto known) {
    if constexpr (known() <= kHighestProduct) {
      constexpr std::size_t kSamples = known() == 0 ? 1 : 8 * known() * known() + 4;
      samples.resize(kChannels * kSamples);
      for (std::size_t c = 0; c < kChannels; ++c) {
        sh::transfer_prepare<known()>(light + c * coefficient_count(known()), &samples[c * kSamples]);
      }
    }
  });
  return samples;
}

void times_visibility(int degree, const Rows& visibility, const std::vector<float>& prepared, float* out) {
  const std::size_t out_length = kChannels * coefficient_count(degree);
  in_parallel(tbb::blocked_range<std::size_t>(0, visibility.count(), kVerticesAtOnce), [&](const auto& range) {
    visibility.each(range.begin(), range.size(), [&](std::size_t first, std::size_t count, const float* rows) {
      batch::transfer_apply_rgb(degree, count, batch::plain(rows), prepared.data(),
                                batch::plain(out + first * out_length));
    });
  });
}

// The kernels have one degree for light and result, and twice as much for the visibility: zeros fill it up, and the bands
// above the result are left out.
void transfer_light(const TransferShape& shape, const Rows& visibility, const std::vector<float>& light, float* out) {
  const int degree = std::max(shape.degree, shape.result_degree);
  const std::size_t given = coefficient_count(shape.degree);
  std::vector<float> wide(kChannels * coefficient_count(degree));
  for (std::size_t c = 0; c < kChannels; ++c) {
    std::copy_n(light.begin() + static_cast<std::ptrdiff_t>(c * given), given, &wide[c * coefficient_count(degree)]);
  }
  const std::vector<float> prepared = prepared_light(degree, wide.data());
  if (shape.degree == shape.result_degree) return times_visibility(degree, visibility, prepared, out);
  const std::size_t columns = shape.columns();
  const std::size_t padded = coefficient_count(2 * degree);
  const std::size_t bands = coefficient_count(degree);
  const std::size_t kept = coefficient_count(shape.result_degree);
  in_parallel(tbb::blocked_range<std::size_t>(0, visibility.count(), kPaddedAtOnce), [&](const auto& all) {
    std::vector<float> seen(kPaddedAtOnce * padded);
    std::vector<float> lit(kept < bands ? kPaddedAtOnce * kChannels * bands : 0);
    std::vector<float> room;
    for (std::size_t first = all.begin(); first < all.end(); first += kPaddedAtOnce) {
      const std::size_t count = std::min(kPaddedAtOnce, all.end() - first);
      const float* rows = visibility.some(first, count, room);
      for (std::size_t v = 0; v < count; ++v) std::copy_n(rows + v * columns, columns, &seen[v * padded]);
      float* to = lit.empty() ? out + first * kChannels * bands : lit.data();
      batch::transfer_apply_rgb(degree, count, batch::plain(std::as_const(seen).data()), prepared.data(),
                                batch::plain(to));
      for (std::size_t row = 0; row < (lit.empty() ? 0 : count * kChannels); ++row) {
        std::copy_n(&lit[row * bands], kept, out + (first * kChannels + row) * kept);
      }
    }
  });
}

}  // namespace sh::prt
