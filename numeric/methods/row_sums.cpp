// row_sums.hpp for double, compiled once for each instruction set: SH_ROWS_ISA is baseline, avx2 or avx512.
#include "numeric/methods/row_sums.hpp"

namespace sh::numeric::methods::SH_ROWS_ISA {

void add_rows(const RowSums<double>& sums) { add_all_blocks(sums); }

}  // namespace sh::numeric::methods::SH_ROWS_ISA
