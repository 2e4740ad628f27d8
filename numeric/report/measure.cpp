#include "numeric/report/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "numeric/report/tasks.hpp"

namespace sh::numeric {
namespace {

// High degrees take long: fewer inputs.
std::size_t most_inputs(std::size_t most, int degree) {
  constexpr int kLow = 10;
  constexpr std::size_t kLeast = 12;
  const auto cost = static_cast<std::size_t>(degree * degree);
  return degree <= kLow ? most : std::max(kLeast, most / cost);
}

bool dominates(const Point& a, const Point& b) {
  return a.nanoseconds <= b.nanoseconds && a.error <= b.error && (a.nanoseconds < b.nanoseconds || a.error < b.error);
}

bool same_front(const MethodInfo& a, const MethodInfo& b) {
  return a.task == b.task && a.degree == b.degree && a.mode == b.mode;
}

// The samples of each check and degree, made once.
template <class T>
using Cache = std::map<std::pair<std::string, int>, Samples<T>>;

template <class T>
const Samples<T>& samples_of(Cache<T>& cache, const FamilyCheck& check, int degree, const Effort& effort) {
  const auto found = cache.find({check.family, degree});
  if (found != cache.end()) return found->second;
  FamilyCheck tried = check;
  tried.inputs = [&](int /*degree*/) {
    auto all = check.inputs(degree);
    const std::size_t most = most_inputs(effort.most_inputs, degree);
    const std::size_t step = (all.size() + most - 1) / most;
    std::vector<NamedInput> some = effort.search ? found_inputs<T>(check, degree) : std::vector<NamedInput>{};
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(std::move(all[i]));
    return some;  // the last inputs are the random ones, which are timed
  };
  return cache.emplace(std::pair{check.family, degree}, make_samples<T>(tried, degree)).first->second;
}

template <class T>
Point point_of(const Method& method, const Code<T>& code, const Samples<T>& samples, std::chrono::nanoseconds budget) {
  std::vector<T> values(samples.count() * samples.signature.output_count());
  code.run(samples, values.data());
  const auto errors = errors_of(samples, values, samples.exact);
  const bool relative = find_task("", method.info.task).relative;
  const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  return {.info = method.info,
          .nanoseconds = code.time(samples, budget),
          .error = relative ? errors.scaled().max() * epsilon : errors.absolute().max(),
          .error_eps = errors.scaled().max(),
          .unit = method.check.unit,
          .inputs = samples.count(),
          .worst = worst_case((relative ? errors.scaled() : errors.absolute()).worst(), method.info.degree, samples)};
}

}  // namespace

std::vector<Method> methods_of(const std::string& task, int degree) {
  std::vector<Method> all;
  add_kernel_methods(all, task, degree);
  add_batch_methods(all, task, degree);
  add_table_methods(all, task, degree);
  add_textbook_methods(all, task, degree);
  return all;
}

std::vector<Point> measure(const std::vector<Method>& methods, const Effort& effort,
                           const std::function<void()>& step) {
  std::pair<Cache<float>, Cache<double>> caches;
  std::vector<Point> points;
  for (const Method& method : methods) {
    const auto measured = [&]<class T>(const Code<T>& code) {
      const auto& samples = samples_of(std::get<Cache<T>>(caches), method.check, method.info.degree, effort);
      return point_of(method, code, samples, effort.budget);
    };
    points.push_back(std::visit(measured, method.code));
    step();
  }
  for (auto& point : points) {
    point.on_front = std::isfinite(point.error) && std::none_of(points.begin(), points.end(), [&](const Point& other) {
                       return same_front(point.info, other.info) && dominates(other, point);
                     });
  }
  return points;
}

}  // namespace sh::numeric
