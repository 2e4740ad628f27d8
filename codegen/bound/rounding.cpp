#include "codegen/bound/rounding.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::codegen::bound {
namespace {

constexpr int kNoGrid = -100000;

// Sums of magnitudes are rounded to nearest, up to a million terms; this factor covers all these roundings.
constexpr double kSlack = 1 + 1e-9;

bool is_sum(Op op) { return op == Op::kAdd || op == Op::kSub; }

// The exponent of the last place of a number of this magnitude.
int last_place(double magnitude, const Format& format) {
  if (magnitude == 0) return format.least_exponent;
  return std::max(std::ilogb(magnitude) - (format.digits - 1), format.least_exponent);
}

// The degree of every node in the coordinates of a vector. Throws unless every node is homogeneous.
std::vector<int> degrees_in_vector(const Kernel& kernel) {
  std::vector<int> degree;
  for (const Node& node : kernel.nodes) {
    const auto of = [&](int i) { return degree[node.args[i]]; };
    switch (node.op) {
      case Op::kInput:
        degree.push_back(1);
        break;
      case Op::kConstant:
        degree.push_back(0);
        break;
      case Op::kNeg:
        degree.push_back(of(0));
        break;
      case Op::kAdd:
      case Op::kSub:
        if (of(0) != of(1)) throw std::domain_error("a sum is not homogeneous in the vector");
        degree.push_back(of(0));
        break;
      case Op::kMul:
        degree.push_back(of(0) + of(1));
        break;
      case Op::kDiv:
        degree.push_back(of(0) - of(1));
        break;
      case Op::kSqrt:
        degree.push_back(of(0) / 2);
        break;
      default:
        throw std::domain_error("it has the operation " + op_name(node.op));
    }
  }
  return degree;
}

}  // namespace

// --- facts that hold on every box

RoundingAnalysis::RoundingAnalysis(const Kernel& kernel, const Region& region, const Format& format)
    : format_(format),
      coordinate_(region.coordinate),
      homogeneous_(region.homogeneous),
      values_(kernel.nodes.size()),
      absolute_(kernel.nodes.size()),
      grid_(kernel.nodes.size()),
      derivatives_(kernel.nodes.size()),
      by_roundings_(kernel.nodes.size()) {
  describe(kernel, region);
  set_reach();
  const std::vector<int> degrees = form_degrees();
  const int most = degrees.empty() ? 0 : *std::max_element(degrees.begin(), degrees.end());
  if (most > 2) throw std::domain_error("it multiplies more than two coefficients");
  errors_.assign(outputs_.size(), Magnitudes(coordinate_.size(), most));
}

void RoundingAnalysis::describe(const Kernel& kernel, const Region& region) {
  std::vector<int> uses(kernel.nodes.size(), 0);
  for (const Node& node : kernel.nodes) {
    for (const NodeId arg : arguments(node)) ++uses[arg];
  }
  for (const Output& output : kernel.outputs) {
    outputs_.push_back(output.node);
    ++uses[output.node];
  }
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    Step& step = steps_.emplace_back();
    step.op = node.op;
    step.args = node.args;
    step.input = node.input;
    if (node.op == Op::kConstant) step.constant = rounded(node.constant, format_);
    describe_operation(step);
    step.split = step.contractible && (uses[id] > 1 || node.op == Op::kNeg);
    // The uses of a negative are uses of the product.
    if (node.op == Op::kNeg && step.contractible) steps_[node.args[0]].split = true;
  }
  set_tiny(kernel, region);
}

void RoundingAnalysis::describe_operation(Step& step) const {
  const auto argument = [&](int i) -> const Step& { return steps_[step.args[i]]; };
  switch (step.op) {
    case Op::kInput:
    case Op::kConstant:
      return;
    case Op::kNeg:
      step.contractible = argument(0).contractible;
      return;
    case Op::kAdd:
    case Op::kSub:
      // Twice a number is exact, but twice a product may be contracted.
      step.computed = step.relative = step.args[0] != step.args[1] || argument(0).contractible;
      return;
    case Op::kMul:
      step.computed = true;
      step.relative = !argument(0).constant.power_of_two && !argument(1).constant.power_of_two;
      step.contractible = step.relative;
      return;
    case Op::kFma:
    case Op::kDiv:
    case Op::kSqrt:
      step.computed = step.relative = true;
      return;
    default:
      throw std::domain_error("it has the operation " + op_name(step.op));
  }
}

// A vector of length s scales a node of degree k by s^k, so the error of a subnormal result counts s^-k times.
void RoundingAnalysis::set_tiny(const Kernel& kernel, const Region& region) {
  const std::vector<int> degree = region.homogeneous ? degrees_in_vector(kernel) : std::vector<int>(steps_.size(), 0);
  for (std::size_t id = 0; id < steps_.size(); ++id) {
    const double most = std::max(std::pow(region.lengths.low, -degree[id]), std::pow(region.lengths.high, -degree[id]));
    steps_[id].tiny = steps_[id].computed ? format_.tiny() * most * kSlack : 0;
  }
}

void RoundingAnalysis::set_reach() {
  for (const NodeId output : outputs_) {
    std::vector<bool> reached(steps_.size(), false);
    reached[output] = true;
    std::vector<NodeId>& reach = reach_.emplace_back();
    for (NodeId id = output; id >= 0; --id) {
      if (!reached[id]) continue;
      reach.push_back(id);
      for (int i = 0; i < argument_count(steps_[id].op); ++i) reached[steps_[id].args[i]] = true;
    }
  }
}

// The degree of every node in the coefficients.
std::vector<int> RoundingAnalysis::form_degrees() const {
  std::vector<int> degree;
  for (const Step& step : steps_) {
    int most = step.op == Op::kInput && coordinate_[step.input] < 0 ? 1 : 0;
    for (int i = 0; i < argument_count(step.op); ++i) {
      const int other = degree[step.args[i]];
      most = step.op == Op::kMul ? most + other : std::max(most, other);
    }
    degree.push_back(most);
  }
  return degree;
}

std::vector<int> RoundingAnalysis::signs(std::size_t output) {
  reverse(output);
  std::vector<int> signs(coordinate_.size(), 0);
  for (const NodeId id : reach_[output]) {
    if (steps_[id].op != Op::kInput || !derivatives_[id].is_number()) continue;
    const Interval derivative = derivatives_[id].number();
    signs[steps_[id].input] = derivative.low > 0 ? 1 : derivative.high < 0 ? -1 : 0;
  }
  return signs;
}

double RoundingAnalysis::cost() const {
  auto cost = static_cast<double>(steps_.size());
  for (const auto& reach : reach_) cost += static_cast<double>(reach.size());
  return cost;
}

double RoundingAnalysis::terms() const {
  const std::vector<int> degrees = form_degrees();
  const auto symbols = static_cast<double>(std::count(coordinate_.begin(), coordinate_.end(), -1));
  double terms = 0;
  for (const auto& reach : reach_) {
    for (const NodeId id : reach) terms += degrees[id] < 2 ? 1 : symbols * symbols / 4;
  }
  return terms;
}

// --- forward: the values

const std::vector<Magnitudes>& RoundingAnalysis::operator()(const Box& box) {
  for (NodeId id = 0; id < static_cast<NodeId>(steps_.size()); ++id) forward(id, box);
  for (std::size_t output = 0; output < outputs_.size(); ++output) reverse(output);
  return errors_;
}

void RoundingAnalysis::forward(NodeId id, const Box& box) {
  const Step& step = steps_[id];
  Form& value = values_[id];
  absolute_[id] = 0;
  grid_[id] = kNoGrid;
  if (step.op == Op::kConstant) {
    value.set(step.constant.value);
    grid_[id] = step.constant.grid;
  } else if (step.op == Op::kInput && coordinate_[step.input] < 0) {
    value.terms.assign(1, {monomial_of(step.input), {1, 1}});
  } else if (step.op == Op::kInput) {
    value.set(box[coordinate_[step.input]]);
    grid_[id] = last_place(value.number().mignitude(), format_);
  } else {
    exact_result(step, value);
    if (!value.is_finite()) throw std::domain_error("a value may overflow");
    if (value.is_number()) {
      round_number(id, value.number());
    } else {
      round_form(id);
    }
  }
}

void RoundingAnalysis::exact_result(const Step& step, Form& result) {
  const auto value = [&](int i) -> const Form& { return values_[step.args[i]]; };
  switch (step.op) {
    case Op::kNeg:
      return set_negative(result, value(0));
    case Op::kAdd:
      return set_sum(result, value(0), value(1));
    case Op::kSub:
      return set_difference(result, value(0), value(1));
    case Op::kMul:
      if (step.args[0] == step.args[1] && value(0).is_number()) return result.set(square(value(0).number()));
      return set_product(result, value(0), value(1));
    case Op::kFma:
      set_product(part_, value(0), value(1));
      return set_sum(result, part_, value(2));
    case Op::kDiv:
      if (!value(1).is_number()) throw std::domain_error("a divisor depends on coefficients");
      if (!(value(1).number().mignitude() > 0)) throw std::domain_error("a divisor may be zero");
      factor_.set(Interval{1, 1} / value(1).number());
      return set_product(result, value(0), factor_);
    case Op::kSqrt:
      if (!value(0).is_number() || !(value(0).number().low > 0)) {
        throw std::domain_error("the argument of a root may be zero");
      }
      return result.set(sqrt(value(0).number()));
    default:
      throw std::domain_error("it has the operation " + op_name(step.op));
  }
}

// The largest magnitude of a result. Outward rounding would lift a product that is at most a power of two above it, and
// the unit of its last place with it.
double RoundingAnalysis::exact_magnitude(const Step& step, Interval result) const {
  const double magnitude = result.magnitude();
  if (step.op != Op::kMul) return magnitude;
  const double a = values_[step.args[0]].number().magnitude();
  const double b = values_[step.args[1]].number().magnitude();
  int exponent = 0;
  const bool power = std::frexp(a * b, &exponent) == 0.5;
  return power && std::fma(a, b, -(a * b)) <= 0 ? std::min(magnitude, a * b) : magnitude;
}

void RoundingAnalysis::round_number(NodeId id, Interval exact) {
  const Step& step = steps_[id];
  const double magnitude = exact_magnitude(step, exact);
  const bool of_numbers = !homogeneous_ && (is_sum(step.op) || step.op == Op::kNeg);
  const int grid = of_numbers ? sum_grid(step) : kNoGrid;
  const bool on_grid = grid > kNoGrid && magnitude <= std::ldexp(1.0, grid + format_.digits);
  double& error = absolute_[id];
  if (!step.computed || on_grid || magnitude == 0) {
    error = 0;
  } else if (!step.relative) {
    error = step.tiny;
  } else if (homogeneous_) {
    error = above(format_.epsilon() / 2 * magnitude + step.tiny);
  } else {
    error = std::max(format_.half_ulp(magnitude), step.tiny);
  }
  if (error > 0) values_[id].set(widened(exact, error));
  const double largest = values_[id].number().magnitude();
  if (!(largest < format_.largest)) throw std::domain_error("a value may overflow");
  // An addition may take a product before its rounding.
  if (step.contractible) return;
  grid_[id] = last_place(values_[id].number().mignitude(), format_);
  if (on_grid) grid_[id] = std::max(grid_[id], grid);
}

// The exact sum of the arguments is a multiple of 2^grid; kNoGrid: unknown.
int RoundingAnalysis::sum_grid(const Step& step) const {
  int grid = grid_[step.args[0]];
  if (is_sum(step.op)) grid = std::min(grid, grid_[step.args[1]]);
  return grid;
}

// The rounding of a form is at most epsilon/2 of every factor's magnitude.
void RoundingAnalysis::round_form(NodeId id) {
  double sum = 0;
  for (Form::Term& term : values_[id].terms) {
    const double magnitude = term.factor.magnitude();
    if (steps_[id].relative) term.factor = widened(term.factor, above(format_.epsilon() / 2 * magnitude));
    const int degree = degree_of(term.monomial);
    sum += degree == 0   ? magnitude
           : degree == 1 ? magnitude * format_.scale
                         : magnitude * format_.scale * format_.scale;
  }
  if (!(sum * 2 < format_.largest)) throw std::domain_error("a value may overflow");
}

// --- reverse: the derivatives

void RoundingAnalysis::reverse(std::size_t output) {
  for (const NodeId id : reach_[output]) {
    derivatives_[id].terms.clear();
    by_roundings_[id].terms.clear();
  }
  derivatives_[outputs_[output]].set({1, 1});
  by_roundings_[outputs_[output]].set({1, 1});
  constants_.terms.clear();
  Magnitudes& error = errors_[output];
  error.clear();
  for (const NodeId id : reach_[output]) {
    add_error(id, error);
    pass_on(id);
  }
  for (const Form::Term& term : constants_.terms) error[term.monomial] += term.factor.magnitude() * kSlack;
}

const Form& RoundingAnalysis::of_rounding(NodeId id) const {
  return steps_[id].split ? by_roundings_[id] : derivatives_[id];
}

void RoundingAnalysis::add_error(NodeId id, Magnitudes& error) {
  const Step& step = steps_[id];
  if (step.op == Op::kConstant && step.constant.error.magnitude() > 0) {
    factor_.set(step.constant.error);
    set_product(part_, derivatives_[id], factor_);
    accumulate(constants_, part_);
  }
  if (!step.computed) return;
  const bool number = values_[id].is_number();
  const double absolute = number ? absolute_[id] : step.tiny;
  for (const Form::Term& by : of_rounding(id).terms) {
    const double derivative = by.factor.magnitude() * kSlack;
    error[by.monomial] += derivative * absolute;
    if (number || !step.relative) continue;
    const double unit = derivative * format_.epsilon() / 2;
    for (const Form::Term& term : values_[id].terms) {
      error[product_of(by.monomial, term.monomial)] += unit * term.factor.magnitude();
    }
  }
}

void RoundingAnalysis::pass_on(NodeId id) {
  const Step& step = steps_[id];
  const Form& derivative = derivatives_[id];
  const auto pass_product = [&](int to, int other) {
    set_product(part_, derivative, values_[step.args[other]]);
    pass_to(id, step.args[to]);
  };
  const auto pass_same = [&](int to, bool negative) {
    if (negative) {
      set_negative(part_, derivative);
    } else {
      part_.terms = derivative.terms;
    }
    pass_to(id, step.args[to]);
  };
  switch (step.op) {
    case Op::kNeg:
      return pass_same(0, true);
    case Op::kAdd:
    case Op::kSub:
      pass_same(0, false);
      return pass_same(1, step.op == Op::kSub);
    case Op::kMul:
      pass_product(0, 1);
      return pass_product(1, 0);
    case Op::kFma:
      pass_product(0, 1);
      pass_product(1, 0);
      return pass_same(2, false);
    case Op::kDiv:
      return pass_quotient(id);
    case Op::kSqrt:
      return pass_root(id);
    default:
      return;
  }
}

// d(a/b) = da / b - a / b^2 db
void RoundingAnalysis::pass_quotient(NodeId id) {
  const auto& args = steps_[id].args;
  const Interval divisor = values_[args[1]].number();
  factor_.set(Interval{1, 1} / divisor);
  set_product(part_, derivatives_[id], factor_);
  pass_to(id, args[0]);
  Form quotient;
  factor_.set(-(Interval{1, 1} / square(divisor)));
  set_product(quotient, values_[args[0]], factor_);
  set_product(part_, derivatives_[id], quotient);
  pass_to(id, args[1]);
}

// d sqrt(a) = da / (2 sqrt(a))
void RoundingAnalysis::pass_root(NodeId id) {
  const NodeId argument = steps_[id].args[0];
  factor_.set(Interval{0.5, 0.5} / sqrt(values_[argument].number()));
  set_product(part_, derivatives_[id], factor_);
  pass_to(id, argument);
}

// Adds `part_`, the derivative that `user` passes to an argument.
void RoundingAnalysis::pass_to(NodeId user, NodeId argument) {
  accumulate(derivatives_[argument], part_);
  if (!steps_[argument].split) return;
  Form& by_rounding = by_roundings_[argument];
  if (is_sum(steps_[user].op)) {
    accumulate_with_zero(by_rounding, part_);
  } else if (steps_[user].op == Op::kNeg && steps_[user].split) {
    set_negative(part_, by_roundings_[user]);
    accumulate(by_rounding, part_);
  } else {
    accumulate(by_rounding, part_);
  }
}

}  // namespace sh::codegen::bound
