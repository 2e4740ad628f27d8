// shcheck: the oracle at the command line.
//
//   shcheck kernels [--family NAME] [--json FILE] [--generated DIR]    every generated kernel against the oracle
//   shcheck worst [--family NAME] [--degree N] [--evaluations N]       the input at which each errs most, by search
//   shcheck worst --exhaustive                                         the same among all floats, for one variable
//   shcheck eval --degree L --order M --direction x,y,z --digits D [--gradient]    a reference value
//   shcheck legendre --degree L --order M (--z Z | --theta T) --digits D
//   shcheck rotation --degree L (--matrix R | --quaternion Q | --euler A | --axis V --angle A) --digits D
//                    [--row M --column N] [--format text|csv|json]     D_l, or an entry
//   shcheck gaunt --degrees a,b,c --orders m,n,p --digits D [--complex]
//   shcheck cap --degree L (--angle A | --one-minus-cos V) --digits D
//   shcheck identify FILE | --directions N                             the convention of a table of values
//   shcheck rotation-matrix FILE | --rotations N                       the same of rotation matrices, and their errors
//   shcheck plot lobes|map ... -o FILE.svg|.png                        a picture of a function on the sphere
//   shcheck report --out DIR [--quick] [--task TASK]                  error against run time, a page and JSON
//   shcheck advise --task TASK --degree L --error E ...                which method to take
//
// Results on standard output, progress and messages on standard error. Exit: 0 done, 1 a check found a difference, 2
// bad input, 130 interrupted.
#include "numeric/commands/commands.hpp"

namespace sh::numeric {
namespace {

void add_commands(Command& tool) {
  add_kernel_commands(tool);
  add_reference_commands(tool);
  add_identify_commands(tool);
  add_plot_command(tool);
  add_report_commands(tool);
}

}  // namespace
}  // namespace sh::numeric

int main(int argc, char** argv) {
  return sh::numeric::run_tool(argc, argv, "Checks spherical-harmonics code against a multiprecision oracle",
                               sh::numeric::add_commands);
}
