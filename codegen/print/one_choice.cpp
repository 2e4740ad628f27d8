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
)text";

const char* const kOneDeclarations = R"text(extern const detail::ProductOne kProductOne[];
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
)text";

}  // namespace sh::codegen::print
