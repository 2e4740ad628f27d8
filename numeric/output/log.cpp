#include "numeric/output/log.hpp"

#include <fmt/core.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "numeric/output/printable.hpp"

namespace sh::output {
namespace {

std::atomic<LogFormat> format_now{LogFormat::kText};

// A line of JSON; names of files may be no UTF-8.
std::string line_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void set_log_format(LogFormat format) { format_now = format; }
LogFormat log_format() { return format_now; }

void log_line(std::string_view kind, std::string_view prefix, std::string_view text) {
  if (log_format() == LogFormat::kNone) return;
  const std::string line =
      log_format() == LogFormat::kJson ? line_of({{kind, text}}) : fmt::format("{}{}\n", prefix, printable(text));
  std::fputs(line.c_str(), stderr);
}

void log_progress(std::string_view what, std::size_t done, std::size_t total, double seconds) {
  std::fputs(line_of({{"progress", what}, {"done", done}, {"of", total}, {"seconds", std::round(seconds * 1e3) / 1e3}})
                 .c_str(),
             stderr);
}

}  // namespace sh::output
