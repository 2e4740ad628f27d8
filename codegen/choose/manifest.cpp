#include "codegen/choose/manifest.hpp"

#include <fmt/format.h>

#include "codegen/print/describe.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen {
namespace {

std::string time(const std::optional<Timing>& timing, double Timing::*which) {
  return timing ? fmt::format("{:.3g}", (*timing).*which) : "-";
}

std::vector<std::string> row(const ManifestEntry& entry) {
  const FinishedKernel& f = entry.finished;
  std::string files;
  for (const std::string& file : entry.files) files += (files.empty() ? "" : " ") + file;
  const auto field = [](const std::string& name, const std::string& value) { return "  " + name + "=" + value; };
  return {f.kernel.name,
          field("recipe", f.kernel.recipe),
          field("mul", std::to_string(f.cost.mul)),
          field("add", std::to_string(f.cost.add + f.cost.neg)),
          field("other", std::to_string(f.cost.div + f.cost.sqrt + f.cost.select)),
          field("chain", std::to_string(f.cost.depth)),
          field("live", std::to_string(f.cost.max_live)),
          field("float_rounding", print::two_digits(f.in_float.rounding.absolute)),
          field("float_total", print::two_digits(f.in_float.total.absolute)),
          field("double_rounding", print::two_digits(f.in_double.rounding.absolute)),
          field("double_total", print::two_digits(f.in_double.total.absolute)),
          field("ns", time(entry.timing, &Timing::call)),
          field("lane_ns", time(entry.timing, &Timing::lane)),
          field("files", files.empty() ? "-" : files)};
}

}  // namespace

std::string print_manifest(const std::vector<ManifestEntry>& entries) {
  std::string text =
      "# Every kernel and every recipe for it, one a line. Written by `shgen write`; licence MIT-0.\n"
      "# mul, add: operations (add holds subtractions and negations); other: divisions, square roots, selections;\n"
      "# chain: the longest one; live: most values held at once; rounding, total: largest absolute error measured, as\n"
      "# explained at the head of each file; ns, lane_ns: tuned time of a float call, and of a lane of a SIMD "
      "register;\n"
      "# files: what is written with this recipe, - when another one was chosen.\n"
      "# families.json: roles, shapes, units and limits of these kernels, for programs.\n";
  std::vector<std::vector<std::string>> rows;
  rows.reserve(entries.size());
  for (const ManifestEntry& entry : entries) rows.push_back(row(entry));
  for (const std::string& line : print::align_columns(rows)) text += line + "\n";
  return text;
}

}  // namespace sh::codegen
