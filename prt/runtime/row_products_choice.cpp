// Chooses the instruction set of prt/runtime/row_products.hpp.
#include <vector>

#include "prt/runtime/row_products.hpp"

namespace sh::prt {

namespace baseline {
void colour_products(const RowProducts& rows, std::size_t count, const float* colour, float* out);
void grey_products(const RowProducts& rows, std::size_t count, float* out);
}  // namespace baseline
#if defined(SH_RELIGHT_X86)
namespace avx2 {
void colour_products(const RowProducts& rows, std::size_t count, const float* colour, float* out);
void grey_products(const RowProducts& rows, std::size_t count, float* out);
}  // namespace avx2
namespace avx512 {
void colour_products(const RowProducts& rows, std::size_t count, const float* colour, float* out);
void grey_products(const RowProducts& rows, std::size_t count, float* out);
}  // namespace avx512
#endif

std::span<const RowProductsOn> row_products_here() {
  static const std::vector<RowProductsOn> kHere = [] {
    std::vector<RowProductsOn> here{{"baseline", baseline::colour_products, baseline::grey_products}};
#if defined(SH_RELIGHT_X86)
    if (__builtin_cpu_supports("avx2")) here.push_back({"avx2", avx2::colour_products, avx2::grey_products});
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
      here.push_back({"avx512", avx512::colour_products, avx512::grey_products});
    }
#endif
    return here;
  }();
  return kHere;
}

void colour_products(const RowProducts& rows, std::size_t count, const float* colour, float* out) {
  row_products_here().back().colour(rows, count, colour, out);
}

void grey_products(const RowProducts& rows, std::size_t count, float* out) {
  row_products_here().back().grey(rows, count, out);
}

}  // namespace sh::prt
