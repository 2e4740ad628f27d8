// Commands from outside: `shgen prove` has a line and a JSON entry for each identity; the documents of `shgen tex` and
// `shgen markdown` compile; bad arguments give one line.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "symbolic/proofs/proofs.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::lines;
using test::shgen;

TEST(Prove, EveryIdentityIsProvedWithALineAndAJsonEntry) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "proofs.json";
  const auto result = shgen("prove --degree 4 --json " + test::quoted(file));
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const auto expected = symbolic::all_proofs();
  EXPECT_EQ(lines(result.out), static_cast<std::ptrdiff_t>(expected.size()));
  const auto report = nlohmann::json::parse(test::read_file(file));
  ASSERT_EQ(report.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(report[i].at("name"), expected[i].name);
    EXPECT_EQ(report[i].at("result"), "proved");
    for (const char* key : {"statement", "method", "degree", "seconds", "detail"}) {
      EXPECT_TRUE(report[i].contains(key)) << key;
    }
    EXPECT_NE(result.out.find("proved  " + expected[i].name), std::string::npos);
  }
}

TEST(Prove, NamesAreUniqueAndDefaultsLieInTheirRange) {
  std::set<std::string> names;
  for (const symbolic::Proof& proof : symbolic::all_proofs()) {
    EXPECT_TRUE(names.insert(proof.name).second) << proof.name;
    EXPECT_GE(proof.default_degree, 0) << proof.name;
    EXPECT_LE(proof.default_degree, proof.max_degree) << proof.name;
    EXPECT_FALSE(proof.limit.empty()) << proof.name;
    EXPECT_THROW(proof.run(-1), std::invalid_argument) << proof.name;
    EXPECT_THROW(proof.run(proof.max_degree + 1), std::invalid_argument) << proof.name;
  }
}

TEST(Prove, AProofThatThrowsIsRefutedWithItsErrorSoThatTheOthersStillRun) {
  symbolic::Proof proof;
  proof.run = [](int) -> int { throw std::runtime_error("no such polynomial"); };
  const symbolic::ProofResult result = symbolic::run_proof(proof, 2);
  EXPECT_FALSE(result.proved);
  EXPECT_NE(result.detail.find("no such polynomial"), std::string::npos) << result.detail;
}

TEST(Prove, GinacDefinesEveryFamilyToEveryEmittedDegree) {
  const std::map<std::string, int> emitted{{"basis-derivations", 20},    {"equivariance", 10}, {"wigner-form", 20},
                                           {"quaternion-recursion", 10}, {"zonal-cap", 20},    {"zonal-cap-small", 20},
                                           {"irradiance-factors", 20},   {"gaunt-tensor", 12}};
  std::size_t found = 0;
  for (const symbolic::Proof& proof : symbolic::all_proofs()) {
    const auto expected = emitted.find(proof.name);
    if (expected == emitted.end()) continue;
    ++found;
    EXPECT_NE(proof.statement.find("GiNaC's definition"), std::string::npos) << proof.name;
    EXPECT_GE(proof.default_degree, expected->second) << proof.name;
  }
  EXPECT_EQ(found, emitted.size());
}

TEST(Prove, ChosenProofsRunAlone) {
  const auto result = shgen("prove axis-angle zyz-angles");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(lines(result.out), 2);
}

TEST(Prove, BadArgumentsAreOneLineAndExitTwo) {
  const char* const cases[][2] = {{"--degree -1", "0 to 50"},
                                  {"--degree 51", "0 to 50"},
                                  {"--degree ten", "--degree"},
                                  {"no-such-identity", "orthonormality"},
                                  {"axis-angle --json /no/such/folder/proofs.json", "/no/such/folder/proofs.json"}};
  for (const auto& [arguments, mention] : cases) test::expect_refused(std::string("prove ") + arguments, mention);
}

TEST(TypesetCommand, TexCompilesWithPlainLatex) {
  ASSERT_EQ(test::run_command("command -v pdflatex").exit_code, 0)
      << "pdflatex is missing; install it with: apt-get install --no-install-recommends texlive-latex-base";
  for (const std::string table : {"rotation --degree 3", "gaunt --degree 2", "cap --degree 6", "basis --degree 4",
                                  "cosine-power --degree 4", "product --degree 2", "rotation-quaternion --degree 2",
                                  "turned-zonal --degree 2 --convention scipy", "linear-lobe --degree 3"}) {
    const test::TemporaryFolder folder;
    const auto result =
        test::run_command("cd " + test::quoted(folder.path()) + " && " + test::quoted(SHFORGE_BIN_DIR "/shgen") +
                          " tex " + table + " > table.tex && pdflatex -halt-on-error -interaction=batchmode table.tex");
    EXPECT_EQ(result.exit_code, 0) << table << "\n" << result.out << result.err;
    // A line that runs over the margin means a formula that nobody can read.
    EXPECT_EQ(test::read_file(folder.path() / "table.log").find("Overfull"), std::string::npos) << table;
  }
}

TEST(TypesetCommand, MarkdownHoldsTheSameFormulas) {
  const auto result = shgen("markdown cap --degree 1");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("| $z_{1}$ | $-\\frac{1}{2}\\sqrt{3\\pi}\\,(c^{2} - 1)$ |"), std::string::npos)
      << result.out;
}

TEST(TypesetCommand, OutputIsTheSameInEveryRun) {
  for (const std::string table : {"tex rotation --degree 2", "markdown cosine-power --degree 5"}) {
    EXPECT_EQ(shgen(table).out, shgen(table).out) << table;
  }
}

TEST(TypesetCommand, BadInputIsOneLineAndExitCodeTwo) {
  const char* const cases[][2] = {{"tex cap --degree -1", "0 to 20"},
                                  {"tex rotation --degree 7", "0 to 6"},
                                  {"tex cones --degree 2", "sphere-light"},
                                  {"markdown cap --degree 2 --convention godot", "directxmath"},
                                  {"tex wigner-d --degree 2 --convention threejs --degree 2", "--degree"},
                                  {"tex wigner-d --degree 2 --convention scipy", "--convention"},
                                  {"tex gaunt --degree 2 --convention unity", "clamped cosine"},
                                  {"tex cap", "--degree"},
                                  {"tex --degree 2", "family"},
                                  {"tex cap --degree two", "two"}};
  for (const auto& [arguments, part] : cases) {
    EXPECT_EQ(test::expect_refused(arguments, part).out, "") << arguments;
  }
}

}  // namespace
}  // namespace sh::codegen
