// The table of a study: a row for each representation, as comma-separated values and as Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "prt/study/study.hpp"

namespace sh::prt {

namespace {

using Cells = std::vector<std::string>;

const Cells kColumns = {
    "scene", "transfer type",         "transfer shape",       "directions",     "vertices", "preprocessing seconds",
    "rate",  "rate with light fixed", "rate with view fixed", "bytes a vertex", "error",    "error against paths"};

std::string number(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "";
  return *value < 1000.0 ? fmt::format("{:.3g}", *value) : fmt::format("{:.0f}", *value);
}

std::string rate(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.{}f}", 1.0 / *seconds, *seconds > 0.1 ? 1 : 0) : "";
}

Cells cells_of(const Study& study, const TableRow& row) {
  return {study.scene,
          row.kind,
          row.shape,
          row.directions == 0 ? "" : fmt::format("{}", row.directions),
          fmt::format("{}", study.vertices),
          number(row.free.bake_seconds),
          rate(row.free.seconds),
          rate(row.seconds_fixed_light),
          rate(row.seconds_fixed_view),
          number(row.free.bytes_a_vertex),
          number(row.free.error.rms),
          number(row.free.path_error)};
}

std::vector<Cells> rows_of(const Study& study) {
  std::vector<Cells> rows;
  for (const StudyPart& part : study.parts) {
    for (const TableRow& row : part.table) rows.push_back(cells_of(study, row));
  }
  return rows;
}

// [RFC4180]: a text with a comma, a quote or a line break stands in quotes, and its quotes are doubled.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

std::string csv_line(const Cells& cells) {
  Cells texts;
  for (const std::string& cell : cells) texts.push_back(csv_text(cell));
  return fmt::format("{}\n", fmt::join(texts, ","));
}

// A bar would end a cell, and a line break the table.
std::string markdown_line(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? "\\|" : c == '\n' || c == '\r' ? " " : std::string(1, c);
    line += " |";
  }
  return line + '\n';
}

}  // namespace

std::string table_csv(const Study& study) {
  std::string text;
  for (const Cells& row : rows_of(study)) text += csv_line(row);
  return text.empty() ? text : csv_line(kColumns) + text;
}

std::string table_markdown(const Study& study) {
  std::string text;
  for (const Cells& row : rows_of(study)) text += markdown_line(row);
  return text.empty() ? text : markdown_line(kColumns) + markdown_line(Cells(kColumns.size(), "---")) + text;
}

}  // namespace sh::prt
