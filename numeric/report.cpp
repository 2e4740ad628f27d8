// See report.hpp.
#include "numeric/report.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "numeric/kernel_limits.hpp"

namespace sh::numeric {
namespace {

using Json = nlohmann::ordered_json;

template <class... Argument>
std::string print(const char* format, Argument... argument) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, argument...);
  return text.data();
}

std::string bits_text(const KernelResult& result) {
  if (!result.bits) return "-";
  return result.bits->different == 0 ? "same" : std::to_string(result.bits->different) + " differ";
}

std::string table_row(const KernelResult& r) {
  const auto& worst = r.rounding.scaled().worst();
  const std::string time = r.nanoseconds ? print("%.1f", *r.nanoseconds) : "-";
  return print("%-10s %-11s %-6s %4d %4d  %8.2e %5.2f  %8.2e %5.2f  %7s %-9s l=%d m=%d (%.9g, %.9g, %.9g)\n",
               r.kernel.c_str(), r.language.c_str(), r.scalar.c_str(), r.operations.mul, r.operations.add,
               r.rounding.absolute().max(), r.rounding.scaled().max(), r.total.absolute().max(), r.total.scaled().max(),
               time.c_str(), bits_text(r).c_str(), worst.degree, worst.order, worst.input.x, worst.input.y,
               worst.input.z);
}

Json measure_json(const ErrorMeasure& measure) {
  const auto& worst = measure.worst();
  return {{"max", measure.max()},
          {"rms", measure.rms()},
          {"worst",
           {{"degree", worst.degree},
            {"order", worst.order},
            {"direction", {worst.input.x, worst.input.y, worst.input.z}}}}};
}

Json stats_json(const ErrorStats& stats) {
  return {{"absolute", measure_json(stats.absolute())}, {"eps_band_maximum", measure_json(stats.scaled())}};
}

Json result_json(const KernelResult& r) {
  const auto limits = limits_for(r.degree, r.scalar);
  Json json = {{"kernel", r.kernel},
               {"degree", r.degree},
               {"language", r.language},
               {"scalar", r.scalar},
               {"operations", {{"mul", r.operations.mul}, {"add", r.operations.add}}},
               {"rounding", stats_json(r.rounding)},
               {"total", stats_json(r.total)},
               {"limits", {{"rounding_eps_band_maximum", limits.rounding}, {"total_absolute", limits.total}}}};
  if (r.nanoseconds) json["nanoseconds"] = *r.nanoseconds;
  if (r.bits) {
    json["bits"] = {{"compared", r.bits->compared}, {"flushed", r.bits->flushed}, {"different", r.bits->different}};
  }
  return json;
}

}  // namespace

std::string format_table(const std::vector<KernelResult>& results) {
  std::string text = print("%-10s %-11s %-6s %4s %4s  %-14s  %-14s  %7s %-9s %s\n", "", "", "", "", "", "max rounding",
                           "max total", "", "", "");
  text += print("%-10s %-11s %-6s %4s %4s  %8s %5s  %8s %5s  %7s %-9s %s\n", "kernel", "language", "scalar", "mul",
                "add", "absolute", "eps", "absolute", "eps", "ns/call", "bits", "worst input (rounding)");
  for (const auto& result : results) text += table_row(result);
  return text +
         "eps: machine epsilon x band maximum sqrt((2l+1)/4pi). rounding: against the kernel's own polynomial at " +
         "the rounded input;\ntotal: against the exact function at that input scaled to length 1. bits: GLSL against " +
         "C++ float.\n";
}

std::string format_json(const std::vector<KernelResult>& results, const std::vector<std::string>& failures) {
  Json json = {
      {"convention", "orthonormal real spherical harmonics, no Condon-Shortley phase, index l(l+1)+m, z polar"},
      {"directions", checked_direction_count()},
      {"kernels", Json::array()},
      {"failures", failures}};
  for (const auto& result : results) json["kernels"].push_back(result_json(result));
  return json.dump(2) + "\n";
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path temporary = file.string() + ".part";
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failed;
  if (stream) std::filesystem::rename(temporary, file, failed);
  if (stream && !failed) return;
  const std::string reason = failed ? failed.message() : std::strerror(errno);
  std::filesystem::remove(temporary, failed);
  throw std::runtime_error(file.string() + ": cannot be written: " + reason);
}

}  // namespace sh::numeric
