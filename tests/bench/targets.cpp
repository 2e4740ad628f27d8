// The table of targets: operations, times and errors of the kernels, each beside its control or limit of the same run.
// Usage: targets_bench [--markdown] [SECTION...], by default all of them. Exit 1 if a target is missed by more than the noise.
#include "tests/bench/harness.hpp"

int main(int argc, char** argv) {
  return sh::bench::run_sections(argc, argv,
                                 {{"operations", sh::bench::operations},
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
                                  {"gaunt", sh::bench::gaunt}});
}
