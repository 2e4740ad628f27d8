// Chooses the instruction set of row_sums.hpp for double.
#include "numeric/methods/row_sums.hpp"

namespace sh::numeric::methods {

using AddRows = void (*)(const RowSums<double>&);

#if defined(SH_ROWS_X86)
namespace avx2 {
void add_rows(const RowSums<double>& sums);
}
namespace avx512 {
void add_rows(const RowSums<double>& sums);
}
#endif

namespace {

AddRows widest() {
#if defined(SH_ROWS_X86)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return avx512::add_rows;
  }
  if (__builtin_cpu_supports("avx2")) return avx2::add_rows;
#endif
  return baseline::add_rows;
}

}  // namespace

template <>
void add_rows(const RowSums<double>& sums) {
  static const AddRows kChosen = widest();
  kChosen(sums);
}

}  // namespace sh::numeric::methods
