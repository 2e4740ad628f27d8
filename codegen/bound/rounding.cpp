#include "codegen/bound/rounding.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::codegen::bound {
namespace {

constexpr int kNoGrid = -100000;

bool is_sum(Op op) { return op == Op::kAdd || op == Op::kSub; }

// The exponent of the last place of a number of this magnitude.
int last_place(double magnitude, const Format& format) {
  if (magnitude == 0) return format.least_exponent;
  return std::max(std::ilogb(magnitude) - (format.digits - 1), format.least_exponent);
}

}  // namespace

// --- forward: the values

void RoundingAnalysis::move_to(const Box& box) {
  for (NodeId id = 0; id < static_cast<NodeId>(steps_.size()); ++id) forward(id, box);
}

const Magnitudes& RoundingAnalysis::error(std::size_t output) {
  reverse(output);
  return error_;
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
    sum += term.monomial == kOne ? magnitude : magnitude * format_.scale;
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
  error_.clear();
  for (const NodeId id : reach_[output]) {
    add_error(id, error_);
    pass_on(id);
  }
  for (const Form::Term& term : constants_.terms) error_[term.monomial] += term.factor.magnitude() * kSlack;
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
