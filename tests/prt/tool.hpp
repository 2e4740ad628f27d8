// The tool `prt` as a child process.
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace sh::prt::test {

/// The result of a finished process.
struct Finished {
  int status = 0;  // exit status, or 128 + signal
  std::string out;
  std::string err;
};

using Arguments = std::vector<std::string>;
Arguments joined(Arguments first, const Arguments& more);

/// Runs SHFORGE_BIN_DIR/prt with the arguments; `before` is shell text run first in the same process (limits, cd);
/// `redirect` replaces the capture of standard output when not empty.
Finished run_prt(const Arguments& arguments, const std::string& before = {}, const std::string& redirect = {});

/// Runs the tool and expects exit 0.
Finished succeeded(const Arguments& arguments);

/// The JSON that the tool prints; expects exit 0.
nlohmann::json printed(const Arguments& arguments);

/// The exit code where the machine failed: the same command may succeed later.
inline constexpr int kRetry = 75;

/// Expects exit 2 (or another), one line on standard error that begins with `prt: ` and contains `reason`, and nothing
/// on standard output; `before` as for run_prt.
void expect_refused(const Arguments& arguments, const std::string& reason, const std::string& before = {},
                    int status = 2);

/// Runs the tool and sends SIGINT after `milliseconds`.
Finished interrupt_prt(const Arguments& arguments, int milliseconds);

/// Runs the tool, polls `when` and sends `signal` as soon as it returns true; does nothing if the process ends before.
Finished signal_prt(const Arguments& arguments, int signal, const std::function<bool()>& when);

}  // namespace sh::prt::test
