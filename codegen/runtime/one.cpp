// One product or one rotation: passes each call to the kernel of the instruction set in use.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#include "one.hpp"

#include "choice.hpp"

#define SH_BATCH_DECLARE(isa)                             \
  namespace isa {                                         \
  extern const detail::ProductOne kProductOne[];          \
  extern const detail::RotateOne kRotateOne[];            \
  extern const detail::RotatePrepare kRotatePrepareOne[]; \
  extern const detail::RotateOne kRotatePreparedOne[];    \
  }

namespace sh::batch {

SH_BATCH_DECLARE(baseline)
SH_BATCH_DECLARE(avx2)
SH_BATCH_DECLARE(avx512)

namespace {

// Kernels by instruction set and degree.
constexpr const detail::ProductOne* kProductTables[] = SH_BATCH_EVERY(kProductOne);
constexpr const detail::RotateOne* kRotateTables[] = SH_BATCH_EVERY(kRotateOne);
constexpr const detail::RotatePrepare* kPrepareTables[] = SH_BATCH_EVERY(kRotatePrepareOne);
constexpr const detail::RotateOne* kPreparedTables[] = SH_BATCH_EVERY(kRotatePreparedOne);
constexpr int kLargestOne = 10;  // degree

// The first call and wrong calls; in a function of their own, so that all other calls need no stack.
template <class Kernel, class... Arrays>
[[gnu::cold, gnu::noinline]] void call_first(const char* function, const Kernel* const* tables, int degree, int largest,
                                             Arrays... arrays) {
  detail::check_degree(function, degree, largest);
  tables[detail::chosen()][degree](arrays...);
}

template <class Kernel, class... Arrays>
inline void call_one(const char* function, const Kernel* const* tables, int degree, int largest, Arrays... arrays) {
  const int set = detail::in_use.load(std::memory_order_relaxed);
  if (set == detail::kNotChosen || degree < 0 || degree > largest) {
    return call_first(function, tables, degree, largest, arrays...);
  }
  tables[set][degree](arrays...);
}

}  // namespace

void product_one(int degree, const float* a, const float* b, float* out) {
  call_one("product_one", kProductTables, degree, kLargestOne, a, b, out);
}

void rotate_one(int degree, const float* r, const float* c, float* out) {
  call_one("rotate_one", kRotateTables, degree, kLargestOne, r, c, out);
}

std::size_t rotate_prepared_size(int degree) {
  detail::check_degree("rotate_prepared_size", degree, kLargestOne);
  // To degree 1 the matrices. Then columns: of bands 0 to 3 as many as the last of them has, 2l+1 of each further band; of
  // 16 lanes to band 7, of 24 above.
  const auto bands = static_cast<std::size_t>(degree) + 1;
  if (degree < 2) return bands * (2 * bands - 1) * (2 * bands + 1) / 3;
  if (degree == 2) return 80;
  const std::size_t narrow = bands < 8 ? bands : 8;
  return 16 * (narrow * narrow - 9) + 24 * (bands * bands - narrow * narrow);
}

void rotate_prepare(int degree, const float* r, float* prepared) {
  call_one("rotate_prepare", kPrepareTables, degree, kLargestOne, r, prepared);
}

void rotate_prepared_one(int degree, const float* prepared, const float* c, float* out) {
  call_one("rotate_prepared_one", kPreparedTables, degree, kLargestOne, prepared, c, out);
}

}  // namespace sh::batch
