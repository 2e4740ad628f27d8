#include "numeric/report/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "numeric/oracle/require.hpp"
#include "numeric/output/progress.hpp"
#include "numeric/report/tasks.hpp"

namespace sh::numeric {
namespace {

bool is_wanted(const Point& point, const Need& need) {
  const auto& info = point.info;
  return info.task == need.task && info.degree == need.degree && std::isfinite(point.error) &&
         (need.scalar.empty() || info.scalar == need.scalar) && (need.batch || info.mode != Mode::kBatch) &&
         (need.prepared || info.mode != Mode::kPrepared);
}

// The wanted points of any mode, the fastest first.
std::vector<Point> wanted_of(const std::vector<Point>& points, const Need& need) {
  std::vector<Point> wanted;
  std::copy_if(points.begin(), points.end(), std::back_inserter(wanted),
               [&](const Point& point) { return is_wanted(point, need); });
  std::stable_sort(wanted.begin(), wanted.end(), [](const Point& a, const Point& b) {
    return a.nanoseconds < b.nanoseconds || (a.nanoseconds == b.nanoseconds && a.error < b.error);
  });
  return wanted;
}

// Those that no other beats in both time and error, from the fastest to the most exact.
std::vector<Point> front_of(const std::vector<Point>& wanted) {
  std::vector<Point> front;
  for (const Point& point : wanted) {
    if (front.empty() || point.error < front.back().error) front.push_back(point);
  }
  return front;
}

// The fastest float that is exact enough and as fast as the choice; else the choice.
Point preferring_float(const std::vector<Point>& wanted, const Point& choice, double error) {
  const auto found = std::find_if(wanted.begin(), wanted.end(), [&](const Point& point) {
    return point.info.scalar == "float" && point.error <= error;
  });
  const bool as_fast = found != wanted.end() && found->nanoseconds <= kSameTime * choice.nanoseconds;
  return as_fast ? *found : choice;
}

// The highest degree with a batch; -1: there is none.
int last_batch_of(const std::string& task) {
  constexpr int kHighest = 10;
  for (int degree = kHighest; degree >= 1; --degree) {
    for (const Method& method : methods_of(task, degree)) {
      if (method.info.mode == Mode::kBatch) return degree;
    }
  }
  return -1;
}

[[noreturn]] void fail_without_points(const std::vector<Point>& points, const Need& need) {
  std::set<int> degrees;
  for (const auto& point : points) {
    if (point.info.task == need.task) degrees.insert(point.info.degree);
  }
  if (degrees.contains(need.degree)) {
    throw std::invalid_argument(fmt::format("--scalar: expected a type that a method of '{}' has at degree {}, got {}",
                                            need.task, need.degree, need.scalar));
  }
  if (degrees.empty())
    throw std::invalid_argument(fmt::format("--task: expected a measured task, got '{}'", need.task));
  const std::string beyond = need.degree > *degrees.rbegin() ? "; " + find_task("--task", need.task).beyond : "";
  throw std::invalid_argument(fmt::format("--degree: expected one of {} for '{}', got {}{}", fmt::join(degrees, ", "),
                                          need.task, need.degree, beyond));
}

std::string brief(const Point& point) {
  return fmt::format("{}, {}: error {:.2g}, {:.3g} ns", point.info.name, point.info.scalar, point.error,
                     point.nanoseconds);
}

const char* time_of(Mode mode) {
  return mode == Mode::kOne        ? "a call"
         : mode == Mode::kPrepared ? "a call, without what is prepared"
                                   : "a record of a batch";
}

}  // namespace

Advice advise(const std::vector<Point>& points, const Need& need) {
  const auto wanted = wanted_of(points, need);
  const auto front = front_of(wanted);
  if (front.empty()) fail_without_points(points, need);
  const auto found =
      std::find_if(front.begin(), front.end(), [&](const Point& point) { return point.error <= need.error; });
  const bool good_enough = found != front.end();
  Advice advice{.choice = good_enough ? *found : front.back(), .good_enough = good_enough};
  if (good_enough) advice.choice = preferring_float(wanted, advice.choice, need.error);
  const Point& choice = advice.choice;
  for (const Point& point : front) {
    if (point.nanoseconds < choice.nanoseconds && point.error > choice.error) advice.cheaper = point;
    const bool more_exact = point.nanoseconds > choice.nanoseconds && point.error < choice.error;
    if (more_exact && !advice.more_exact) advice.more_exact = point;
  }
  const bool has_batch =
      std::any_of(wanted.begin(), wanted.end(), [](const Point& point) { return point.info.mode == Mode::kBatch; });
  if (need.batch && !has_batch) advice.last_batch = last_batch_of(need.task);
  return advice;
}

std::vector<Point> measure_for(const Need& need) {
  const auto& task = find_task("--task", need.task);
  const int last = task.full.back();
  if (need.degree > last) {
    throw std::invalid_argument(fmt::format("--degree: expected 1 to {}, got {}; {}", last, need.degree, task.beyond));
  }
  require_range("--degree", need.degree, 1, last);
  return measure(methods_of(task.id, need.degree), {.budget = std::chrono::milliseconds(5), .most_inputs = 1200},
                 output::check_interrupt);
}

std::string format_advice(const Need& need, const Advice& advice) {
  const auto& p = advice.choice;
  std::string text = fmt::format("{}, degree {}, error at most {:g}: ", need.task, need.degree, need.error);
  text += fmt::format("{}{}, {}\n", advice.good_enough ? "" : "no method is exact enough; the most exact is ",
                      p.info.name, p.info.scalar);
  text += fmt::format("  #include \"{}\"\n  {}\n", p.info.header, p.info.call);
  text += fmt::format("  error       {:.2g} ({:.2g} eps x {}), the largest of {} inputs; {} at {}\n", p.error,
                      p.error_eps, p.unit, p.inputs, p.worst.output, p.worst.input);
  text += fmt::format("  time        {:.3g} ns {}\n", p.nanoseconds, time_of(p.info.mode));
  if (advice.last_batch == -1) text += "  batch       none; this task has no batches\n";
  if (advice.last_batch.value_or(-1) > 0)
    text += fmt::format("  batch       none; batches of this task end at degree {}\n", *advice.last_batch);
  if (!p.info.leaves_out.empty()) text += fmt::format("  leaves out  {}\n", p.info.leaves_out);
  text += fmt::format("  source      {}\n", p.info.source);
  text += "  cheaper     " + (advice.cheaper ? brief(*advice.cheaper) : "none") + "\n";
  text += "  more exact  " + (advice.more_exact ? brief(*advice.more_exact) : "none") + "\n";
  return text;
}

}  // namespace sh::numeric
