#include "codegen/measure/search.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "codegen/measure/arithmetic.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/measure.hpp"
#include "numeric/sampling/worst_input.hpp"

namespace sh::codegen {
namespace {

using numeric::Wide;

constexpr int kClimbs = 4;
constexpr double kLeastInput = 1e-30;  // far from subnormal numbers; a search replaces smaller inputs by 0

double narrow(double value) { return value; }
double narrow(Wide value) { return value.high(); }

// The largest error of all outputs in epsilon x size.
template <class T>
class DistanceFromFormula {
 public:
  using Reference = typename Arithmetic<T>::Reference;

  DistanceFromFormula(const Kernel& kernel, const Domain& domain)
      : kernel_(kernel),
        size_(size_of(kernel, domain)),
        rounded_(Arithmetic<T>::rounded(kernel)),
        formula_(Arithmetic<T>::formula(kernel)) {}

  double operator()(const typename Arithmetic<T>::Moved* input, std::size_t count) {
    in_.assign(input, input + count);
    rounded_in_.clear();
    formula_in_.clear();
    for (const double value : in_) {
      rounded_in_.push_back(static_cast<T>(value));
      formula_in_.push_back(Reference(value));
    }
    const std::vector<T> computed = rounded_(rounded_in_);
    const std::vector<Reference> exact = formula_(formula_in_);
    double most = 0;
    for (std::size_t i = 0; i < computed.size(); ++i) {
      const double error = std::abs(narrow(Reference(static_cast<double>(computed[i])) - exact[i]));
      if (error == 0) continue;
      const double size = size_(in_, static_cast<std::size_t>(kernel_.element(i)));
      if (size > kLeastSize) most = std::max(most, error / (size * Arithmetic<T>::kEpsilon));
    }
    return most;
  }

 private:
  static constexpr double kLeastSize = 1e-30;  // below it, products of float lose digits whatever the kernel does

  const Kernel& kernel_;
  Size size_;
  Evaluator<T> rounded_;
  Evaluator<Reference> formula_;
  std::vector<double> in_;
  std::vector<T> rounded_in_;
  std::vector<Reference> formula_in_;
};

using WideVector = std::vector<Wide>;

void scale_to_length_one(WideVector& v, std::size_t first, std::size_t size) {
  Wide square(0);
  for (std::size_t i = first; i < first + size; ++i) square = square + v[i] * v[i];
  const Wide length = sqrt(square);
  for (std::size_t i = first; i < first + size; ++i) v[i] = v[i] / length;
}

// Gram-Schmidt on the rows; the third row is the cross product of the others.
void make_rotation(WideVector& v, std::size_t r) {
  scale_to_length_one(v, r, 3);
  const Wide along = v[r] * v[r + 3] + v[r + 1] * v[r + 4] + v[r + 2] * v[r + 5];
  for (std::size_t i = 0; i < 3; ++i) v[r + 3 + i] = v[r + 3 + i] - along * v[r + i];
  scale_to_length_one(v, r + 3, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3, n = (i + 2) % 3;
    v[r + 6 + i] = v[r + k] * v[r + 3 + n] - v[r + n] * v[r + 3 + k];
  }
}

void move_to_domain(const std::vector<Parameter>& parameters, WideVector& input) {
  std::size_t first = 0;
  for (const Parameter& parameter : parameters) {
    if (parameter.role == Role::kDirection && parameter.axis == 0) scale_to_length_one(input, first, 3);
    if (parameter.role == Role::kQuaternion) scale_to_length_one(input, first, 4);
    if (parameter.role == Role::kCosine) scale_to_length_one(input, first, 2);
    if (parameter.role == Role::kRotationMatrix) make_rotation(input, first);
    first += parameter.size();
  }
}

// Inputs that half precision can hold and multiply: vectors of length 1, no caps below 2^-13, and zeros for coefficients
// below 1/16.
void move_to_half_range(const std::vector<Parameter>& parameters, WideVector& input) {
  constexpr double kLeastCap = 0x1p-13, kLeast = 0x1p-4;
  std::size_t first = 0;
  for (const Parameter& parameter : parameters) {
    if (parameter.role == Role::kVector && parameter.axis == 0) scale_to_length_one(input, first, 3);
    if (parameter.role == Role::kCapSize && input[first].high() < kLeastCap) input[first] = Wide(kLeastCap);
    const bool coefficients = !is_coordinate(parameter.role) && parameter.role != Role::kCapSize &&
                              parameter.role != Role::kParameter && parameter.role != Role::kSine &&
                              parameter.role != Role::kCosine && parameter.role != Role::kQuaternion &&
                              parameter.role != Role::kRotationMatrix;
    for (std::size_t i = first; coefficients && i < first + parameter.size(); ++i) {
      if (std::abs(input[i].high()) < kLeast) input[i] = Wide(0);
    }
    first += parameter.size();
  }
}

// An array of coefficients among the inputs.
struct Array {
  std::size_t first = 0;
  std::size_t size = 0;
  double largest = 0;  // tested length
};

double length_of(const double* first, std::size_t size) { return length(std::span(first, size)); }

// The least and the largest tested value of every input, and the largest tested lengths of arrays.
struct Range {
  std::vector<double> least, largest;
  std::vector<Array> arrays;

  Range(const std::vector<Parameter>& parameters, const std::vector<std::vector<double>>& inputs)
      : least(inputs[0]), largest(inputs[0]) {
    std::size_t first = 0;
    for (const Parameter& parameter : parameters) {
      // Each channel has a length of its own.
      const auto size = static_cast<std::size_t>(parameter.size() / parameter.channels());
      for (int channel = 0; channel < parameter.channels(); ++channel, first += size) {
        if (holds_coefficients(parameter.role)) arrays.push_back({first, size});
      }
    }
    for (const std::vector<double>& input : inputs) add(input);
  }

  // Keeps every value and every length in its range.
  void clamp(std::vector<double>& input) const {
    for (std::size_t i = 0; i < input.size(); ++i) input[i] = std::clamp(input[i], least[i], largest[i]);
    for (const Array& array : arrays) {
      const double present = length_of(input.data() + array.first, array.size);
      if (present <= array.largest) continue;
      for (std::size_t i = array.first; i < array.first + array.size; ++i) input[i] *= array.largest / present;
    }
  }

 private:
  void add(const std::vector<double>& input) {
    for (std::size_t i = 0; i < input.size(); ++i) {
      least[i] = std::min(least[i], input[i]);
      largest[i] = std::max(largest[i], input[i]);
    }
    for (Array& array : arrays) {
      array.largest = std::max(array.largest, length_of(input.data() + array.first, array.size));
    }
  }
};

// Numbers that only make sense together stay as they are.
std::vector<bool> fixed_inputs(const Kernel& kernel) {
  std::vector<bool> fixed;
  for (const Parameter& parameter : kernel.parameters) {
    const bool together = parameter.role == Role::kBandMatrices || parameter.role == Role::kPolynomial ||
                          parameter.role == Role::kMoments;
    fixed.insert(fixed.end(), parameter.size(), together && kernel.parameters[0].name == parameter.name);
  }
  return fixed;
}

template <class T, class Moved>
bool to_domain(const Kernel& kernel, const Range& range, Moved* input) {
  std::vector<double> clamped(input, input + range.least.size());
  range.clamp(clamped);
  WideVector moved;
  for (const double value : clamped) moved.emplace_back(value);
  if (!Arithmetic<T>::kWideRange) move_to_half_range(kernel.parameters, moved);
  move_to_domain(kernel.parameters, moved);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    input[i] = static_cast<Moved>(static_cast<double>(static_cast<T>(moved[i].high())));
    if (!std::isfinite(input[i])) return false;
    if (std::abs(static_cast<double>(input[i])) < kLeastInput) input[i] = 0;
  }
  return true;
}

}  // namespace

template <class T>
std::vector<std::vector<double>> search_inputs(const Kernel& kernel, const Domain& domain,
                                               const std::vector<std::vector<double>>& starts, int evaluations) {
  using Moved = typename Arithmetic<T>::Moved;
  std::vector<std::vector<double>> inputs = domain.test_inputs(kernel.degree);
  const Range range(kernel.parameters, inputs);
  for (const std::vector<double>& start : starts) {
    if (!start.empty()) inputs.push_back(start);
  }
  std::vector<std::vector<Moved>> points;
  for (const std::vector<double>& input : inputs) {
    points.emplace_back();
    for (const double value : input) {
      points.back().push_back(static_cast<Moved>(static_cast<double>(static_cast<T>(value))));
    }
  }
  const std::size_t count = points[0].size();
  DistanceFromFormula<T> distance(kernel, domain);
  numeric::SearchProblem<Moved> problem;
  problem.error = [&](const Moved* input) { return distance(input, count); };
  problem.to_domain = [&](Moved* input) { return to_domain<T>(kernel, range, input); };
  problem.fixed = fixed_inputs(kernel);
  std::vector<std::vector<double>> found;
  for (const auto& [input, error] :
       numeric::worst_inputs(problem, points, {kClimbs, static_cast<std::size_t>(evaluations), 1})) {
    found.emplace_back(input.begin(), input.end());
  }
  return found;
}

int search_evaluations(const Kernel& kernel) {
  constexpr std::size_t kLarge = 1000;
  return kernel.nodes.size() > kLarge ? 250 : 2000;
}

namespace {

// The domain with inputs in the range of half precision.
Domain in_half_range(const Domain& domain, const Kernel& kernel) {
  Domain narrow = domain;
  narrow.test_inputs = [&kernel, all = domain.test_inputs](int degree) {
    std::vector<std::vector<double>> inputs = all(degree);
    const Range range(kernel.parameters, inputs);
    for (std::vector<double>& input : inputs) to_domain<Half>(kernel, range, input.data());
    return inputs;
  };
  return narrow;
}

}  // namespace

template <>
SeenError largest_seen<Half>(const Kernel& kernel, const Domain& domain, const std::vector<std::vector<double>>& starts,
                             int evaluations) {
  const Domain narrow = in_half_range(domain, kernel);
  return {measure<Half>(kernel, narrow, search_inputs<Half>(kernel, narrow, starts, evaluations)),
          kClimbs * evaluations};
}

template <class T>
SeenError largest_seen(const Kernel& kernel, const Domain& domain, const std::vector<std::vector<double>>& starts,
                       int evaluations) {
  return {measure<T>(kernel, domain, search_inputs<T>(kernel, domain, starts, evaluations)), kClimbs * evaluations};
}

using Inputs = std::vector<std::vector<double>>;
template Inputs search_inputs<float>(const Kernel&, const Domain&, const Inputs&, int);
template Inputs search_inputs<double>(const Kernel&, const Domain&, const Inputs&, int);
template Inputs search_inputs<Half>(const Kernel&, const Domain&, const Inputs&, int);
template SeenError largest_seen<float>(const Kernel&, const Domain&, const Inputs&, int);
template SeenError largest_seen<double>(const Kernel&, const Domain&, const Inputs&, int);

}  // namespace sh::codegen
