// shcheck rotation: reference values of D_l of a rotation, one entry or all.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/commands/commands.hpp"
#include "numeric/commands/split_numbers.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/reference/correct_digits.hpp"
#include "numeric/reference/rotation_reference.hpp"

namespace sh::numeric {
namespace {

constexpr int kMaxWholeDegree = 100;

struct Options {
  int degree = 0;
  std::string matrix, quaternion, euler, axis, angle;
  int digits = 0;
  std::optional<int> row, column;
  std::string format = "text";
};

GivenRotation given_rotation(const Options& options) {
  const auto& o = options;
  const auto given = {!o.matrix.empty(), !o.quaternion.empty(), !o.euler.empty(), !o.axis.empty()};
  if (std::count(given.begin(), given.end(), true) != 1) {
    throw std::invalid_argument("give one of --matrix, --quaternion, --euler, and --axis with --angle");
  }
  if (o.axis.empty() != o.angle.empty()) throw std::invalid_argument("--axis and --angle belong together");
  if (!o.matrix.empty()) {
    return rotation_from_matrix("--matrix", split_numbers<9>("--matrix", o.matrix, "nine numbers, row by row,"));
  }
  if (!o.quaternion.empty()) {
    return rotation_from_quaternion("--quaternion",
                                    split_numbers<4>("--quaternion", o.quaternion, "four numbers w,x,y,z"));
  }
  if (!o.euler.empty()) {
    return rotation_from_euler("--euler", split_numbers<3>("--euler", o.euler, "three angles a,b,c"));
  }
  return rotation_from_axis("--axis", split_numbers<3>("--axis", o.axis, "three numbers x,y,z"), "--angle", o.angle);
}

void say_distance(const GivenRotation& rotation) {
  if (rotation.distance == 0) return;
  say("--matrix is " + output::formatted("%.2e", rotation.distance) + " from the nearest rotation, which is taken");
}

// A row of the matrix a line, or the rows as JSON; numbers are texts there, so that no reader rounds them.
std::string formatted(const std::vector<std::string>& entries, const Options& options) {
  const auto size = 2 * static_cast<std::size_t>(options.degree) + 1;
  std::string text;
  auto rows = nlohmann::json::array();
  for (std::size_t row = 0; row < size; ++row) {
    auto cells = nlohmann::json::array();
    for (std::size_t column = 0; column < size; ++column) {
      const auto& entry = entries[row * size + column];
      cells.push_back(entry);
      text += entry + (column + 1 == size ? "\n" : (options.format == "csv" ? "," : " "));
    }
    rows.push_back(cells);
  }
  if (options.format != "json") return text;
  const nlohmann::ordered_json document{
      {"degree", options.degree}, {"digits", options.digits}, {"rows and columns", "orders -l .. l"}, {"matrix", rows}};
  return document.dump(1) + "\n";
}

void run(const Options& options) {
  if (options.row.has_value() != options.column.has_value()) {
    throw std::invalid_argument("--row and --column belong together");
  }
  if (!options.row && options.degree > kMaxWholeDegree) {
    throw std::invalid_argument("degree is " + std::to_string(options.degree) + ", the whole matrix is printed up to " +
                                std::to_string(kMaxWholeDegree) + ": give --row and --column");
  }
  require_range("digits", options.digits, 1, kMaxReferenceDigits);
  const GivenRotation rotation = given_rotation(options);
  RotationReference reference(options.degree, rotation);
  if (options.row) {
    const std::string entry = reference.entry(*options.row, *options.column, options.digits);
    say_distance(rotation);
    print(entry + "\n");
    return;
  }
  output::stop_on_interrupt();
  const auto size = 2 * static_cast<std::size_t>(options.degree) + 1;
  std::optional<output::Progress> progress;
  if (options.degree > 20) progress.emplace("entries", size * size);
  const auto entries = reference.all(options.digits, [&] {
    output::check_interrupt();
    if (progress) progress->advance();
  });
  if (progress) progress->finish();
  say_distance(rotation);
  print(formatted(entries, options));
}

}  // namespace

void add_rotation_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("rotation",
                                      "print D_l of a rotation of the real basis: coefficients go to D c, rows and "
                                      "columns are orders -l to l");
  command->add_option("--degree", options->degree, "l, 0 to 100; 0 to 1000 for one entry")->required();
  command->add_option("--matrix", options->matrix, "r00,r01,...,r22, row by row: the nearest rotation is taken");
  command->add_option("--quaternion", options->quaternion, "w,x,y,z, of any length but zero");
  command->add_option("--euler", options->euler, "a,b,c in radians: Rz(a) Ry(b) Rz(c)");
  command->add_option("--axis", options->axis, "x,y,z, of any length but zero; with --angle");
  command->add_option("--angle", options->angle, "radians about the axis");
  command->add_option("--digits", options->digits, "significant decimals, 1 to 10000")->required();
  command->add_option("--row", options->row, "one entry: its row, an order -l to l");
  command->add_option("--column", options->column, "one entry: its column, an order -l to l");
  command->add_option("--format", options->format, "of the whole matrix: text, csv or json")
      ->check(CLI::IsMember({"text", "csv", "json"}));
  command->callback([options] { run(*options); });
}

}  // namespace sh::numeric
