// Estimates of the cost of a bake, and bakes that must fit into a time. No test depends on the speed of the machine.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

// 10 s of rays, 0.5 s of preparation, 20 bounces of 0.2 s.
BakeEstimate made_up() { return {.setup_seconds = 0.5, .pass_seconds = 10.0, .bounce_seconds = 0.2, .bounces = 20.0}; }

BakeOptions wanted(int directions) { return {.directions = directions}; }

Scene room(const TransferKind* kind) { return scene_of(primitive_mesh("arch"), kind, 512); }

TEST(Budget, LeavesEverythingWhereThereIsTimeEnough) {
  for (const double seconds : {20.0, 1e3, 1e9}) {
    EXPECT_EQ(within_budget(wanted(2048), made_up(), seconds).directions, 2048) << seconds;
  }
}

TEST(Budget, TakesFewerDirectionsTheLessTimeThereIsAndStaysWithinIt) {
  int before = 2048;
  for (const double seconds : {16.0, 12.0, 8.0, 4.0, 2.0, 1.5}) {
    const BakeEstimate estimate = made_up();
    const int directions = within_budget(wanted(2048), estimate, seconds).directions;
    EXPECT_LE(directions, before) << seconds;
    EXPECT_GE(directions, kLeastDirections) << seconds;
    EXPECT_LT(estimate.setup_seconds + estimate.pass_seconds * directions / 2048.0, seconds) << seconds;
    before = directions;
  }
  EXPECT_LT(before, 200);
}

TEST(Budget, IsRefusedWithWhatWouldDoWhereNotEvenTheLeastFits) {
  const std::string said = message_of([] { within_budget(wanted(2048), made_up(), 0.5); });
  EXPECT_NE(said.find("--budget-seconds 0.5: too short; 64 directions, the least, take about "), std::string::npos)
      << said;
  EXPECT_NE(message_of([] { within_budget(wanted(2048), made_up(), 0.0); }), "");
  const double enough = std::stod(said.substr(said.find("about ") + 6));
  EXPECT_GE(within_budget(wanted(2048), made_up(), 1.1 * enough).directions, kLeastDirections);
}

TEST(Budget, AsksForNoMoreDirectionsThanThereShouldBe) {
  EXPECT_EQ(within_budget(wanted(16), made_up(), 1e6).directions, 16);
  EXPECT_EQ(within_budget(wanted(16), BakeEstimate(), 1.0).directions, 16);
}

TEST(Bounces, StopWhenTimeIsOverWithACertifiedErrorOfWhatTheyReached) {
  Scene scene = room(&kInterreflected);
  const BakeOptions options = scene.bake;
  const Transfer whole = bake(scene);
  scene.bake.bounces.deadline = std::chrono::steady_clock::time_point::min();
  Transfer early = bake({scene, {0, "", OnFlaw::kRefuse}});
  EXPECT_LT(early.bounces.applications, whole.bounces.applications);
  EXPECT_TRUE(early.bounces.certified);
  EXPECT_GT(early.bounces.bound, options.bounces.tolerance * early.bounces.largest);
  const double worst = largest_difference(whole, early);
  EXPECT_LE(worst, early.bounces.bound + whole.bounces.bound);
  EXPECT_GT(worst, 0.0);
  early.missing = shortfall(options, early);
  EXPECT_EQ(early.missing.tolerance, options.bounces.tolerance);
  EXPECT_EQ(early.missing.directions, 0U);
  EXPECT_FALSE(shortfall(options, whole).any());
}

TEST(TransferFile, SaysWhatALimitedTimeLeftOut) {
  const TemporaryFolder folder;
  const Scene scene = room(&kShadowed);
  Transfer transfer = bake(scene);
  BakeOptions more = scene.bake;
  more.directions = 4096;
  transfer.missing = shortfall(more, transfer);
  write_transfer(folder.file("a"), transfer);
  const Transfer read = read_transfer(folder.file("a"));
  EXPECT_EQ(read.missing.directions, 4096U);
  EXPECT_EQ(read.missing.tolerance, 0.0);
  const auto header = nlohmann::json::parse(transfer_header(read));
  EXPECT_EQ(header["complete"], false);
  EXPECT_EQ(header["directions"], 512);
  EXPECT_EQ(header["asked"]["directions"], 4096);
  EXPECT_FALSE(nlohmann::json::parse(transfer_header(bake(scene))).contains("complete"));
}

TEST(Estimate, CountsRaysAndFormFactorsFromASample) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const Scene scene = room(kind);
    BakeReport report;
    bake(scene, &report);
    const BakeEstimate estimate = estimate_bake(scene);
    EXPECT_EQ(estimate.vertices, scene.mesh.positions.size());
    EXPECT_NEAR(estimate.rays, static_cast<double>(report.rays), 0.3 * static_cast<double>(report.rays));
    EXPECT_GT(estimate.pass_seconds, 0.0);
    EXPECT_GT(estimate.bytes, scene.mesh.positions.size() * 9 * sizeof(float));
    EXPECT_EQ(estimate.factor_bytes > 0, kind == &kInterreflected);
    EXPECT_EQ(estimate.bounces > 0.0, kind == &kInterreflected);
  }
}

TEST(Estimate, LeavesItsTracerToABakeOfTheSameRaysAndNumbers) {
  Scene mirrored = room(&kInterreflected);
  mirrored.mesh.mirror.assign(mirrored.mesh.positions.size(), Eigen::Vector3f(0.3F, 0.2F, 0.1F));  // a bake a channel
  for (const Scene& scene : {room(&kShadowed), room(&kInterreflected), mirrored}) {
    BakeReport alone;
    BakeReport estimated;
    const Transfer transfer = bake(scene, &alone);
    EXPECT_EQ(bake(scene, &estimated, [](const std::string& /*line*/) {}).coefficients, transfer.coefficients);
    EXPECT_EQ(estimated.rays, alone.rays);
    EXPECT_GT(alone.rays, 0U);
  }
}

TEST(Tool, BakesWithinABudgetAndSaysWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string scene = folder.file("scene.json");
  const std::string out = folder.file("out");
  write_all(scene, R"({"meshes": [{"primitive": "torus"}], "bake": {"degree": 1, "transfer": "interreflected"}})");
  // The budget follows from this machine's own estimate: room for the setup and for a sixteenth of the directions.
  const Finished estimated = run_prt({"bake", scene, "--directions", "1048576", "--estimate"});
  ASSERT_EQ(estimated.status, 0) << estimated.err;
  const auto estimate = nlohmann::json::parse(estimated.out);
  const double budget = 3 * estimate["setup_seconds"].get<double>() + estimate["seconds"].get<double>() / 16;
  const Finished run =
      run_prt({"bake", scene, "-o", out, "--directions", "1048576", "--budget-seconds", std::to_string(budget)});
  ASSERT_EQ(run.status, 0) << run.err;
  const Transfer transfer = read_transfer(out);
  EXPECT_EQ(transfer.missing.directions, 1048576U);
  EXPECT_GE(transfer.directions, 64U);
  EXPECT_LT(transfer.directions, 1048576U);
  EXPECT_NE(run.err.find("of 1048576 directions fit into "), std::string::npos) << run.err;
  EXPECT_EQ(folder.entries(), 2U);
  const std::string whole = read_all(out);
  expect_refused({"bake", scene, "-o", out, "--budget-seconds", "x"}, "--budget-seconds");
  expect_refused({"bake", scene, "-o", out, "--budget-seconds", "-1"}, "--budget-seconds");
  expect_refused({"bake", scene, "-o", out, "--budget-seconds", "1", "--checkpoint", "x"}, "--checkpoint");
  EXPECT_EQ(run_prt({"bake", scene, "-o", out, "--budget-seconds", "0.00001"}).status, 2);
  EXPECT_TRUE(read_all(out) == whole);
}

TEST(Tool, WarnsOnceOfAFileThatIsCoarserThanAskedForAndRefusesItWhenStrict) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.transfer");
  Transfer transfer = bake(room(&kInterreflected));
  const std::vector<std::string> relight = {"relight", file, "--light", "constant", "-o", folder.file("a.ply")};
  write_transfer(file, transfer);
  EXPECT_EQ(run_prt(relight).err.find("warning"), std::string::npos);
  transfer.missing = {4096, 1e-9};
  write_transfer(file, transfer);
  const std::string said = "warning: " + file + ": coarser than was asked for: 512 of 4096 directions, bounces to ";
  EXPECT_NE(run_prt(relight).err.find(said), std::string::npos) << run_prt(relight).err;
  write_all(folder.file("stage.json"), R"({"objects": [{"transfer": "a.transfer"}, {"transfer": "a.transfer",
    "position": [50, 0, 0]}]})");
  const Finished render = run_prt({"render", folder.file("stage.json"), "--width", "32", "--height", "32", "--samples",
                                   "1", "--light", "constant", "-o", folder.file("a.png")});
  EXPECT_EQ(render.status, 0);
  const std::size_t first = render.err.find("a.transfer: coarser");
  ASSERT_NE(first, std::string::npos) << render.err;
  EXPECT_EQ(render.err.find("a.transfer: coarser", first + 1), std::string::npos) << render.err;
  std::vector<std::string> strict = relight;
  strict.emplace_back("--strict");
  EXPECT_EQ(run_prt(strict).status, 2);
  EXPECT_TRUE(nlohmann::json::parse(run_prt({"info", file}).out).at("complete") == false);
}

TEST(Tool, EstimatesWithoutBaking) {
  const Finished run = run_prt({"bake", "demo", "--estimate", "--kind", "interreflected"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  for (const char* key : {"seconds", "first_pass_seconds", "seconds_a_bounce", "rays", "bytes", "form_factor_bytes"}) {
    EXPECT_GT(json[key].get<double>(), 0.0) << key;
  }
  EXPECT_EQ(run_prt({"bake", "demo"}).status, 2);
}

}  // namespace
}  // namespace sh::prt::test
