// See kernel_search.hpp.
#include "numeric/kernels/kernel_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "numeric/kernels/flat_call.hpp"

namespace sh::numeric {
namespace {

// The largest |K_T(x) - K_Wide(x)| in epsilon x the check's size, where the size is far from underflow: below, products
// lose digits whatever the kernel does, and the search would find nothing else.
template <class T>
class DistanceFromWide {
 public:
  DistanceFromWide(const BoundKernel& kernel, const FamilyCheck& check)
      : degree_(kernel.degree),
        size_(check.size),
        call_(kernel, check.signature(degree_)),
        wide_call_(kernel, check.signature(degree_)),
        wide_in_(check.signature(degree_).input_count()),
        in_(wide_in_.size()),
        out_(check.signature(degree_).output_count()),
        wide_out_(out_.size()) {}

  double operator()(const T* in) {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      in_[i] = static_cast<double>(in[i]);
      wide_in_[i] = Wide(in_[i]);
    }
    call_(in, out_.data());
    wide_call_(wide_in_.data(), wide_out_.data());
    double largest = 0;
    for (std::size_t i = 0; i < out_.size(); ++i) {
      const double error = std::abs((Wide(static_cast<double>(out_[i])) - wide_out_[i]).high());
      if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
      const double size = error == 0 ? 0 : size_(degree_, in_.data(), i);
      if (size < kLeastSize) continue;
      largest = std::max(largest, error / (size * static_cast<double>(std::numeric_limits<T>::epsilon())));
    }
    return largest;
  }

 private:
  static constexpr double kLeastSize =
      1024 * static_cast<double>(std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon());

  int degree_;
  std::function<double(int, const double*, std::size_t)> size_;
  FlatCall<T> call_;
  FlatCall<Wide> wide_call_;
  std::vector<Wide> wide_in_;
  std::vector<double> in_;
  std::vector<T> out_;
  std::vector<Wide> wide_out_;
};

// The least and the largest that each value takes among the points.
template <class T>
struct Range {
  std::vector<T> least, largest;

  explicit Range(const std::vector<std::vector<T>>& points) : least(points[0]), largest(points[0]) {
    for (const auto& point : points) {
      for (std::size_t i = 0; i < point.size(); ++i) {
        least[i] = std::min(least[i], point[i]);
        largest[i] = std::max(largest[i], point[i]);
      }
    }
  }
  void clamp(T* point) const {
    for (std::size_t i = 0; i < least.size(); ++i) point[i] = std::clamp(point[i], least[i], largest[i]);
  }
};

// The least and the largest length of a first parameter that is a vector of any length; any length otherwise.
template <class T>
class LengthRange {
 public:
  LengthRange(const std::vector<std::vector<T>>& points, const FamilyCheck& check, int degree)
      : any_(check.signature(degree).parameters[0].role != "vector") {
    if (any_) return;
    for (const auto& point : points) {
      least_ = std::min(least_, length(point.data()));
      largest_ = std::max(largest_, length(point.data()));
    }
  }
  [[nodiscard]] bool contains(const T* point) const {
    return any_ || (length(point) >= least_ && length(point) <= largest_);
  }

 private:
  static long double length(const T* v) {
    return std::hypot(static_cast<long double>(v[0]), static_cast<long double>(v[1]), static_cast<long double>(v[2]));
  }

  bool any_;
  long double least_ = std::numeric_limits<long double>::infinity();
  long double largest_ = 0;
};

// Makes a 3x3 matrix, row by row, a rotation: the first row keeps its direction, the second its plane with the first.
void orthogonalize(long double* r) {
  const auto dot = [&](int i, int k) { return r[i] * r[k] + r[i + 1] * r[k + 1] + r[i + 2] * r[k + 2]; };
  const long double first = std::sqrt(dot(0, 0));
  for (int i = 0; i < 3; ++i) r[i] /= first;
  const long double along = dot(0, 3);
  for (int i = 0; i < 3; ++i) r[3 + i] -= along * r[i];
  const long double second = std::sqrt(dot(3, 3));
  for (int i = 3; i < 6; ++i) r[i] /= second;
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, n = (i + 2) % 3;
    r[6 + i] = r[k] * r[3 + n] - r[n] * r[3 + k];
  }
}

template <class T>
bool to_nearest(const FamilyCheck& check, int degree, std::size_t width, T* point) {
  std::vector<long double> given(point, point + width);
  std::vector<long double> nearest(width);
  if (check.signature(degree).parameters[0].role == "rotation matrix") orthogonalize(given.data());
  try {
    check.nearest(degree, given.data(), nearest.data());
  } catch (const std::invalid_argument&) {
    return false;  // a direction without length
  }
  for (std::size_t i = 0; i < width; ++i) point[i] = static_cast<T>(nearest[i]);
  return std::all_of(point, point + width, [](T value) { return std::isfinite(value); });
}

// Inputs that only make sense together stay as they were computed.
std::vector<bool> fixed_inputs(const FamilyCheck& check, int degree) {
  std::vector<bool> fixed;
  for (const Parameter& parameter : check.signature(degree).parameters) {
    if (parameter.is_read()) fixed.insert(fixed.end(), parameter.values(), parameter.is_prepared());
  }
  return fixed;
}

}  // namespace

template <class T>
KernelResult search_kernel(const BoundKernel& kernel, const FamilyCheck& check, const SearchEffort& effort) {
  const int degree = kernel.degree;
  std::vector<std::vector<T>> starts;
  for (const auto& input : check.inputs(degree)) {
    starts.emplace_back();
    for (const double value : input.values) starts.back().push_back(static_cast<T>(value));
  }
  const std::size_t width = starts[0].size();
  const auto range = std::make_shared<Range<T>>(starts);
  const auto distance = std::make_shared<DistanceFromWide<T>>(kernel, check);
  SearchProblem<T> problem;
  problem.error = [distance](const T* in) { return (*distance)(in); };
  problem.to_domain = [&check, degree, width, range, lengths = LengthRange<T>(starts, check, degree)](T* in) {
    range->clamp(in);
    return lengths.contains(in) && (!check.nearest || to_nearest(check, degree, width, in));
  };
  problem.fixed = fixed_inputs(check, degree);
  FamilyCheck at_found = check;
  at_found.inputs = [&](int /*degree*/) {
    std::vector<NamedInput> inputs;
    for (const auto& found : worst_inputs(problem, starts, effort)) {
      inputs.push_back({"found by search", {found.input.begin(), found.input.end()}});
    }
    return inputs;
  };
  return kernel_errors<T>(kernel, at_found);
}

template KernelResult search_kernel<float>(const BoundKernel&, const FamilyCheck&, const SearchEffort&);
template KernelResult search_kernel<double>(const BoundKernel&, const FamilyCheck&, const SearchEffort&);

}  // namespace sh::numeric
