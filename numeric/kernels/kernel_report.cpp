// The results of kernel_check.hpp as tables for people and as JSON for programs.
#include <cmath>
#include <nlohmann/json.hpp>

#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric {
namespace {

using Json = nlohmann::ordered_json;

// "same", "regrouped" or the number of differences; the error where bits need not agree, "-" where there is nothing to
// compare.
std::string bits_text(const KernelResult& result) {
  if (!result.bits) return "-";
  if (result.bits->different == 0) return result.bits->regrouped == 0 ? "same" : "regrouped";
  if (!bits_must_agree(result)) return output::formatted("%.2f", result.rounding.scaled().max());
  return std::to_string(result.bits->different) + " differ";
}

// The place of the largest error, with its numbers where they are few.
std::string worst_text(const WorstCase& worst) {
  constexpr std::size_t kMostPrinted = 4;
  std::string text = worst.output + ", " + worst.input;
  for (std::size_t i = 0; i < worst.values.size() && worst.values.size() <= kMostPrinted; ++i) {
    text += output::formatted("%s%.9g", i == 0 ? " (" : ", ", worst.values[i]);
  }
  return text + (worst.values.size() <= kMostPrinted ? ")" : "");
}

std::string details_row(const KernelResult& r) {
  const std::string time = r.nanoseconds ? output::formatted("%.1f", *r.nanoseconds) : "-";
  return output::formatted("%-24s %-11s %-6s %5d %5d %5d  %8.2e %5.2f  %8.2e %5.2f  %8s %-9s ", r.kernel.c_str(),
                           r.language.c_str(), r.scalar.c_str(), r.operations.mul, r.operations.add, r.operations.other,
                           r.rounding.absolute().max(), r.rounding.scaled().max(), r.total.absolute().max(),
                           r.total.scaled().max(), time.c_str(), bits_text(r).c_str()) +
         worst_text(r.worst_rounding) + "\n";
}

// The cells of the summary that one result fills.
struct Cells {
  std::string float_errors = "-", double_errors = "-", glsl = "-", glsl_es = "-", float_time = "-", double_time = "-";

  void add(const KernelResult& r) {
    if (r.language == "glsl 450") glsl = bits_text(r);
    if (r.language == "glsl es 300") glsl_es = bits_text(r);
    if (r.language != "c++") return;
    auto& errors = r.scalar == "float" ? float_errors : double_errors;
    errors = output::formatted("%5.2f %5.2f %8.1e", r.rounding.scaled().max(), r.total.scaled().max(),
                               r.total.absolute().max());
    (r.scalar == "float" ? float_time : double_time) = output::formatted("%.1f", r.nanoseconds.value_or(0));
  }
};

Json measure_json(const ErrorMeasure& measure) { return {{"max", measure.max()}, {"rms", measure.rms()}}; }

Json stats_json(const ErrorStats& stats, const WorstCase& worst) {
  constexpr std::size_t kMostWritten = 16;
  Json json = {{"absolute", measure_json(stats.absolute())},
               {"eps", measure_json(stats.scaled())},
               {"worst", {{"input", worst.input}, {"output", worst.output}}}};
  if (worst.values.size() <= kMostWritten) json["worst"]["values"] = worst.values;
  return json;
}

Json result_json(const KernelResult& r) {
  Json json = {{"kernel", r.kernel},
               {"family", r.family},
               {"degree", r.degree},
               {"language", r.language},
               {"scalar", r.scalar},
               {"inputs", r.inputs},
               {"operations", {{"mul", r.operations.mul}, {"add", r.operations.add}, {"other", r.operations.other}}},
               {"unit", r.unit},
               {"rounding", stats_json(r.rounding, r.worst_rounding)},
               {"total", stats_json(r.total, r.worst_total)}};
  if (const auto limits = limits_for(r.family, r.degree, r.scalar)) {
    json["limits"] = {{"rounding_eps", limits->rounding}, {"total_eps", limits->total}};
    if (std::isfinite(limits->total_absolute)) json["limits"]["total_absolute"] = limits->total_absolute;
  }
  if (r.nanoseconds) json["nanoseconds"] = *r.nanoseconds;
  if (r.bits) {
    json["bits"] = {{"compared", r.bits->compared},
                    {"flushed", r.bits->flushed},
                    {"regrouped", r.bits->regrouped},
                    {"different", r.bits->different},
                    {"must_agree", bits_must_agree(r)}};
  }
  return json;
}

}  // namespace

std::string format_summary(const std::vector<KernelResult>& results) {
  std::string text = output::formatted("%-24s %17s  %-21s  %-21s  %-17s  %-15s  %s\n", "", "operations", "float",
                                       "double", "glsl", "ns a call", "worst input, float");
  text += output::formatted("%-24s %5s %5s %5s  %5s %5s %8s   %5s %5s %8s   %-8s %-8s  %7s %7s\n", "kernel", "mul",
                            "add", "other", "round", "total", "absolute", "round", "total", "absolute", "450", "es 300",
                            "float", "double");
  for (std::size_t i = 0; i < results.size();) {
    const auto& first = results[i];
    Cells cells;
    for (; i < results.size() && results[i].kernel == first.kernel; ++i) cells.add(results[i]);
    text += output::formatted("%-24s %5d %5d %5d  %21s  %21s  %-8s %-8s  %7s %7s  ", first.kernel.c_str(),
                              first.operations.mul, first.operations.add, first.operations.other,
                              cells.float_errors.c_str(), cells.double_errors.c_str(), cells.glsl.c_str(),
                              cells.glsl_es.c_str(), cells.float_time.c_str(), cells.double_time.c_str()) +
            worst_text(first.worst_rounding) + "\n";
  }
  return text +
         "round, total: largest rounding and total error in machine epsilon x the family's unit; absolute: largest " +
         "total error.\nrounding: against the kernel's own formula at the rounded input; total: against the exact " +
         "function at the nearest point of its domain.\nglsl: 'same' bits as C++ float; 'regrouped': the same once " +
         "the compiler may not regroup; a number: the rounding error\n(bits may differ with a division, root or " +
         "selection).\n";
}

std::string format_details(const std::vector<KernelResult>& results) {
  std::string text =
      output::formatted("%-24s %-11s %-6s %17s  %-14s  %-14s\n", "", "", "", "operations", "max rounding", "max total");
  text += output::formatted("%-24s %-11s %-6s %5s %5s %5s  %8s %5s  %8s %5s  %8s %-9s %s\n", "kernel", "language",
                            "scalar", "mul", "add", "other", "absolute", "eps", "absolute", "eps", "ns/call", "bits",
                            "worst input (rounding)");
  for (const auto& result : results) text += details_row(result);
  if (!results.empty()) text += "eps: machine epsilon x " + results.front().unit + ".\n";
  return text;
}

std::string format_json(const std::vector<KernelResult>& results, const std::vector<std::string>& failures) {
  Json json = {
      {"convention", "orthonormal real spherical harmonics, no Condon-Shortley phase, index l(l+1)+m, z polar"},
      {"kernels", Json::array()},
      {"failures", failures}};
  for (const auto& result : results) json["kernels"].push_back(result_json(result));
  return json.dump(2) + "\n";
}

}  // namespace sh::numeric
