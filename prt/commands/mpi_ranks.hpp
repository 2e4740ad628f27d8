// The processes that `mpirun` starts together. Without SHFORGE_MPI there is one.
#pragma once
#include <functional>

#include "prt/bake/ranks.hpp"

namespace sh::prt {

/// Calls run(ranks) in each process that mpirun started, or in this one alone. The first process speaks, the others are
/// silent. An error of any of them is one line, and ends all of them. Throws std::runtime_error in a process of mpirun
/// where the tool was built without MPI.
void run_as_ranks(const std::function<void(const Ranks& ranks)>& run);

}  // namespace sh::prt
