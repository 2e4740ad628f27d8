// shcheck rotation: reference values of D_l of a rotation, one entry or all.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "numeric/commands/commands.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/reference/decimal.hpp"
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

GivenRotation given_rotation(const Options& o) {
  const auto given = {!o.matrix.empty(), !o.quaternion.empty(), !o.euler.empty(), !o.axis.empty()};
  const auto count = std::count(given.begin(), given.end(), true);
  if (count != 1) {
    throw std::invalid_argument(
        fmt::format("expected one of --matrix, --quaternion, --euler, and --axis with --angle, got {}", count));
  }
  if (o.axis.empty() != o.angle.empty()) throw std::invalid_argument("expected --axis and --angle together, got one");
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

// Every entry of the matrix, row-major; a bar shows the progress of a large one.
std::vector<std::string> all_entries(RotationReference& reference, const Options& options) {
  output::stop_on_interrupt();
  const int size = 2 * options.degree + 1;
  std::optional<output::Progress> progress;
  if (options.degree > 20) progress.emplace("entries", size * size);
  auto entries = reference.all(options.digits, [&] {
    output::check_interrupt();
    if (progress) progress->advance();
  });
  if (progress) progress->finish();
  return entries;
}

// A line for each row, or the rows as JSON; numbers are texts there, so that no reader rounds them.
std::string formatted(const std::vector<std::string>& entries, const Options& options) {
  const int size = 2 * options.degree + 1;
  std::string text;
  auto rows = nlohmann::json::array();
  for (auto row = entries.begin(); row != entries.end(); row += size) {
    const std::vector<std::string> cells(row, row + size);
    text += fmt::format("{}\n", fmt::join(cells, options.format == "csv" ? "," : " "));
    rows.push_back(cells);
  }
  if (options.format != "json") return text;
  const nlohmann::ordered_json document{
      {"degree", options.degree}, {"digits", options.digits}, {"rows and columns", "orders -l .. l"}, {"matrix", rows}};
  return document.dump(1) + "\n";
}

ExitCode run(const Options& options) {
  if (options.row.has_value() != options.column.has_value()) {
    throw std::invalid_argument("expected --row and --column together, got one");
  }
  if (!options.row && options.degree > kMaxWholeDegree) {
    throw std::invalid_argument(
        fmt::format("degree: expected 0 to {} for the whole matrix, got {}: --row and --column print one entry",
                    kMaxWholeDegree, options.degree));
  }
  require_range("digits", options.digits, 1, kMaxReferenceDigits);
  const GivenRotation rotation = given_rotation(options);
  RotationReference reference(options.degree, rotation);
  const std::string text = options.row ? reference.entry(*options.row, *options.column, options.digits) + "\n"
                                       : formatted(all_entries(reference, options), options);
  if (rotation.distance != 0) {
    say(fmt::format("--matrix is {:.2e} from the nearest rotation, which is taken", rotation.distance));
  }
  print(text);
  return kDone;
}

}  // namespace

void add_rotation_command(Command& tool) {
  const auto options = std::make_shared<Options>();
  auto command = tool.command("rotation",
                              "print D_l of a rotation of the real basis: coefficients go to D c, rows and columns are "
                              "orders -l to l");
  command.option("--degree", options->degree, "l, 0 to 100; 0 to 1000 for one entry").required();
  command.option("--matrix", options->matrix, "r00,r01,...,r22, row by row: the nearest rotation is taken");
  command.option("--quaternion", options->quaternion, "w,x,y,z, of any length but zero");
  command.option("--euler", options->euler, "a,b,c in radians: Rz(a) Ry(b) Rz(c)");
  command.option("--axis", options->axis, "x,y,z, of any length but zero; with --angle");
  command.option("--angle", options->angle, "radians about the axis");
  command.option("--digits", options->digits, "significant decimals, 1 to 10000").required();
  command.option("--row", options->row, "one entry: its row, an order -l to l");
  command.option("--column", options->column, "one entry: its column, an order -l to l");
  command.option("--format", options->format, "of the whole matrix: text, csv or json").one_of({"text", "csv", "json"});
  command.run([options] { return run(*options); });
}

}  // namespace sh::numeric
