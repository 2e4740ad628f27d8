// `shgen prove` from outside: a line and a JSON entry for each identity, proofs apart from spot checks, to every degree
// that `shgen emit` offers; its list of changes, each refuted; bad arguments give one line.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "codegen/families/family.hpp"
#include "symbolic/proofs/mutations/mutation.hpp"
#include "symbolic/proofs/proofs.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using symbolic::Mutation;
using symbolic::Outcome;
using symbolic::Proof;
using symbolic::ProofResult;
using test::contains;
using test::lines;
using test::shgen;

constexpr const char* kMutations = SHFORGE_SOURCE_DIR "/tests/data/mutations.txt";

TEST(Prove, EveryIdentityHoldsWithALineAndAJsonEntry) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "proofs.json";
  const auto result = shgen("prove --degree 3 --json " + test::quoted(file));
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const auto expected = symbolic::all_proofs();
  EXPECT_EQ(lines(result.out), static_cast<std::ptrdiff_t>(expected.size()));
  const auto report = nlohmann::json::parse(test::read_file(file));
  ASSERT_EQ(report.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string verdict = expected[i].spot_check ? "checked" : "proved";
    EXPECT_EQ(report[i].at("name"), expected[i].name);
    EXPECT_EQ(report[i].at("kind"), expected[i].spot_check ? "spot check" : "proof");
    EXPECT_EQ(report[i].at("result"), verdict);
    for (const char* key : {"statement", "method", "degree", "seconds", "detail"}) {
      EXPECT_TRUE(report[i].contains(key)) << key;
    }
    EXPECT_TRUE(contains(result.out, verdict + (expected[i].spot_check ? " " : "  ") + expected[i].name));
  }
}

TEST(Prove, SpotChecksAreCountedApartFromProofs) {
  EXPECT_TRUE(contains(shgen("prove --degree 2 axes axis-angle complex-rotation").err, "2 proofs, 1 spot check in"));
  for (const Proof& proof : symbolic::all_proofs()) {
    const bool some_points = contains(proof.method, "random") || contains(proof.method, "at a ");
    EXPECT_EQ(proof.spot_check, some_points) << proof.name << ": " << proof.method;
  }
}

TEST(Prove, NamesAreUniqueAndDefaultsLieInTheirRange) {
  std::set<std::string> names;
  for (const Proof& proof : symbolic::all_proofs()) {
    EXPECT_TRUE(names.insert(proof.name).second) << proof.name;
    EXPECT_GE(proof.default_degree, 0) << proof.name;
    EXPECT_LE(proof.default_degree, proof.max_degree) << proof.name;
    EXPECT_FALSE(proof.limit.empty()) << proof.name;
    EXPECT_THROW(proof.run(-1), std::invalid_argument) << proof.name;
    EXPECT_THROW(proof.run(proof.max_degree + 1), std::invalid_argument) << proof.name;
  }
}

TEST(Prove, AProofThatThrowsAnythingFailsWithItsErrorSoThatTheOthersStillRun) {
  Proof proof;
  proof.run = [](int) -> int { throw std::runtime_error("no such polynomial"); };
  const ProofResult stopped = symbolic::run_proof(proof, 2);
  EXPECT_EQ(stopped.outcome, Outcome::kFailed);
  EXPECT_EQ(stopped.detail, "no such polynomial");
  proof.run = [](int) -> int { throw 7; };
  EXPECT_EQ(symbolic::run_proof(proof, 2).outcome, Outcome::kFailed);
  proof.run = [](int) -> int { throw symbolic::Refuted("l=2 m=1"); };
  EXPECT_EQ(symbolic::run_proof(proof, 2).outcome, Outcome::kRefuted);
}

// The proofs behind each family, by the beginning of its name; "" concerns all of them.
TEST(Prove, ProofsReachEveryDegreeThatEmitOffers) {
  const std::multimap<std::string, std::vector<std::string>> behind{
      {"", {"basis-derivations", "orthonormality", "harmonicity", "forms-agree", "factors"}},
      {"", {"convention-definitions", "convention-coefficients", "index-orders"}},
      {"basis_gradient", {"gradients"}},
      {"rotate",
       {"equivariance", "quaternion-recursion", "recursion-tables", "wigner-form", "about-y", "about-z", "x90"}},
      {"cap", {"zonal-cap", "zonal-cap-small"}},
      {"add_cap", {"zonal-cap", "zonal-cap-small", "turned-zonal"}},
      {"zonal", {"turned-zonal", "convolution-theorem"}},
      {"irradiance", {"irradiance-factors", "irradiance-convolution"}},
      {"lightmap", {"irradiance-factors", "irradiance-convolution"}},
      {"window", {"window-angles", "window-gaussian", "window-laplacian"}},
      {"product", {"gaunt-tensor", "gaunt-symmetry", "gaunt-selection-rules", "product-identity"}},
      {"product_zonal", {"zonal-product-identity"}},
      {"square", {"gaunt-tensor", "square-identity"}},
      {"triple", {"gaunt-tensor", "product-identity"}},
      {"transfer", {"gaunt-tensor", "product-identity"}},
      {"transfer_glossy", {"turned-zonal", "convolution-theorem"}}};
  const std::map<std::string, std::vector<std::string>> about_z_only{{"rotate_z", {"about-z"}}};
  std::map<std::string, int> reached;
  for (const Proof& proof : symbolic::all_proofs()) {
    if (!proof.spot_check) reached[proof.name] = proof.default_degree;
  }
  for (const Family& family : families()) {
    for (const auto& [beginning, proofs] : behind) {
      if (family.name.rfind(beginning, 0) != 0) continue;
      const auto special = about_z_only.find(family.name);
      for (const std::string& name : special != about_z_only.end() && !beginning.empty() ? special->second : proofs) {
        ASSERT_TRUE(reached.contains(name)) << name;
        EXPECT_GE(reached[name], family.largest_emitted) << name << " behind " << family.name;
      }
    }
  }
}

TEST(Prove, GinacDefinesEveryFamily) {
  std::set<std::string> defined;
  for (const Proof& proof : symbolic::all_proofs()) {
    if (contains(proof.statement, "GiNaC's definition")) defined.insert(proof.name);
  }
  for (const char* name : {"basis-derivations", "equivariance", "wigner-form", "quaternion-recursion", "zonal-cap",
                           "zonal-cap-small", "irradiance-factors", "gaunt-tensor"}) {
    EXPECT_TRUE(defined.contains(name)) << name;
  }
}

TEST(Prove, RunsTheNamedIdentitiesOnly) {
  const auto result = shgen("prove axis-angle zyz-angles");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(lines(result.out), 2);
}

TEST(Prove, BadArgumentsAreOneLineAndExitTwo) {
  const char* const cases[][2] = {{"--degree -1", "0 to 50"},
                                  {"--degree 51", "0 to 50"},
                                  {"--degree ten", "--degree"},
                                  {"no-such-identity", "orthonormality"},
                                  {"--mutate /no/such/list", "/no/such/list"},
                                  {"axis-angle --json /no/such/folder/proofs.json", "/no/such/folder/proofs.json"}};
  for (const auto& [arguments, mention] : cases) test::expect_refused(std::string("prove ") + arguments, mention);
}

TEST(Prove, TheReportsPlaceIsLookedAtBeforeAnythingIsProvedOrDecided) {
  for (const char* command : {"prove axis-angle", "errata B-08"}) {
    const auto result = test::expect_refused(std::string(command) + " --json /no/such/x", "/no/such/x: cannot write");
    EXPECT_EQ(result.out, "") << command;
  }
}

TEST(Shgen, SaysItsVersion) { EXPECT_EQ(shgen("--version").out, "shgen 0.1.0\n"); }

// The whole list: no change survives but named equivalents, and no proof is idle.
TEST(Mutations, AProofRefutesEveryChangeOfAFormulaButNamedEquivalents) {
  const auto result = shgen(std::string("prove --mutate ") + kMutations);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(contains(result.out, "SURVIVES")) << result.out;
  for (const Proof& proof : symbolic::all_proofs()) EXPECT_TRUE(contains(result.out, proof.name)) << proof.name;
}

TEST(Mutations, TheListChangesEveryFormula) {
  std::ifstream file(kMutations);
  std::set<std::string> changed;
  for (const Mutation& mutation : symbolic::read_mutations(file, kMutations)) changed.insert(mutation.formula);
  for (const std::string& name : symbolic::mutation_names()) EXPECT_TRUE(changed.contains(name)) << name;
}

// What proofs without normalizations and without the sum of c' Y' cannot see.
TEST(Mutations, LeavingOutTheInverseTransposeEverywhereIsRefuted) {
  for (const char* kind : {"transpose", "inverse", "inverse-transpose"}) {
    const auto result = symbolic::judge({"convention-map", {"everywhere"}, kind, ""}, 2);
    EXPECT_EQ(result.proofs, (std::vector<std::string>{"convention-coefficients", "convention-axes"})) << kind;
  }
}

TEST(Mutations, ASurvivorAndARefutedEquivalentEndWithOne) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "list.txt";
  test::write_file(file, "gaunt-rule 1 2 3 sign\n");
  const auto survivor = shgen("prove --degree 1 --mutate " + test::quoted(file));
  EXPECT_EQ(survivor.exit_code, 1);
  EXPECT_TRUE(contains(survivor.out, "SURVIVES"));
  test::write_file(file, "gaunt 0 0 0 sign = no equivalent\n");
  EXPECT_EQ(shgen("prove --degree 1 --mutate " + test::quoted(file)).exit_code, 1);
}

TEST(Mutations, BadLinesAreNamedWithFileAndNumber) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "list.txt";
  for (const char* line : {"gaunt", "no-such-formula 1 sign", "gaunt 1 2 sign", "gaunt 1 2 x sign",
                           "zonal no-cap 1 sign", "convention-factor no-size 1 1 sign", "gaunt 0 0 0 sign ="}) {
    test::write_file(file, std::string("# first line\n") + line + "\n");
    test::expect_refused("prove --mutate " + test::quoted(file), "list.txt:2");
  }
  test::write_file(file, "gaunt 0 0 0 no-such-kind\n");
  test::expect_refused("prove --degree 1 --mutate " + test::quoted(file), "no-such-kind");
}

}  // namespace
}  // namespace sh::codegen
