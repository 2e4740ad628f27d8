// shcheck kernels: every generated kernel against the oracle.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "numeric/commands/commands.hpp"
#include "numeric/kernels/kernel_check.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/kernels/kernel_report.hpp"
#include "numeric/output/atomic_file.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string generated = SHFORGE_GENERATED_DIR;
  std::string family;
  std::string json_file;
};

// What is wrong, a line each.
std::vector<std::string> failures_in(const std::vector<KernelResult>& results) {
  std::vector<std::string> failures;
  for (const auto& kernel : unchecked_kernels(bound_kernels())) {
    failures.push_back(kernel + ": no check describes its family");
  }
  for (const auto& result : results) {
    for (auto& failure : failures_of(result)) failures.push_back(std::move(failure));
  }
  return failures;
}

ExitCode run(const Options& options) {
  const auto results = check_kernels({options.generated, options.family}, say);
  const auto failures = failures_in(results);
  print(options.family.empty() ? format_summary(results) : format_details(results));
  if (!options.json_file.empty()) output::write_file(options.json_file, format_json(results, failures));
  for (const auto& failure : failures) say(failure);
  return failures.empty() ? kDone : kDifferent;
}

}  // namespace

void add_kernels_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand("kernels", "compare every generated kernel with the oracle");
  command->add_option("--family", options->family, "only this family and its variants, a line a language and scalar");
  command->add_option("--json", options->json_file, "also write the results to this file");
  command->add_option("--generated", options->generated, "the folder generated/ whose GLSL files are run")
      ->capture_default_str();
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace sh::numeric
