#include "prt/transfer/visibility.hpp"

#include <oneapi/tbb/blocked_range.h>

#include "generated/batch/batch.hpp"
#include "generated/cpp/transfer_prepare.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kVerticesAtOnce = 2048;

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

void times_visibility(int degree, std::size_t vertices, const float* visibility, const std::vector<float>& prepared,
                      float* out) {
  const std::size_t in_length = coefficient_count(2 * degree);
  const std::size_t out_length = kChannels * coefficient_count(degree);
  in_parallel(tbb::blocked_range<std::size_t>(0, vertices, kVerticesAtOnce), [&](const auto& range) {
    batch::transfer_apply_rgb(degree, range.size(), batch::plain(visibility + range.begin() * in_length),
                              prepared.data(), batch::plain(out + range.begin() * out_length));
  });
}

}  // namespace sh::prt
