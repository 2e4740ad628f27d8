// `shgen prove`: runs the catalogue of proofs and prints a line for each identity; or changes the formulas one at a time
// and prints the proofs that refute each change.
//
// Input: options. Output: lines on `out`, a JSON file if the options name one, progress on `progress`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "codegen/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "numeric/output/stopwatch.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/number/find_named.hpp"
#include "symbolic/proofs/mutations/mutation.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::codegen {
namespace {

// The options of `shgen prove`.
struct ProveOptions {
  std::optional<int> degree;      // the highest degree, limited by the range of each proof; empty: its default
  std::vector<std::string> only;  // names of the proofs to run; empty: all
  std::string json;               // the file to write, complete or not at all; empty: none
  std::string mutations;          // the list of changes to try; empty: prove
};

// A change that no proof refutes to the first degree is tried at the second one, which costs five times as much.
constexpr std::array<int, 2> kMutationDegrees{2, 3};

using symbolic::Proof;

struct Run {
  int degree = 0;
  double seconds = 0;
  symbolic::ProofResult result;

  [[nodiscard]] bool holds() const { return result.outcome == symbolic::Outcome::kHolds; }
};

std::vector<Proof> chosen_proofs(const std::vector<std::string>& only) {
  std::vector<Proof> all = symbolic::all_proofs();
  if (only.empty()) return all;
  std::vector<Proof> chosen;
  for (const std::string& name : only) chosen.push_back(symbolic::find_named(all, name, "proof"));
  return chosen;
}

Run run(const Proof& proof, int degree) {
  const output::Stopwatch stopwatch;
  symbolic::ProofResult result = symbolic::run_proof(proof, degree);
  return {degree, stopwatch.seconds(), std::move(result)};
}

const char* verdict(const Proof& proof, const Run& run) {
  switch (run.result.outcome) {
    case symbolic::Outcome::kHolds:
      return proof.spot_check ? "checked" : "proved";
    case symbolic::Outcome::kRefuted:
      return "REFUTED";
    default:
      return "FAILED";
  }
}

std::string range(const Proof& proof, int degree) {
  return proof.every_degree ? "every l" : "l <= " + std::to_string(degree);
}

void print_line(std::ostream& out, const Proof& proof, const Run& run) {
  out << fmt::format("{:<8}{:<31}{:<8}{:>8.2f} s  {} | {} | {}\n", verdict(proof, run), proof.name,
                     range(proof, run.degree), run.seconds, proof.statement, proof.method, run.result.detail)
      << std::flush;  // a proof may take minutes
}

nlohmann::ordered_json as_json(const Proof& proof, const Run& run) {
  nlohmann::ordered_json entry;
  entry["name"] = proof.name;
  entry["kind"] = proof.spot_check ? "spot check" : "proof";
  entry["statement"] = proof.statement;
  entry["method"] = proof.method;
  if (proof.every_degree) {
    entry["degree"] = "every";
  } else {
    entry["degree"] = run.degree;
    entry["max_degree"] = proof.max_degree;
    entry["limit"] = proof.limit;
  }
  entry["seconds"] = run.seconds;
  entry["result"] = verdict(proof, run);
  entry["detail"] = run.result.detail;
  return entry;
}

// How many hold: "52 proofs" or "51 of 52 proofs".
struct Count {
  int total = 0;
  int holding = 0;

  void add(bool holds) {
    ++total;
    holding += holds ? 1 : 0;
  }
  [[nodiscard]] std::string to_string(const char* what) const {
    return (holding == total ? "" : std::to_string(holding) + " of ") + std::to_string(total) + " " + what +
           (total == 1 ? "" : "s");
  }
};

// True if every identity holds. Throws std::invalid_argument for an unknown name and std::runtime_error if it cannot
// write the JSON file.
bool prove(const ProveOptions& options, std::ostream& out, std::ostream& progress) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  Count proofs;
  Count spot_checks;
  double seconds = 0;
  for (const Proof& proof : chosen_proofs(options.only)) {
    const Run result = run(proof, options.degree ? std::min(*options.degree, proof.max_degree) : proof.default_degree);
    print_line(out, proof, result);
    report.push_back(as_json(proof, result));
    seconds += result.seconds;
    (proof.spot_check ? spot_checks : proofs).add(result.holds());
  }
  if (!options.json.empty()) output::write_file(options.json, report.dump(2) + "\n");
  progress << fmt::format("shgen: {}, {} in {:.1f} s\n", proofs.to_string("proof"), spot_checks.to_string("spot check"),
                          seconds);
  return proofs.holding == proofs.total && spot_checks.holding == spot_checks.total;
}

symbolic::MutationResult judged(const symbolic::Mutation& mutation, std::optional<int> degree) {
  if (degree) return symbolic::judge(mutation, *degree);
  symbolic::MutationResult result = symbolic::judge(mutation, kMutationDegrees[0]);
  return result.survives() ? symbolic::judge(mutation, kMutationDegrees[1]) : result;
}

// True if the proofs refute every change that is not named as an equivalent, and no equivalent.
bool mutate(const ProveOptions& options, std::ostream& out, std::ostream& progress) {
  std::ifstream file(options.mutations);
  if (!file) throw std::invalid_argument(options.mutations + ": expected a readable list of mutations, got none");
  const output::Stopwatch stopwatch;
  int refuted = 0;
  int equivalents = 0;
  int wrong = 0;
  for (const symbolic::Mutation& mutation : symbolic::read_mutations(file, options.mutations)) {
    const symbolic::MutationResult result = judged(mutation, options.degree);
    const bool named = !mutation.equivalent.empty();
    refuted += result.survives() ? 0 : 1;
    equivalents += named && result.survives() ? 1 : 0;
    wrong += named == result.survives() ? 0 : 1;
    const char* const verdict = !result.survives() ? named ? "REFUTED" : "refuted" : named ? "equivalent" : "SURVIVES";
    std::string by = fmt::format("{}", fmt::join(result.proofs, ", "));
    if (!result.spot_checks.empty()) by += fmt::format(" (spot checks: {})", fmt::join(result.spot_checks, ", "));
    out << fmt::format("{:<11}{:<45} {}\n", verdict, mutation.to_string(), named ? mutation.equivalent : by)
        << std::flush;
  }
  progress << fmt::format("shgen: proofs refute {} changes, {} are named equivalents, {} are wrong, in {:.1f} s\n",
                          refuted, equivalents, wrong, stopwatch.seconds());
  return wrong == 0;
}

// Throws std::invalid_argument for a negative or too large degree, and as the two commands do.
bool run_command(const ProveOptions& options, std::ostream& out, std::ostream& progress) {
  if (options.degree) {
    symbolic::require_degree("prove", *options.degree, symbolic::kMaxBasisDegree, "the basis is derived to there");
  }
  if (!options.json.empty()) output::require_writable(options.json);
  return options.mutations.empty() ? prove(options, out, progress) : mutate(options, out, progress);
}

}  // namespace

void add_prove_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* const command = tool.add_subcommand("prove", "Prove every identity that the kernels use");
  CLI::Option* const names = command->add_option("name", options->only, "Proofs to run (default: all)");
  command->add_option("--degree", options->degree, "Highest degree, limited by the range of each proof");
  CLI::Option* const json = command->add_option("--json", options->json, "File to write the results to");
  command->add_option("--mutate", options->mutations, "File of changes of the formulas, which the proofs refute")
      ->excludes(names)
      ->excludes(json);
  command->callback(
      [options, &exit_code] { exit_code = run_command(*options, std::cout, std::cerr) ? kDone : kDifferent; });
}

}  // namespace sh::codegen
