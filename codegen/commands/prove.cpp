// `shgen prove`: runs the catalogue of proofs and prints a line for each identity.
//
// Input: options. Output: lines on `out`, a JSON file if the options name one, progress on `progress`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
#include "symbolic/proofs/proofs.hpp"

namespace sh::codegen {
namespace {

// The options of `shgen prove`.
struct ProveOptions {
  std::optional<int> degree;      // the highest degree, limited by the range of each proof; empty: its default
  std::vector<std::string> only;  // names of the proofs to run; empty: all
  std::string json;               // the file to write, complete or not at all; empty: none
};

using symbolic::Proof;

struct Outcome {
  int degree = 0;
  double seconds = 0;
  symbolic::ProofResult result;
};

std::vector<Proof> chosen_proofs(const std::vector<std::string>& only) {
  std::vector<Proof> all = symbolic::all_proofs();
  if (only.empty()) return all;
  std::vector<Proof> chosen;
  for (const std::string& name : only) chosen.push_back(symbolic::find_named(all, name, "proof"));
  return chosen;
}

Outcome run(const Proof& proof, int degree) {
  const output::Stopwatch stopwatch;
  symbolic::ProofResult result = symbolic::run_proof(proof, degree);
  return {degree, stopwatch.seconds(), std::move(result)};
}

const char* verdict(const Outcome& outcome) { return outcome.result.proved ? "proved" : "REFUTED"; }

std::string range(const Proof& proof, int degree) {
  return proof.every_degree ? "every l" : "l <= " + std::to_string(degree);
}

void print_line(std::ostream& out, const Proof& proof, const Outcome& outcome) {
  out << fmt::format("{:<8}{:<31}{:<8}{:>8.2f} s  {} | {} | {}\n", verdict(outcome), proof.name,
                     range(proof, outcome.degree), outcome.seconds, proof.statement, proof.method,
                     outcome.result.detail)
      << std::flush;  // a proof may take minutes
}

nlohmann::ordered_json as_json(const Proof& proof, const Outcome& outcome) {
  nlohmann::ordered_json entry;
  entry["name"] = proof.name;
  entry["statement"] = proof.statement;
  entry["method"] = proof.method;
  if (proof.every_degree) {
    entry["degree"] = "every";
  } else {
    entry["degree"] = outcome.degree;
    entry["max_degree"] = proof.max_degree;
    entry["limit"] = proof.limit;
  }
  entry["seconds"] = outcome.seconds;
  entry["result"] = verdict(outcome);
  entry["detail"] = outcome.result.detail;
  return entry;
}

// True if every identity is proved. Throws std::invalid_argument for a negative or too large degree or an unknown
// name, and std::runtime_error if it cannot write the JSON file.
bool prove(const ProveOptions& options, std::ostream& out, std::ostream& progress) {
  if (options.degree) {
    symbolic::require_degree("prove", *options.degree, symbolic::kMaxBasisDegree, "the basis is derived to there");
  }
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  int count = 0;
  double seconds = 0;
  const std::vector<Proof> proofs = chosen_proofs(options.only);
  for (const Proof& proof : proofs) {
    const Outcome outcome =
        run(proof, options.degree ? std::min(*options.degree, proof.max_degree) : proof.default_degree);
    print_line(out, proof, outcome);
    report.push_back(as_json(proof, outcome));
    seconds += outcome.seconds;
    count += outcome.result.proved ? 1 : 0;
  }
  if (!options.json.empty()) output::write_file(options.json, report.dump(2) + "\n");
  progress << fmt::format("shgen: {} of {} identities proved in {:.1f} s\n", count, proofs.size(), seconds);
  return count == static_cast<int>(proofs.size());
}

}  // namespace

void add_prove_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* const command = tool.add_subcommand("prove", "Prove every identity that the kernels use");
  command->add_option("name", options->only, "Proofs to run (default: all)");
  command->add_option("--degree", options->degree, "Highest degree, limited by the range of each proof");
  command->add_option("--json", options->json, "File to write the results to");
  command->callback([options, &exit_code] { exit_code = prove(*options, std::cout, std::cerr) ? kDone : kDifferent; });
}

}  // namespace sh::codegen
