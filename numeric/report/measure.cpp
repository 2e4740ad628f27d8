#include "numeric/report/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

}  // namespace

template <class T>
const Samples<T>& Measurer::samples_of(const FamilyCheck& check, int degree) {
  auto& cache = std::get<Cache<T>>(samples_);
  const auto found = cache.find({check.family, degree});
  if (found != cache.end()) return found->second;
  FamilyCheck tried = check;
  tried.inputs = [&](int /*degree*/) {
    auto all = check.inputs(degree);
    const std::size_t most = most_inputs(effort_.most_inputs, degree);
    const std::size_t step = (all.size() + most - 1) / most;
    std::vector<NamedInput> some = effort_.search ? found_inputs<T>(check, degree) : std::vector<NamedInput>{};
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(std::move(all[i]));
    return some;  // the last inputs are the random ones, which are timed
  };
  return cache.emplace(std::pair{check.family, degree}, make_samples<T>(tried, degree)).first->second;
}

template <class T>
Point Measurer::measure(const Method& method, const Code<T>& code, bool relative) {
  const int degree = method.info.degree;
  const Samples<T>& samples = samples_of<T>(method.check, degree);
  std::vector<T> values(samples.count() * static_cast<std::size_t>(samples.signature.output_count()));
  code.run(samples, values.data());
  const auto errors = errors_of(samples, values, samples.exact);
  const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  return {.info = method.info,
          .nanoseconds = code.time(samples, effort_.budget),
          .error = relative ? errors.scaled().max() * epsilon : errors.absolute().max(),
          .error_eps = errors.scaled().max(),
          .unit = method.check.unit,
          .inputs = samples.count(),
          .worst = worst_case((relative ? errors.scaled() : errors.absolute()).worst(), degree, samples),
          .on_front = false};
}

Point Measurer::measure(const Method& method, bool relative) {
  return std::visit([&](const auto& code) { return measure(method, code, relative); }, method.code);
}

std::vector<Method> methods_of(const std::string& task, int degree) {
  std::vector<Method> all;
  add_kernel_methods(all, task, degree);
  add_batch_methods(all, task, degree);
  add_table_methods(all, task, degree);
  add_textbook_methods(all, task, degree);
  return all;
}

void mark_front(std::vector<Point>& points) {
  for (auto& point : points) {
    point.on_front = std::isfinite(point.error) && std::none_of(points.begin(), points.end(), [&](const Point& other) {
                       return same_front(point.info, other.info) && dominates(other, point);
                     });
  }
}

}  // namespace sh::numeric
