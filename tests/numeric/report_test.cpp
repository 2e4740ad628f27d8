// shcheck report and advise: the JSON is complete, the front is the front, advice is the cheapest method that is good
// enough.
#include "numeric/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "numeric/report/advise.hpp"
#include "numeric/report/figures.hpp"
#include "tests/message_of.hpp"
#include "tests/numeric/shcheck_tool.hpp"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using sh::numeric::Need;
using sh::numeric::Point;

// One quick report for all tests that read it.
class Report : public sh::test::ShcheckTool {
 protected:
  static void SetUpTestSuite() {
    report_ = sh::numeric::make_report({.quick = true, .task = {}});
    text_ = sh::numeric::report_json(report_);
    json_ = json::parse(text_);
  }

  [[nodiscard]] std::string file() const {
    auto name = folder_ / "report.json";
    std::ofstream(name) << text_;
    return name;
  }

  static inline sh::numeric::Report report_;
  static inline std::string text_;
  static inline json json_;
};

double error_of(const json& point) {
  return point.at("error").is_null() ? std::numeric_limits<double>::infinity() : point.at("error").get<double>();
}

TEST_F(Report, HasEveryTaskInFloatAndDouble) {
  std::set<std::pair<std::string, std::string>> seen;
  std::set<json> methods;
  for (const auto& p : json_.at("points")) {
    seen.insert({p.at("task").get<std::string>(), p.at("scalar").get<std::string>()});
    EXPECT_TRUE(
        methods.insert(json::array({p.at("task"), p.at("degree"), p.at("method"), p.at("scalar"), p.at("mode")}))
            .second)
        << p << " is there twice";
  }
  for (const auto& task : sh::numeric::all_tasks()) {
    EXPECT_TRUE(seen.contains({task.id, "float"})) << task.id;
    EXPECT_TRUE(seen.contains({task.id, "double"})) << task.id;
  }
  EXPECT_EQ(json_.at("format"), "shforge report 1");
  EXPECT_FALSE(json_.at("machine").get<std::string>().empty());
  EXPECT_FALSE(json_.at("convergence").empty());
  EXPECT_FALSE(json_.at("claims").empty());
}

TEST_F(Report, HasPositiveErrorsAndTimesAndSaysWhereAndHow) {
  for (const auto& p : json_.at("points")) {
    EXPECT_GT(error_of(p), 0) << p;
    EXPECT_GT(p.at("ns"), 0) << p;
    EXPECT_GT(p.at("inputs"), 0) << p;
    for (const char* key : {"unit", "header", "call", "source"}) EXPECT_NE(p.at(key), "") << key << " of " << p;
    EXPECT_NE(p.at("worst").at("input"), "") << p;
    EXPECT_NE(p.at("worst").at("output"), "") << p;
    EXPECT_TRUE(fs::exists(fs::path(SHFORGE_SOURCE_DIR) / p.at("header").get<std::string>())) << p;
  }
}

TEST_F(Report, GeneratedKernelsErrByFarLessThanTheirTypeAllows) {
  for (const auto& p : json_.at("points")) {
    if (!p.at("header").get<std::string>().starts_with("generated/")) continue;
    EXPECT_LT(error_of(p), p.at("scalar") == "float" ? 2e-5 : 4e-14) << p;
  }
}

TEST_F(Report, MarksExactlyWhatNothingBeats) {
  for (const auto& p : json_.at("points")) {
    bool beaten = false;
    for (const auto& q : json_.at("points")) {
      if (p.at("task") != q.at("task") || p.at("degree") != q.at("degree") || p.at("mode") != q.at("mode")) continue;
      const bool no_worse = q.at("ns") <= p.at("ns") && error_of(q) <= error_of(p);
      beaten = beaten || (no_worse && (q.at("ns") < p.at("ns") || error_of(q) < error_of(p)));
    }
    EXPECT_EQ(p.at("on_front"), !beaten && !p.at("error").is_null()) << p;
  }
}

TEST_F(Report, IsReadBackAsItWasWritten) {
  const auto points = sh::numeric::read_report(file());
  ASSERT_EQ(points.size(), report_.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].info.call, report_.points[i].info.call);
    EXPECT_EQ(points[i].info.mode, report_.points[i].info.mode);
    EXPECT_EQ(points[i].nanoseconds, report_.points[i].nanoseconds);
    EXPECT_EQ(points[i].on_front, report_.points[i].on_front);
  }
}

// What the reader says of these bytes.
std::string refusal(const std::string& file, const json& report) {
  std::ofstream(file) << report;
  try {
    (void)sh::numeric::read_report(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST_F(Report, IsRefusedWithCountsThatAreNotWhole) {
  for (const char* key : {"degree", "inputs"}) {
    for (const json& value : {json(2.5), json(-1), json(1e300)}) {
      json changed = json_;
      changed.at("points").at(0).at(key) = value;
      const std::string said = refusal(file(), changed);
      EXPECT_NE(said.find(std::string("'") + key + "': expected a whole number from 0 to"), std::string::npos) << said;
    }
  }
}

TEST_F(Report, IsRefusedWithoutAnyOfItsEntries) {
  const json point = json_.at("points").at(0);
  for (const auto& [key, value] : point.items()) {
    json changed = json_;
    changed.at("points").at(0).erase(key);
    const std::string said = refusal(file(), changed);
    EXPECT_NE(said.find("key '" + key + "' not found"), std::string::npos) << said;
  }
}

TEST_F(Report, PageStandsAloneAndShowsEveryMethodOfEveryTask) {
  const auto page = report_page(report_);
  for (const char* outside : {"http://", "https://", "src=", "<link", "@import", "<script"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(page.find("nan"), std::string::npos);
  for (const auto& task : report_.tasks) {
    EXPECT_NE(page.find("<section id=\"" + task.id + "\">"), std::string::npos) << task.id;
    for (const auto& chart : task_figure(task, report_.points).charts) {
      EXPECT_NE(page.find(">" + chart.title + "</text>"), std::string::npos) << chart.title;
    }
  }
  for (const auto& p : report_.points) EXPECT_NE(page.find(p.info.name), std::string::npos) << p.info.name;
}

// Every need of the tasks, the degrees of the quick report, some errors, types and modes.
std::vector<Need> needs(const std::vector<sh::numeric::Task>& tasks) {
  std::vector<Need> all;
  for (const auto& task : tasks) {
    for (const int degree : task.quick) {
      for (const double error : {1e-3, 1e-6, 3e-7, 1e-12, 1e-15, 1e-30}) {
        for (const char* scalar : {"", "float", "double"}) {
          for (const bool batch : {false, true}) all.push_back({task.id, degree, error, scalar, batch});
        }
      }
    }
  }
  return all;
}

// By brute force: whether any allowed point is exact enough and faster than the choice.
TEST_F(Report, AdviceIsTheCheapestThatIsExactEnoughAndOtherwiseTheMostExact) {
  for (const Need& need : needs(report_.tasks)) {
    const auto advice = advise(report_.points, need);
    const Point& choice = advice.choice;
    for (const auto& p : report_.points) {
      if (p.info.task != need.task || p.info.degree != need.degree) continue;
      if (!need.scalar.empty() && p.info.scalar != need.scalar) continue;
      if (p.info.mode == sh::numeric::Mode::kPrepared) continue;
      if (!need.batch && p.info.mode == sh::numeric::Mode::kBatch) continue;
      EXPECT_TRUE(advice.good_enough || p.error > need.error) << p.info.name;
      // A double that is as fast as the chosen float does not count.
      const bool same = choice.info.scalar == "float" && p.info.scalar == "double";
      const double time = p.nanoseconds * (same ? sh::numeric::kSameTime : 1);
      const bool faster_and_enough = time < choice.nanoseconds && p.error <= need.error;
      EXPECT_FALSE(advice.good_enough ? faster_and_enough : p.error < choice.error) << p.info.name;
    }
    EXPECT_EQ(advice.good_enough, choice.error <= need.error);
    EXPECT_TRUE(!need.scalar.empty() || need.batch || choice.on_front || choice.info.scalar == "float")
        << choice.info.name;
    if (advice.cheaper) {
      EXPECT_LT(advice.cheaper->nanoseconds, choice.nanoseconds);
      EXPECT_GT(advice.cheaper->error, choice.error);
    }
    if (advice.more_exact) {
      EXPECT_GT(advice.more_exact->nanoseconds, choice.nanoseconds);
      EXPECT_LT(advice.more_exact->error, choice.error);
    }
  }
}

TEST(ReportAdvice, NamesItsNeighborsOnTheFront) {
  std::vector<sh::numeric::Point> points(6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].info.task = "basis";
    points[i].info.degree = 1;
    points[i].nanoseconds = static_cast<double>(1 + i);
    points[i].error = std::pow(10.0, -static_cast<double>(2 * i));
  }
  const auto advice = advise(points, {.task = "basis", .degree = 1, .error = 1e-5, .scalar = {}});
  EXPECT_EQ(advice.choice.nanoseconds, 4);
  ASSERT_TRUE(advice.cheaper && advice.more_exact);
  EXPECT_EQ(advice.cheaper->nanoseconds, 3);
  EXPECT_EQ(advice.more_exact->nanoseconds, 5);
}

TEST(ReportAdvice, PrefersFloatWhereItIsExactEnoughAndAsFast) {
  std::vector<sh::numeric::Point> points(2);
  for (auto& point : points) {
    point.info.task = "basis";
    point.info.degree = 1;
  }
  points[0].info.scalar = "double";
  points[0].nanoseconds = 10;
  points[0].error = 1e-16;
  points[1].info.scalar = "float";
  points[1].nanoseconds = 10.5;
  points[1].error = 1e-7;
  const auto chosen = [&](double error, const char* scalar) {
    return advise(points, {.task = "basis", .degree = 1, .error = error, .scalar = scalar}).choice.info.scalar;
  };
  EXPECT_EQ(chosen(1e-5, ""), "float");
  EXPECT_EQ(chosen(1e-5, "double"), "double");
  EXPECT_EQ(chosen(1e-8, ""), "double");
  points[1].nanoseconds = 12;
  EXPECT_EQ(chosen(1e-5, ""), "double");
}

TEST(ReportAdvice, GuidesBeyondTheLastDegreeOfEveryTask) {
  for (const auto& task : sh::numeric::all_tasks()) {
    const int beyond = task.full.back() + 1;
    const std::string message =
        sh::test::message_of([&] { sh::numeric::measure_for({.task = task.id, .degree = beyond, .error = 1e-5}); });
    const std::string start = fmt::format("--degree: expected 1 to {}, got {}; ", beyond - 1, beyond);
    EXPECT_TRUE(message.starts_with(start)) << message;
    EXPECT_GT(message.size(), start.size() + 20) << message;
  }
}

TEST_F(Report, AdviceSaysWhenBatchesEnd) {
  const auto none = run("advise --error 1e-5 --degree 4 --task irradiance --batch --report " + file());
  EXPECT_NE(none.out.find("batch       none; this task has no batches"), std::string::npos) << none.out;
  const auto ended = run("advise --error 1e-5 --degree 30 --task rotate --batch --report " + file());
  EXPECT_NE(ended.out.find("batch       none; batches of this task end at degree 10"), std::string::npos) << ended.out;
  const auto some = run("advise --error 1e-5 --degree 4 --task rotate --batch --report " + file());
  EXPECT_EQ(some.out.find("batch       none"), std::string::npos) << some.out;
}

TEST_F(Report, AdviceNamesTheKernelItsErrorAndItsNeighbors) {
  const auto outcome = run("advise --error 1e-5 --degree 4 --task rotate --report " + file());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"#include \"generated/", "error", "time", "leaves out", "cheaper", "more exact"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(run("advise --error 1e-30 --degree 4 --task rotate --report " + file()).exit_code, 1);
}

TEST_F(Report, AdviceIsMeasuredOnTheSpotWithoutAFile) {
  const auto outcome = run("advise --error 1e-5 --degree 3 --task zonal");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("sh::zonal"), std::string::npos) << outcome.out;
}

TEST_F(Report, RefusesBadInputInALineThatSaysWhatIsRight) {
  expect_refused("advise --error 1e-5 --degree 4 --task rotation", "--task: expected one of basis, gradient");
  expect_refused("advise --error -1 --degree 4 --task rotate", "--error");
  expect_refused("advise --error nan --degree 4 --task rotate", "--error");
  expect_refused("advise --error 1e-5 --degree 11 --task basis", "--degree: expected 1 to 10, got");
  expect_refused("advise --error 1e-5 --degree -1 --task basis", "--degree: expected 1 to 10, got");
  expect_refused("advise --error 1e-5 --degree 4 --task rotate --scalar half",
                 "--scalar: expected float or double, got 'half'");
  expect_refused("advise --error 1e-5 --degree 5 --task rotate --report " + file(),
                 "expected one of 2, 4, 6, 9, 30 for 'rotate', got 5");
  expect_refused("advise --error 1e-5 --degree 4 --task rotate --report " + (folder_ / "none.json").string(),
                 "none.json");
  expect_refused("report --out " + folder_.string() + " --task rotation", "--task: expected one of basis, gradient");
  expect_refused("report --out " + file() + "/below --quick", "--out");
  std::ofstream(folder_ / "bad.json") << R"({"format": "shforge report 1", "points": [{"task": 3}]})";
  expect_refused("advise --error 1e-5 --degree 4 --task rotate --report " + (folder_ / "bad.json").string(),
                 "bad.json");
}

TEST_F(Report, OfOneTaskIsWrittenAndNamed) {
  const auto out = folder_ / "report";
  const auto outcome = run("report --quick --task zonal --out " + out.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, (out / "report.html").string() + "\n");
  EXPECT_TRUE(sh::test::read(out / "report.html").ends_with("</html>\n"));
  const json report = json::parse(sh::test::read(out / "report.json"));
  EXPECT_FALSE(report.at("points").empty());
  for (const auto& p : report.at("points")) EXPECT_EQ(p.at("task"), "zonal");
}

TEST_F(Report, InterruptedLeavesNoFile) {
  const auto out = folder_ / "report";
  const std::string said = (folder_ / "stderr").string();
  // As a job of its own, since a shell lets other background processes ignore the signal; once it has begun.
  std::ofstream(folder_ / "run.sh") << "set -m\n" SHFORGE_BIN_DIR "/shcheck report --out " << out.string() << " 2>"
                                    << said << " &\nuntil [ -s " << said
                                    << " ]; do sleep 0.02; done\nkill -INT $!\nwait $!\n";
  const std::string command = "bash " + (folder_ / "run.sh").string();
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a fixed command line
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(!fs::exists(out) || fs::is_empty(out));
  EXPECT_NE(sh::test::read(folder_ / "stderr").find("interrupted"), std::string::npos);
}

}  // namespace
