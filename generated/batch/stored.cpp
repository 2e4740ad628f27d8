// Transfer in blocks: checks a call and passes it to the kernel of the instruction set in use.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#include "stored.hpp"

#include <stdexcept>

#include "choice.hpp"

#define SH_BATCH_DECLARE(isa)                                                                              \
  namespace isa {                                                                                          \
  template <class Stored>                                                                                  \
  void relight_stored(const StoredBlocks<Stored>&, std::size_t, const float*, const float*, float*, bool); \
  }

namespace sh::batch {

SH_BATCH_DECLARE(baseline)
SH_BATCH_DECLARE(avx2)
SH_BATCH_DECLARE(avx512)

namespace {

template <class Stored>
void run(const StoredBlocks<Stored>& transfer, std::size_t blocks, const float* light, const float* factors, float* out,
         bool past_caches) {
  using Kernel = void (*)(const StoredBlocks<Stored>&, std::size_t, const float*, const float*, float*, bool);
  static constexpr Kernel kEvery[] = SH_BATCH_EVERY(relight_stored<Stored>);
  if (transfer.rows != 1 && transfer.rows != 3)
    throw std::invalid_argument("sh::batch::relight_stored: expected 1 or 3 rows");
  if (blocks == 0) return;
  const bool has_scales = sizeof(Stored) > 1 || transfer.scales != nullptr;
  if (transfer.data == nullptr || !has_scales || light == nullptr || out == nullptr) {
    throw std::invalid_argument("sh::batch::relight_stored: expected arrays, got a null pointer");
  }
  kEvery[detail::chosen()](transfer, blocks, light, factors, out, past_caches);
}

}  // namespace

void relight_stored(const StoredBlocks<float>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out, bool past_caches) {
  run(transfer, blocks, light, factors, out, past_caches);
}
void relight_stored(const StoredBlocks<Half>& transfer, std::size_t blocks, const float* light, const float* factors,
                    float* out, bool past_caches) {
  run(transfer, blocks, light, factors, out, past_caches);
}
void relight_stored(const StoredBlocks<std::int8_t>& transfer, std::size_t blocks, const float* light,
                    const float* factors, float* out, bool past_caches) {
  run(transfer, blocks, light, factors, out, past_caches);
}

}  // namespace sh::batch
