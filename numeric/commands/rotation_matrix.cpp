// shcheck rotation-matrix: which convention someone's rotation matrices follow, and how wrong they are, and where.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/identify/rotation_check.hpp"
#include "numeric/kernels/inputs.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string file;
  int rotations = 0;
  double tolerance = 0;
  bool all = false;
  bool json = false;
};

// `count` of the rotations that kernels are tried at, evenly over the list: named turns, tiny and nearly half turns,
// tiny tilts, random ones.
std::string suggested_rotations(int count) {
  const auto all = matrix_inputs();
  const int most = static_cast<int>(all.size());
  if (count < 2 || count > most) {
    throw std::invalid_argument("--rotations: " + std::to_string(count) + "; it should be 2 to " +
                                std::to_string(most));
  }
  std::string text =
      "# rotations, s' = R s; append your matrix to each line, all entries or band after band, row by row\n"
      "r00,r01,r02,r10,r11,r12,r20,r21,r22\n";
  for (int i = 0; i < count; ++i) {
    const auto& input = all[static_cast<std::size_t>(i * (most - 1) / (count - 1))];
    for (std::size_t k = 0; k < 9; ++k) {
      std::array<char, 40> number{};
      std::snprintf(number.data(), number.size(), "%s%.17g", k > 0 ? "," : "", input.values[k]);
      text += number.data();
    }
    text += "  # " + input.name + "\n";
  }
  return text;
}

ExitCode run(const Options& options) {
  const auto cases = identify::read_rotation_cases(identify::read_table(options.file));
  const auto result = identify::check_rotations(cases, options.tolerance);
  print(options.json ? format_json(result) : format_text(result, options.all));
  return result.passes() ? kDone : kDifferent;
}

}  // namespace

void add_rotation_matrix_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("rotation-matrix", "check your own rotation matrices of spherical harmonics");
  auto* file = command->add_option("file", options->file, "CSV: r00,...,r22, then the matrix, a rotation a line");
  auto* rotations = command->add_option("--rotations", options->rotations, "print so many rotations to fill in");
  rotations->excludes(file);
  command->add_option("--tolerance", options->tolerance, "largest error allowed [16 (l+1) epsilon]")
      ->check(CLI::PositiveNumber);
  command->add_flag("--all", options->all, "list every reading that fits, not presets alone");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, file, rotations, &exit_code] {
    if (rotations->count() > 0) return print(suggested_rotations(options->rotations));
    if (file->count() == 0) throw std::invalid_argument("rotation-matrix: it needs FILE or --rotations N");
    exit_code = run(*options);
  });
}

}  // namespace sh::numeric
