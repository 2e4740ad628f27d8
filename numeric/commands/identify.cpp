// shcheck identify and rotation-matrix: the convention of a table of values or of rotation matrices, and its mistakes.
#include "numeric/identify/identify.hpp"

#include <fmt/core.h>

#include <memory>

#include "numeric/commands/commands.hpp"
#include "numeric/identify/rotation_check.hpp"
#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string file;
  int count = 0;
  bool normalize = false;
  double tolerance = 0;
  bool all = false;
  bool json = false;
};

// `count` of the rotations that the checks of kernels use, evenly over the list: named turns, tiny and nearly half
// turns, tiny tilts, random ones.
std::string suggested_rotations(int count) {
  const auto all = matrix_inputs();
  const int most = static_cast<int>(all.size());
  require_range("--rotations", count, 2, most);
  std::string text =
      "# rotations, s' = R s; append your matrix to each line, all entries or band after band, row by row\n"
      "r00,r01,r02,r10,r11,r12,r20,r21,r22\n";
  for (int i = 0; i < count; ++i) {
    const auto& input = all[i * (most - 1) / (count - 1)];
    for (const double value : input.values) text += fmt::format("{:.17g},", value);
    text.pop_back();
    text += "  # " + input.name + "\n";
  }
  return text;
}

ExitCode identify_values(const Options& options) {
  const auto table = identify::read_table(options.file);
  const auto result = identify::identify(identify::read_samples(table, options.normalize));
  print(options.json ? format_json(result) : format_text(result, options.all));
  return result.recognized() ? kDone : kDifferent;
}

ExitCode check_matrices(const Options& options) {
  const auto cases = identify::read_rotation_cases(identify::read_table(options.file));
  const auto result = identify::check_rotations(cases, options.tolerance);
  print(options.json ? format_json(result) : format_text(result, options.all));
  return result.passes() ? kDone : kDifferent;
}

// Both commands read FILE, or print `count` inputs to fill in.
struct TableCommand {
  const char* name;
  const char* help;
  const char* columns;
  const char* inputs;  ///< "directions"
  std::string (*suggest)(int count);
  ExitCode (*check)(const Options& options);
};

std::pair<Command, std::shared_ptr<Options>> add_table_command(Command& tool, const TableCommand& row) {
  auto options = std::make_shared<Options>();
  auto command = tool.command(row.name, row.help);
  const auto file = command.option("file", options->file, row.columns);
  const std::string name = fmt::format("--{}", row.inputs);
  auto count = command.option(name, options->count, fmt::format("print so many {} to fill in", row.inputs));
  count.excludes(file);
  command.run([=] {
    if (count.given()) {
      print(row.suggest(options->count));
      return kDone;
    }
    if (!file.given()) throw std::invalid_argument(fmt::format("{}: expected FILE or {} N", row.name, name));
    return row.check(*options);
  });
  return {command, options};
}

void add_flags(Command& command, Options& options) {
  command.option("--all", options.all, "list every reading that fits, not presets alone");
  command.option("--json", options.json, "print JSON");
}

}  // namespace

void add_identify_commands(Command& tool) {
  auto [values, of_values] = add_table_command(tool, {"identify", "name the convention of a table of your own values",
                                                      "CSV: x,y,z,v0,v1,..., a direction a line", "directions",
                                                      identify::suggested_directions, identify_values});
  values.option("--normalize,--normalise", of_values->normalize, "scale directions to length 1");
  add_flags(values, *of_values);
  auto [matrices, of_matrices] = add_table_command(
      tool, {"rotation-matrix", "check your own rotation matrices of spherical harmonics",
             "CSV: r00,...,r22, then the matrix, a rotation a line", "rotations", suggested_rotations, check_matrices});
  matrices.option("--tolerance", of_matrices->tolerance, "largest error allowed [16 (l+1) epsilon]").positive();
  add_flags(matrices, *of_matrices);
}

}  // namespace sh::numeric
