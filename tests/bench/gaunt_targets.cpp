// Gaunt coefficients of the oracle: exact ones against 10 ms at degree 100, and in double.
#include <array>
#include <string>

#include "numeric/oracle/gaunt.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {

void gaunt(Table& table) {
  table.section("Gaunt coefficients of the oracle", "orders (l/2, -l/4, -l/4)");
  for (const int l : {100, 1000}) {
    const numeric::Triple degrees{l, l, l};
    const numeric::Triple orders{l / 2, -l / 4, -l / 4};
    const std::vector<double> t = least_times(
        {[&] { keep(numeric::gaunt_exact(degrees, orders)); }, [&] { keep(numeric::gaunt<double>(degrees, orders)); }});
    const std::string what = "degree " + std::to_string(l);
    table.figure("exact, " + what, "ms", t[0] * 1e3, l == 100 ? 10 : 100);
    table.remark("double, " + what + ": " + scientific(t[1] * 1e3) + " ms");
  }
}

}  // namespace sh::bench
