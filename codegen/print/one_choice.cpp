// Fixed parts of generated/batch/batch.hpp and generated/batch/batch.cpp: calls for one product or one rotation.
#include "codegen/print/one.hpp"

namespace sh::codegen::print {

const char* const kOneHeader =
    R"text(
/// One product of two functions, projected on the same bands, with SIMD inside: for what comes one at a time.
/// degree 0 to 6; a (bands^2), b (bands^2), out (bands^2), plain, of any alignment; out may be a or b.
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

const char* const kOneDeclarations =
    R"text(extern const detail::ProductOne kProductOne[];
extern const detail::RotateOne kRotateOne[];
extern const detail::RotatePrepare kRotatePrepareOne[];
extern const detail::RotateOne kRotatePreparedOne[];
)text";

const char* const kOneChoice =
    R"text(
namespace {

// Tables of kernels by degree: the one of the instruction set in use.
#if defined(SH_BATCH_X86)
#define SH_BATCH_TABLE(table) choose_table(baseline::table, avx2::table, avx512::table)
template <class Kernel>
const Kernel* choose_table(const Kernel* baseline, const Kernel* avx2, const Kernel* avx512) noexcept {
  const InstructionSet set = instruction_set();
  return set == InstructionSet::kAvx512 ? avx512 : set == InstructionSet::kAvx2 ? avx2 : baseline;
}
#else
#define SH_BATCH_TABLE(table) baseline::table
#endif

constexpr int kLargestRotation = 10;

[[noreturn, gnu::cold]] void refuse_degree(const char* function, int degree, int largest) {
  throw std::invalid_argument(std::string("sh::batch::") + function + ": degree " + std::to_string(degree) +
                              "; it should be 0 to " + std::to_string(largest));
}

}  // namespace

void product_one(int degree, const float* a, const float* b, float* out) {
  constexpr int kLargest = 6;
  if (degree < 0 || degree > kLargest) refuse_degree("product_one", degree, kLargest);
  SH_BATCH_TABLE(kProductOne)[degree](a, b, out);
}

void rotate_one(int degree, const float* r, const float* c, float* out) {
  if (degree < 0 || degree > kLargestRotation) refuse_degree("rotate_one", degree, kLargestRotation);
  SH_BATCH_TABLE(kRotateOne)[degree](r, c, out);
}

std::size_t rotate_prepared_size(int degree) {
  if (degree < 0 || degree > kLargestRotation) refuse_degree("rotate_prepared_size", degree, kLargestRotation);
  // In columns of 16 from degree 3 to 6: 7 of bands 0 to 3, 2l+1 of each further band; otherwise the matrices.
  const auto bands = static_cast<std::size_t>(degree) + 1;
  if (degree >= 3 && degree <= 6) return 16 * (bands * bands - 9);
  return bands * (2 * bands - 1) * (2 * bands + 1) / 3;
}

void rotate_prepare(int degree, const float* r, float* prepared) {
  if (degree < 0 || degree > kLargestRotation) refuse_degree("rotate_prepare", degree, kLargestRotation);
  SH_BATCH_TABLE(kRotatePrepareOne)[degree](r, prepared);
}

void rotate_prepared_one(int degree, const float* prepared, const float* c, float* out) {
  if (degree < 0 || degree > kLargestRotation) refuse_degree("rotate_prepared_one", degree, kLargestRotation);
  SH_BATCH_TABLE(kRotatePreparedOne)[degree](prepared, c, out);
}
)text";

}  // namespace sh::codegen::print
