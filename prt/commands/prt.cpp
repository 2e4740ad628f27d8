// The tool `prt`: bakes, relights and renders. Exit: 0 done, 1 a check found a difference, 2 bad input, 75 the machine
// failed (a full disk, no memory, a file in use): try again, 130 interrupted.
#include "prt/commands/commands.hpp"

int main(int argc, char** argv) { return sh::prt::run_tool(argc, argv); }
