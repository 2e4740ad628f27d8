// The table of targets: operations, times and errors of the kernels, each beside its control or limit of the same run.
// Usage: targets_bench [SECTION...], by default all of them. Exit 1 if a target is missed by more than the noise.
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/harness.hpp"

int main(int argc, char** argv) {
  using sh::bench::Table;
  const std::vector<std::pair<std::string, void (*)(Table&)>> sections{{"operations", sh::bench::operations},
                                                                       {"basis", sh::bench::basis},
                                                                       {"plain", sh::bench::plain},
                                                                       {"rotation", sh::bench::rotation},
                                                                       {"high_rotation", sh::bench::high_rotation},
                                                                       {"product", sh::bench::product},
                                                                       {"transfer", sh::bench::transfer},
                                                                       {"evaluate", sh::bench::evaluate},
                                                                       {"project", sh::bench::project},
                                                                       {"irradiance", sh::bench::irradiance},
                                                                       {"legendre", sh::bench::legendre},
                                                                       {"build", sh::bench::build},
                                                                       {"gaunt", sh::bench::gaunt}};
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  try {
    Table table;
    for (const auto& [name, run] : sections) {
      bool chosen = wanted.empty();
      for (const std::string& w : wanted) chosen = chosen || w == name;
      if (chosen) run(table);
    }
    return table.summary() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "targets_bench: %s\n", error.what());
    return 2;
  }
}
