#include "codegen/manifest.hpp"

#include "codegen/print/describe.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen {
namespace {

std::vector<std::string> row(const ManifestEntry& entry) {
  const FinishedKernel& f = entry.finished;
  std::string files;
  for (const std::string& file : entry.files) files += (files.empty() ? "" : " ") + file;
  const auto field = [](const std::string& name, const std::string& value) { return "  " + name + "=" + value; };
  return {f.kernel.name,
          field("recipe", f.kernel.recipe),
          field("mul", std::to_string(f.cost.mul)),
          field("add", std::to_string(f.cost.add)),
          field("chain", std::to_string(f.cost.depth)),
          field("live", std::to_string(f.cost.max_live)),
          field("float_rounding", print::two_digits(f.in_float.rounding.absolute)),
          field("float_total", print::two_digits(f.in_float.total.absolute)),
          field("double_rounding", print::two_digits(f.in_double.rounding.absolute)),
          field("double_total", print::two_digits(f.in_double.total.absolute)),
          field("files", files)};
}

}  // namespace

std::string print_manifest(const std::vector<ManifestEntry>& entries) {
  std::string text =
      "# Every generated kernel, one a line. Written by `shgen write`; licence MIT-0.\n"
      "# mul, add: operations; chain: the longest one; live: most values held at once;\n"
      "# rounding, total: largest absolute error measured, as explained at the head of each file.\n";
  std::vector<std::vector<std::string>> rows;
  rows.reserve(entries.size());
  for (const ManifestEntry& entry : entries) rows.push_back(row(entry));
  for (const std::string& line : print::align_columns(rows)) text += line + "\n";
  return text;
}

}  // namespace sh::codegen
