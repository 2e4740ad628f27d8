// Fixed parts of batch.hpp, batch.cpp and call.hpp of generated/batch: calls for one product or one rotation.
#include "codegen/print/one.hpp"

namespace sh::codegen::print {

const char* const kOneHeader =
    R"text(
/// One product of two functions, projected on the same bands, with SIMD inside: for what comes one at a time.
/// degree 0 to 10; a (bands^2), b (bands^2), out (bands^2), plain, of any alignment; out may be a or b.
/// Domain: any coefficients of which the squares can be added up; error at most 4 epsilon |a| |b|. Where an input is
/// infinite or not a number, so may be every output. Throws std::invalid_argument when the degree is out of range.
void product_one(int degree, const float* a, const float* b, float* out);

/// Coefficients of one rotated function, by a rotation matrix, with SIMD inside.
/// degree 0 to 10; r (9), c (bands^2), out (bands^2), plain, of any alignment; out may be c.
/// Domain: r, row by row, is a rotation: r r^T = 1, det r = 1; error at most 1e-6 |c| to degree 5.
/// Throws std::invalid_argument when the degree is out of range.
void rotate_one(int degree, const float* r, const float* c, float* out);

/// The same for a matrix that rotates many functions, one at a time: what depends on r once, then the rest for each.
/// prepared (rotate_prepared_size(degree)): of any alignment, the fastest when aligned to 64 bytes; the same on every
/// instruction set but for rounding, of no other use. Same domain and errors.
std::size_t rotate_prepared_size(int degree);
void rotate_prepare(int degree, const float* r, float* prepared);
void rotate_prepared_one(int degree, const float* prepared, const float* c, float* out);
)text";

const char* const kOneTypes = R"text(
/// A kernel for one product; c may be a or b.
using ProductOne = void (*)(const float* a, const float* b, float* c);

/// A kernel for one rotation, from a matrix or what was prepared of it; out may be c.
using RotateOne = void (*)(const float* r, const float* c, float* out);
using RotatePrepare = void (*)(const float* r, float* prepared);

)text";

const char* const kOneDeclarations =
    R"text(extern const detail::ProductOne kProductOne[];
extern const detail::RotateOne kRotateOne[];
extern const detail::RotatePrepare kRotatePrepareOne[];
extern const detail::RotateOne kRotatePreparedOne[];
)text";

const char* const kOneChoice =
    R"text(
namespace {

// Kernels by instruction set and degree.
#if defined(SH_BATCH_X86)
#define SH_BATCH_TABLES(kernels) {baseline::kernels, avx2::kernels, avx512::kernels}
#else
#define SH_BATCH_TABLES(kernels) {baseline::kernels}
#endif
constexpr const detail::ProductOne* kProductTables[] = SH_BATCH_TABLES(kProductOne);
constexpr const detail::RotateOne* kRotateTables[] = SH_BATCH_TABLES(kRotateOne);
constexpr const detail::RotatePrepare* kPrepareTables[] = SH_BATCH_TABLES(kRotatePrepareOne);
constexpr const detail::RotateOne* kPreparedTables[] = SH_BATCH_TABLES(kRotatePreparedOne);
constexpr int kLargestOne = 10;  // degree

void check_degree(const char* function, int degree, int largest) {
  if (degree >= 0 && degree <= largest) return;
  throw std::invalid_argument(std::string("sh::batch::") + function + ": degree " + std::to_string(degree) +
                              "; it should be 0 to " + std::to_string(largest));
}

// What a call does that is the first one, or wrong; apart, so that the others need no stack.
template <class Kernel, class... Arrays>
[[gnu::cold, gnu::noinline]] void call_first(const char* function, const Kernel* const* tables, int degree, int largest,
                                             Arrays... arrays) {
  check_degree(function, degree, largest);
  tables[static_cast<int>(instruction_set())][degree](arrays...);
}

template <class Kernel, class... Arrays>
inline void call_one(const char* function, const Kernel* const* tables, int degree, int largest, Arrays... arrays) {
  const int set = in_use.load(std::memory_order_relaxed);
  if (set == kNotChosen || degree < 0 || degree > largest) {
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
  check_degree("rotate_prepared_size", degree, kLargestOne);
  // In columns of 16 from degree 3 to 6: 7 of bands 0 to 3, 2l+1 of each further band; otherwise the matrices.
  const auto bands = static_cast<std::size_t>(degree) + 1;
  if (degree >= 3 && degree <= 6) return 16 * (bands * bands - 9);
  return bands * (2 * bands - 1) * (2 * bands + 1) / 3;
}

void rotate_prepare(int degree, const float* r, float* prepared) {
  call_one("rotate_prepare", kPrepareTables, degree, kLargestOne, r, prepared);
}

void rotate_prepared_one(int degree, const float* prepared, const float* c, float* out) {
  call_one("rotate_prepared_one", kPreparedTables, degree, kLargestOne, prepared, c, out);
}
)text";

}  // namespace sh::codegen::print
