// Shares independent work among processes. Exact numbers of CLN and GiNaC count their users without locks, so that
// threads cannot share them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace sh::codegen {

/// The cores that this process may use.
int core_count();

/// Calls work(i) for every i below `count`, the first ones first, each in one of `processes` copies of this process, and
/// take(i, result) here as results come. Throws std::runtime_error with the text of the first exception of `work`, or
/// if a copy dies; no copy outlives the call. With one process, `work` is called here.
void in_processes(std::size_t count, int processes, const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& take);

}  // namespace sh::codegen
