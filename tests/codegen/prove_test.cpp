// `shgen prove` from outside: a line and a JSON entry for each identity, exit codes, bad arguments.
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

}  // namespace
}  // namespace sh::codegen
