// `shgen list FAMILY... --table` prints the lines of MANIFEST as a table in Markdown, which the READMEs show.
#include "codegen/commands/table.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace sh::codegen {
namespace {

// "basis_l4 recipe=parity mul=39 ..." by name; "kernel" is the name of the file, which tells variants apart.
std::map<std::string, std::string> fields_of(const std::string& line) {
  std::map<std::string, std::string> fields;
  std::istringstream words(line);
  std::string word;
  words >> fields["kernel"];
  while (words >> word) {
    const std::size_t split = word.find('=');
    if (split != std::string::npos) fields[word.substr(0, split)] = word.substr(split + 1);
  }
  const std::string& files = fields["files"];
  const std::size_t begin = files.find('/') + 1;
  if (files != "-") fields["kernel"] = files.substr(begin, files.rfind('.') - begin);
  return fields;
}

std::string at_most(const std::string& bound_and_seen) {
  const std::size_t split = bound_and_seen.find('/');
  const std::string bound = bound_and_seen.substr(0, split);
  return (bound == "-" ? "not proved" : bound) + " / " + bound_and_seen.substr(split + 1);
}

std::string row(std::map<std::string, std::string> f) {
  return "| `" + f["kernel"] + "` | " + f["mul"] + " + " + f["add"] + " | " + at_most(f["float_eps"]) + " | " +
         f["float_rounding"] + " | " + f["float_total"] + " | " + at_most(f["double_eps"]) + " | " +
         f["double_rounding"] + " | " + f["double_total"] + " |\n";
}

}  // namespace

std::string manifest_table(const std::vector<std::string>& lines, const std::vector<int>& degrees) {
  std::string text =
      "| kernel | mul + add | float, eps: at most / seen | rounding seen | total seen | double, eps: at most / seen | "
      "rounding seen | total seen |\n|---|---|---|---|---|---|---|---|\n";
  for (const std::string& line : lines) {
    const auto fields = fields_of(line);
    if (fields.at("files") == "-") continue;
    const std::string& name = fields.at("kernel");
    const int degree = std::stoi(name.substr(name.rfind("_l") + 2));
    if (!degrees.empty() && std::find(degrees.begin(), degrees.end(), degree) == degrees.end()) continue;
    text += row(fields);
  }
  return text;
}

}  // namespace sh::codegen
