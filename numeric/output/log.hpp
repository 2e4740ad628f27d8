// What a tool says on standard error while it works: lines for people, or one JSON object a line for programs.
#pragma once
#include <cstddef>
#include <string_view>

namespace sh::output {

/// kNone: nothing, of a process for which another one speaks.
enum class LogFormat { kText, kJson, kNone };

/// For the whole process; text unless it is called.
void set_log_format(LogFormat format);
LogFormat log_format();

/// One line: `prefix` and `text`, or {"kind": "text"}. Control characters are escaped.
void log_line(std::string_view kind, std::string_view prefix, std::string_view text);

/// {"progress": what, "done": done, "of": total, "seconds": since the start}; only in JSON.
void log_progress(std::string_view what, std::size_t done, std::size_t total, double seconds);

}  // namespace sh::output
