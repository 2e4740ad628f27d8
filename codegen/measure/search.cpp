#include "codegen/measure/search.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "codegen/measure/arithmetic.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/first_order.hpp"
#include "codegen/measure/lanes.hpp"
#include "codegen/passes/passes.hpp"
#include "numeric/kernels/wide.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::codegen {
namespace {

using numeric::Wide;
using Inputs = std::vector<std::vector<double>>;

constexpr int kClimbs = 8;
template <class T>
constexpr std::size_t kWalks = Arithmetic<T>::kWideRange ? 0 : 2;
constexpr int kWalkLength = 8;         // climbs
constexpr double kLeastInput = 1e-30;  // far from subnormal numbers; a search replaces smaller inputs by 0
constexpr double kLeastSize = 1e-30;   // below it, products of float lose digits whatever the kernel does

template <class T>
double rounded(double value) {
  return static_cast<double>(static_cast<T>(value));
}

using WideVector = std::vector<Wide>;

void scale_to_length_one(WideVector& v, std::size_t first, std::size_t size) {
  Wide square(0);
  for (std::size_t i = first; i < first + size; ++i) square = square + v[i] * v[i];
  const Wide length = sqrt(square);
  for (std::size_t i = first; i < first + size; ++i) v[i] = v[i] / length;
}

// Whether half precision holds the vector within 2 epsilon of length 1, which every bound assumes (bound/region.hpp).
bool half_is_unit(const WideVector& v, std::size_t first, std::size_t size) {
  double square = 0;
  for (std::size_t i = first; i < first + size; ++i) square += std::pow(rounded<Half>(v[i].high()), 2);
  return std::abs(std::sqrt(square) - 1) <= 2 * Arithmetic<Half>::kEpsilon;
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

// Half precision has so few unit vectors that the nearest ones alone miss its worst roundings: others of the domain stay.
template <class T>
void move_to_domain(const std::vector<Parameter>& parameters, WideVector& input) {
  const auto make_unit = [&](std::size_t first, std::size_t size) {
    if (Arithmetic<T>::kWideRange || !half_is_unit(input, first, size)) scale_to_length_one(input, first, size);
  };
  std::size_t first = 0;
  for (const Parameter& parameter : parameters) {
    if (parameter.role == Role::kDirection && parameter.axis == 0) make_unit(first, 3);
    if (parameter.role == Role::kQuaternion) make_unit(first, 4);
    if (parameter.role == Role::kCosine) make_unit(first, 2);
    if (parameter.role == Role::kRotationMatrix) make_rotation(input, first);
    first += parameter.size();
  }
}

// Inputs that half precision can hold and multiply: vectors of length 1, no caps below 2^-13, and zeros for coefficients
// below 1/512.
void move_to_half_range(const std::vector<Parameter>& parameters, WideVector& input) {
  constexpr double kLeastCap = 0x1p-13, kLeast = 0x1p-9;
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

// The largest tested lengths of arrays of coefficients; the least and the largest tested value of every other input.
struct Range {
  std::vector<double> least, largest;
  std::vector<Array> arrays;
  std::vector<char> turning;                     // the inputs that `to_domain` changes together
  std::vector<std::size_t> still, with_turning;  // the inputs outside of arrays, without those and with them

  Range(const std::vector<Parameter>& parameters, const std::vector<std::vector<double>>& inputs)
      : least(inputs[0]), largest(inputs[0]) {
    std::size_t first = 0;
    for (const Parameter& parameter : parameters) {
      const bool coefficients = holds_coefficients(parameter.role);
      const bool turns = !coefficients && parameter.role != Role::kParameter;
      turning.insert(turning.end(), parameter.size(), turns);
      // Each channel has a length of its own.
      const auto size = static_cast<std::size_t>(parameter.size() / parameter.channels());
      for (int channel = 0; channel < parameter.channels(); ++channel, first += size) {
        if (coefficients) arrays.push_back({first, size});
        for (std::size_t i = first; i < first + size && !coefficients; ++i) {
          with_turning.push_back(i);
          if (!turns) still.push_back(i);
        }
      }
    }
    for (const std::vector<double>& input : inputs) add(input);
  }

  // Keeps every length and every other value in its range. Directions and other inputs that `to_domain` moves together
  // may stand outside of it; where none of them changed, they stay.
  void clamp(std::vector<double>& input, bool turned) const {
    for (const std::size_t i : turned ? with_turning : still) input[i] = std::clamp(input[i], least[i], largest[i]);
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
    const bool sum = position_of(kernel.results, parameter.name) >= 0;
    fixed.insert(fixed.end(), parameter.size(), is_prepared(parameter.role) && !sum);
  }
  return fixed;
}

// Moves a point to the domain, rounded; false if there is no way. Unit vectors that did not change are there already.
template <class T>
bool to_domain(const Kernel& kernel, const Range& range, std::vector<double>& input, bool turned = true) {
  range.clamp(input, turned);
  if (turned || !Arithmetic<T>::kWideRange) {
    WideVector moved(input.begin(), input.end());
    if (!Arithmetic<T>::kWideRange) move_to_half_range(kernel.parameters, moved);
    move_to_domain<T>(kernel.parameters, moved);
    std::transform(moved.begin(), moved.end(), input.begin(), [](Wide value) { return value.high(); });
  }
  bool finite = true;
  for (double& value : input) {
    value = rounded<T>(value);
    finite &= std::abs(value) <= std::numeric_limits<double>::max();
    value = std::abs(value) < kLeastInput ? 0 : value;
  }
  return finite;
}

// A point with the output whose error is looked at there, in epsilon x size.
struct Point {
  std::vector<double> input;
  std::size_t output = 0;
  double error = 0;
};

bool is_worse(const Point& a, const Point& b) { return a.error > b.error; }

// Climbs from the tested inputs: first by the first-order error, which is smooth, then by the error itself.
template <class T>
class Search {
 public:
  Search(const Kernel& kernel, const Domain& domain, const Inputs& tested, bound::Format format)
      : kernel_(passes::unroll(kernel)),
        format_(std::move(format)),
        size_(size_of(kernel, domain)),
        range_(kernel.parameters, tested),
        fixed_(fixed_inputs(kernel)) {}

  /// One input from each climb, the worst first. inputs: in the domain. starts: perhaps not.
  Inputs run(Inputs inputs, const Inputs& starts, int evaluations) {
    for (std::vector<double>& input : inputs) {
      for (double& value : input) value = rounded<T>(value);
    }
    for (std::vector<double> start : starts) {
      if (!start.empty() && to_domain<T>(kernel_, range_, start)) inputs.push_back(std::move(start));
    }
    std::vector<Point> points = peaks(inputs);
    for (Point& point : points) ascend(point);
    std::stable_sort(points.begin(), points.end(), is_worse);
    points.resize(std::min<std::size_t>(points.size(), kClimbs - 1));
    points.push_back(worst_of(inputs));
    for (Point& point : points) climb(point, evaluations);
    std::stable_sort(points.begin(), points.end(), is_worse);
    for (std::size_t i = 0; i < std::min(points.size(), kWalks<T>); ++i) walk(points[i], kWalkLength * evaluations);
    std::stable_sort(points.begin(), points.end(), is_worse);
    Inputs found;
    for (Point& point : points) found.push_back(std::move(point.input));
    return found;
  }

 private:
  static constexpr int kSteps = 40;  // of an ascent
  static constexpr double kMostVisits =
      3e7;  // of nodes: to choose starts, for each ascent, and for all but a few of them

  // The size of an output's error times epsilon; infinity where the size is too small.
  double unit(const std::vector<double>& input, std::size_t output) const {
    const double size = size_(input, static_cast<std::size_t>(kernel_.element(static_cast<int>(output))));
    return size > kLeastSize ? size * format_.epsilon() : std::numeric_limits<double>::infinity();
  }

  // The starts with the largest first-order errors, of different outputs as far as there are enough.
  std::vector<Point> peaks(const Inputs& inputs) const {
    const std::size_t outputs = kernel_.outputs.size();
    const double visits = static_cast<double>(kernel_.nodes.size()) * static_cast<double>(outputs + 1);
    const double most = std::max(kMostVisits / visits, 4.0);
    const auto step = static_cast<std::size_t>(std::ceil(static_cast<double>(inputs.size()) / most));
    FirstOrder first_order(kernel_, format_);
    std::vector<Point> points;
    // From the end: the starts beside the tested inputs stand there.
    for (std::size_t i = 0; i < inputs.size(); i += step) {
      const std::vector<double>& input = inputs[inputs.size() - 1 - i];
      first_order.move_to(input);
      for (std::size_t output = 0; output < outputs; ++output) {
        const double error = first_order.error(output) / unit(input, output);
        if (std::isfinite(error)) points.push_back({input, output, error});
      }
    }
    std::stable_sort(points.begin(), points.end(), is_worse);
    std::vector<std::size_t> taken(outputs, 0);
    const double ascent =
        kSteps * visits_of_step(static_cast<double>(kernel_.nodes.size()) / std::sqrt(static_cast<double>(outputs)),
                                inputs[0].size());
    const auto ascents = static_cast<std::size_t>(std::clamp(kMostVisits / ascent, 6.0, 48.0));
    const std::size_t most_taken = (ascents + outputs - 1) / outputs;
    std::vector<Point> chosen;
    for (Point& point : points) {
      if (chosen.size() < ascents && taken[point.output]++ < most_taken) chosen.push_back(std::move(point));
    }
    return chosen;
  }

  static double visits_of_step(double nodes, std::size_t inputs) { return 2 * nodes * static_cast<double>(inputs); }

  // The kernel of one output alone.
  Kernel part(std::size_t output) const {
    Kernel part = kernel_;
    part.outputs = {kernel_.outputs[output]};
    part.outputs[0].element = kernel_.element(static_cast<int>(output));
    return passes::prune(part);
  }

  // Gradient steps of falling length. An error that is linear in an array of coefficients but for signs has its top
  // where the array points along its gradient: the first step, which is endless.
  void ascend(Point& point) const {
    const Kernel kernel = part(point.output);
    FirstOrder first_order(kernel, format_);
    const auto error_at = [&](const std::vector<double>& input) {
      first_order.move_to(input);
      const double error = first_order.error(0) / unit(input, point.output);
      return std::isfinite(error) ? error : 0.0;
    };
    const double visits = visits_of_step(static_cast<double>(kernel.nodes.size()), point.input.size());
    point.error = error_at(point.input);
    constexpr double kLeastGain = 1.002;
    for (int left = static_cast<int>(std::min(kMostVisits / visits, double{kSteps})); left > 0; --left) {
      const std::vector<double> gradient = gradient_of(error_at, point);
      Point best = point;
      for (const double step : {1e6, 4.0, 1.0, 0.25, 0.0625, 0.015625, 0.00390625}) {
        Point next = point;
        for (std::size_t i = 0; i < gradient.size(); ++i) next.input[i] += step * gradient[i];
        if (!to_domain<T>(kernel_, range_, next.input)) continue;
        next.error = error_at(next.input);
        if (next.error > best.error) best = std::move(next);
      }
      const bool small = best.error < point.error * kLeastGain;
      point = std::move(best);
      if (small) return;
    }
  }

  // The gradient scaled to length 1, by differences.
  template <class Error>
  std::vector<double> gradient_of(const Error& error_at, const Point& point) const {
    constexpr double kStep = 1e-6;
    std::vector<double> gradient(point.input.size(), 0.0);
    std::vector<double> near = point.input;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      if (fixed_[i]) continue;
      near[i] += kStep;
      gradient[i] = error_at(near) - point.error;
      near[i] = point.input[i];
    }
    const double norm = length(gradient);
    for (double& part : gradient) part /= norm > 0 ? norm : 1;
    return gradient;
  }

  // The input with the largest error of all outputs.
  Point worst_of(const Inputs& inputs) {
    ErrorLanes<T> lanes(kernel_, format_);
    Point worst{inputs[0], 0, 0};
    for (std::size_t first = 0; first < inputs.size(); first += kLanes) {
      const std::size_t count = std::min<std::size_t>(inputs.size() - first, kLanes);
      set_lanes(std::span(inputs).subspan(first, count));
      lanes(in_lanes_);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t output = 0; output < kernel_.outputs.size(); ++output) {
          const double error = lanes.error(output, static_cast<int>(i));
          if (!(error > 0)) continue;
          const double relative = error / unit(inputs[first + i], output);
          if (relative > worst.error) worst = {inputs[first + i], output, relative};
        }
      }
    }
    return worst;
  }

  void set_lanes(std::span<const std::vector<double>> inputs) {
    std::array<const double*, kLanes> from;
    for (std::size_t lane = 0; lane < kLanes; ++lane) from[lane] = inputs[std::min(lane, inputs.size() - 1)].data();
    in_lanes_.resize(inputs[0].size());
    for (std::size_t i = 0; i < in_lanes_.size(); ++i) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) in_lanes_[i][lane] = from[lane][i];
    }
  }

  // Changes the input at random, as many ways at once as there are lanes, and goes to the worst of them.
  void climb(Point& point, int evaluations) {
    const Kernel kernel = part(point.output);
    ErrorLanes<T> lanes(kernel, format_);
    point.error = 0;
    for (int done = 0; done < evaluations; done += kLanes) look_around(point, lanes, done == 0);
  }

  // Leaves the top of a climb, where every small change is a loss: goes to the worst neighbor if its error is not much
  // less, and keeps the worst input on the way. What counts as not much goes to 0.
  // Reference: G. Dueck and T. Scheuer, "Threshold accepting", Journal of Computational Physics 90 (1990) 161.
  void walk(Point& point, int evaluations) {
    constexpr double kLoss = 0.3;  // at the start, of the error
    const Kernel kernel = part(point.output);
    ErrorLanes<T> lanes(kernel, format_);
    Point present = point;
    for (int done = 0; done < evaluations; done += kLanes) {
      const double left = 1 - static_cast<double>(done) / evaluations;
      Point next = present;
      next.error *= 1 - kLoss * left * left;
      look_around(next, lanes, false);
      if (next.input != present.input) present = std::move(next);
      if (present.error > point.error) point = present;
    }
  }

  // Goes to the worst neighbor of a point if its error is larger than that of the point. with_itself: one neighbor is the
  // input of the point.
  void look_around(Point& point, ErrorLanes<T>& lanes, bool with_itself) {
    near_.assign(kLanes, point.input);
    for (int lane = with_itself ? 1 : 0; lane < kLanes; ++lane) {
      if (!change(near_[lane])) near_[lane] = point.input;
    }
    set_lanes(near_);
    lanes(in_lanes_);
    const double about = unit(point.input, point.output);
    int worst = -1;
    for (int lane = 0; lane < kLanes; ++lane) {
      // The size changes little, and most changes are no gain: the unit is needed for few.
      constexpr double kPart = 0.9;
      const double error = lanes.error(0, lane);
      if (!(error > point.error * about * kPart) || (!with_itself && near_[lane] == point.input)) continue;
      const double relative = error / unit(near_[lane], point.output);
      if (!(relative > point.error)) continue;
      point.error = relative;
      worst = lane;
    }
    if (worst >= 0) point.input = near_[worst];
  }

  // Changes one to three numbers by 2^-2 to 2^-digits of themselves or of the length.
  bool change(std::vector<double>& input) {
    const double typical = 1 / std::sqrt(static_cast<double>(input.size()));
    bool turned = false;
    for (std::size_t n = 0, count = 1 + below(3); n < count; ++n) {
      const std::size_t i = below(input.size());
      if (fixed_[i]) continue;
      const double scale = random_.next() < 0 ? input[i] : typical;
      const int places = static_cast<int>(below(format_.digits - 1));
      input[i] += std::ldexp(random_.next(), -2 - places) * scale;
      turned = turned || range_.turning[i];
    }
    return to_domain<T>(kernel_, range_, input, turned);
  }

  // 0 .. n-1
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>((random_.next() + 1) / 2 * static_cast<double>(n));
  }

  Kernel kernel_;  // without a loop
  bound::Format format_;
  Size size_;
  Range range_;
  std::vector<bool> fixed_;
  numeric::Random random_{1};
  Inputs near_;                  // the neighbors of a point
  std::vector<Lanes> in_lanes_;  // these, by number
};

}  // namespace

template <class T>
std::vector<std::vector<double>> search_inputs(const Kernel& kernel, const Domain& domain,
                                               const std::vector<std::vector<double>>& starts, int evaluations) {
  Inputs inputs = domain.test_inputs(kernel.degree);
  Search<T> search(kernel, domain, inputs, bound::find_format(Arithmetic<T>::kName));
  return search.run(std::move(inputs), starts, evaluations);
}

int search_evaluations(const Kernel& kernel) {
  constexpr double kMostVisits = 4e7;  // of nodes
  const auto rows = static_cast<double>(std::max<std::size_t>(kernel.table.size(), 1));
  return static_cast<int>(
             std::clamp(kMostVisits / (static_cast<double>(kernel.nodes.size()) * rows), 2048.0, 32768.0)) /
         kLanes * kLanes;
}

namespace {

// The domain with inputs in the range of half precision.
Domain in_half_range(const Domain& domain, const Kernel& kernel) {
  Domain narrow = domain;
  narrow.test_inputs = [&kernel, all = domain.test_inputs](int degree) {
    std::vector<std::vector<double>> inputs = all(degree);
    const Range range(kernel.parameters, inputs);
    for (std::vector<double>& input : inputs) to_domain<Half>(kernel, range, input);
    return inputs;
  };
  return narrow;
}

}  // namespace

template <class T>
void search_more(MeasuredError& error, const Kernel& kernel, const Domain& domain, const Inputs& starts,
                 int evaluations) {
  measure_more<T>(error, kernel, domain, search_inputs<T>(kernel, domain, starts, evaluations));
  error.searched = (kClimbs + static_cast<int>(kWalks<T>) * kWalkLength) * evaluations;
}

template <>
MeasuredError largest_seen<Half>(const Kernel& kernel, const Domain& domain, const Inputs& starts, int evaluations) {
  const Domain narrow = in_half_range(domain, kernel);
  MeasuredError error = measure<Half>(kernel, narrow);
  search_more<Half>(error, kernel, narrow, starts, evaluations);
  return error;
}

template <class T>
MeasuredError largest_seen(const Kernel& kernel, const Domain& domain, const Inputs& starts, int evaluations) {
  MeasuredError error = measure<T>(kernel, domain);
  search_more<T>(error, kernel, domain, starts, evaluations);
  return error;
}

template Inputs search_inputs<float>(const Kernel&, const Domain&, const Inputs&, int);
template Inputs search_inputs<double>(const Kernel&, const Domain&, const Inputs&, int);
template Inputs search_inputs<Half>(const Kernel&, const Domain&, const Inputs&, int);
template void search_more<float>(MeasuredError&, const Kernel&, const Domain&, const Inputs&, int);
template void search_more<double>(MeasuredError&, const Kernel&, const Domain&, const Inputs&, int);
template MeasuredError largest_seen<float>(const Kernel&, const Domain&, const Inputs&, int);
template MeasuredError largest_seen<double>(const Kernel&, const Domain&, const Inputs&, int);

}  // namespace sh::codegen
