// Tables of the READMEs that commands print: "<!-- shgen list basis --table -->" stands above the output of that command.
#pragma once
#include <fstream>
#include <string>
#include <vector>

namespace sh::test {

/// A page as lines of text, and tables with the commands that print them.
struct PagePart {
  std::string command;  // empty: text
  std::string text;     // lines; of a table those that begin with |
};

inline std::vector<PagePart> parts_of_page(const std::string& path) {
  const std::string begin = "<!-- ";
  const std::string end = " -->";
  std::vector<PagePart> parts(1);
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const bool is_of_table = line.starts_with('|');
    if (!parts.back().command.empty() && !is_of_table) parts.emplace_back();
    parts.back().text += line + "\n";
    if (!line.starts_with(begin) || !line.ends_with(end)) continue;
    parts.push_back({line.substr(begin.size(), line.size() - begin.size() - end.size()), {}});
  }
  return parts;
}

}  // namespace sh::test
