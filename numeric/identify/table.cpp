// See table.hpp.
#include "numeric/identify/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "numeric/output/printable.hpp"
#include "numeric/output/read_file.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<double>;

// Takes the number at the front of `text`. strtod decides what a value beyond the range of a double becomes.
std::optional<double> take_number(std::string_view& text) {
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  const std::string_view number(digits.data(), end);
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(number).c_str(), nullptr);
  text = digits.substr(number.size());
  return value;
}

// a, bi, a+bi or a-bj, in brackets or not.
std::optional<Complex> parse_cell(std::string_view text) {
  const auto is_unit = [](std::string_view rest) { return rest == "i" || rest == "j"; };
  if (text.size() > 2 && text.front() == '(' && text.back() == ')') text = text.substr(1, text.size() - 2);
  const auto first = take_number(text);
  if (!first) return std::nullopt;
  if (text.empty()) return Complex(*first, 0);
  if (is_unit(text)) return Complex(0, *first);
  if (text[0] != '+' && text[0] != '-') return std::nullopt;
  const auto second = take_number(text);
  if (!second || !is_unit(text)) return std::nullopt;
  return Complex(*first, *second);
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const auto comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

bool is_header(const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(), [](std::string_view cell) { return parse_cell(cell).has_value(); });
}

Row parse_row(const std::string& file, int line, const std::vector<std::string_view>& cells) {
  Row row{line, {}};
  for (const std::string_view cell : cells) {
    const auto value = parse_cell(cell);
    if (!value || !std::isfinite(value->real()) || !std::isfinite(value->imag())) {
      refuse(file, line,
             "column " + std::to_string(row.cells.size() + 1) + ": expected a " + (value ? "finite " : "") +
                 "number such as -0.5 or 0.5+0.25i, got '" + output::printable(cell.substr(0, 40)) + "'");
    }
    row.cells.push_back(*value);
  }
  return row;
}

void require_width(const Table& table, const Row& row) {
  const Row& first = table.rows.front();
  if (row.cells.size() == first.cells.size()) return;
  refuse(table.file, row.line,
         "expected " + std::to_string(first.cells.size()) + " columns as on line " + std::to_string(first.line) +
             ", got " + std::to_string(row.cells.size()));
}

}  // namespace

void refuse(const std::string& file, int line, const std::string& message) {
  throw std::invalid_argument(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message);
}

Table parse_table(const std::string& file, std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Table table{file, {}};
  bool header_seen = false;
  for (int line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view content = trimmed(text.substr(0, std::min(end, text.find('#'))));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.empty()) continue;
    const auto cells = split(content);
    if (table.rows.empty() && !header_seen && is_header(cells)) {
      header_seen = true;
      continue;
    }
    table.rows.push_back(parse_row(file, line, cells));
    require_width(table, table.rows.back());
  }
  if (table.rows.empty()) refuse(file, 0, "expected a row of numbers, got none");
  return table;
}

Table read_table(const std::string& file) { return parse_table(file, output::read_file(file)); }

}  // namespace sh::numeric::identify
