#include "codegen/bound/every_number.hpp"

#include <functional>
#include <stdexcept>

#include "codegen/bound/rounding.hpp"
#include "codegen/bound/size.hpp"

namespace sh::codegen::bound {
namespace {

constexpr int kMostDigits = 11;  // of binary16: 63,488 finite numbers

// The number of the format that is nearest to x; of two, the even one.
double nearest(double x, const Format& format) {
  if (x == 0) return 0;
  const int place = std::max(std::ilogb(x) - (format.digits - 1), format.least_exponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, -place)), place);
}

// Encloses the roundings of a + b, where double may round the sum.
Interval nearest_of_sum(double a, double b, const Format& format) {
  const double sum = a + b;
  const double part = sum - a;
  const bool exact = (a - (sum - part)) + (b - part) == 0;
  if (exact) return {nearest(sum, format), nearest(sum, format)};
  return {nearest(below(sum), format), nearest(above(sum), format)};
}

// Of numbers of a format of few digits, whose products are exact in double.
Interval exact_product(Interval a, Interval b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

class PointErrors {
 public:
  /// Throws std::domain_error for a kernel that it cannot follow.
  PointErrors(const Kernel& kernel, const Region& region, const Format& format)
      : kernel_(kernel), format_(format), values_(kernel.nodes.size()), error_(region.coordinate.size()) {
    for (const Node& node : kernel.nodes) {
      constants_.push_back(node.op == Op::kConstant ? rounded(node.constant, format) : RoundedConstant{});
      symbol_.push_back(symbol_of(node, region));
    }
  }

  void move_to(double input) {
    for (NodeId id = 0; id < kernel_.size(); ++id) values_[id] = value(id, input);
  }

  // |computed - exact| of the number; its product with the coefficient is rounded once more.
  const Magnitudes& error(std::size_t output) {
    const NodeId id = kernel_.outputs[output].node;
    const auto& [exact, computed, product] = values_[id];
    const double of_number = std::max(computed.high - exact.low, exact.high - computed.low) * kSlack;
    error_.clear();
    if (symbol_[id] < 0) {
      error_[kOne] = of_number;
    } else if (kernel_.node(id).op != Op::kInput) {
      error_[monomial_of(symbol_[id])] = above(of_number + computed.magnitude() * (format_.epsilon() / 2));
      error_[kOne] = format_.tiny();
    }
    return error_;
  }

 private:
  struct Value {
    Interval exact;     // of the formula
    Interval computed;  // in the format, with and without contraction
    Interval product;   // before its rounding: a contraction takes this
  };

  // The coefficient that a node is a multiple of; -1: the node is a number.
  [[nodiscard]] int symbol_of(const Node& node, const Region& region) const {
    if (node.op == Op::kInput) return region.coordinate[node.input] < 0 ? node.input : -1;
    int symbol = -1;
    for (const NodeId arg : arguments(node)) {
      if (symbol_[arg] < 0) continue;
      const bool is_scaled = node.op == Op::kMul && kernel_.node(arg).op == Op::kInput && symbol < 0;
      if (!is_scaled) throw std::domain_error("it adds or multiplies coefficients");
      symbol = symbol_[arg];
    }
    return symbol;
  }

  [[nodiscard]] Value value(NodeId id, double input) const {
    const Node& node = kernel_.node(id);
    const auto of = [&](int i) -> const Value& { return values_[node.args[i]]; };
    switch (node.op) {
      case Op::kConstant: {
        const RoundedConstant& constant = constants_[id];
        const Interval rounded{constant.nearest, constant.nearest};
        return {constant.error.is_zero() ? rounded : rounded - constant.error, rounded, rounded};
      }
      case Op::kInput:
        if (symbol_[id] >= 0) return {{1, 1}, {1, 1}, {1, 1}};
        return {{input, input}, {input, input}, {input, input}};
      case Op::kNeg:
        return {-of(0).exact, -of(0).computed, -of(0).product};
      case Op::kAdd:
        return sum(of(0).exact + of(1).exact, of(0), of(1));
      case Op::kSub:
        return sum(of(0).exact - of(1).exact, of(0), {{}, -of(1).computed, -of(1).product});
      case Op::kMul:
        return product(of(0), of(1), node.args[0] == node.args[1], symbol_[id] >= 0);
      case Op::kFma: {
        const Interval factor = exact_product(of(0).computed, of(1).computed);
        const Interval computed = rounded_sum(factor, of(2).computed);
        return {of(0).exact * of(1).exact + of(2).exact, computed, computed};
      }
      default:
        throw std::domain_error("it has the operation " + op_name(node.op));
    }
  }

  [[nodiscard]] Interval rounded_sum(Interval a, Interval b) const {
    return {nearest_of_sum(a.low, b.low, format_).low, nearest_of_sum(a.high, b.high, format_).high};
  }

  // Either argument may be a product that is not rounded.
  [[nodiscard]] Value sum(Interval exact, const Value& a, const Value& b) const {
    Interval computed = rounded_sum(a.computed, b.computed);
    computed = hull(computed, rounded_sum(a.product, b.computed));
    computed = hull(computed, rounded_sum(a.computed, b.product));
    return {exact, computed, computed};
  }

  // scaled: a number times a coefficient, which `error` rounds
  [[nodiscard]] Value product(const Value& a, const Value& b, bool squared, bool scaled) const {
    const Interval exact = squared ? square(a.exact) : a.exact * b.exact;
    const Interval product = exact_product(a.computed, b.computed);
    if (scaled) return {exact, product, product};
    return {exact, {nearest(product.low, format_), nearest(product.high, format_)}, product};
  }

  const Kernel& kernel_;
  const Format& format_;
  std::vector<RoundedConstant> constants_;
  std::vector<int> symbol_;
  std::vector<Value> values_;
  Magnitudes error_;
};

void for_every_number(Interval range, const Format& format, const std::function<void(double)>& visit) {
  for (double x = nearest(range.low, format); x <= range.high;) {
    if (x >= range.low) visit(x);
    // Below a power of two the numbers are nearer than above it; from 0 on the least ones follow.
    const double inside = x < 0 ? std::nextafter(x, 0.0) : x;
    const int place =
        x == 0 ? format.least_exponent : std::max(std::ilogb(inside) - (format.digits - 1), format.least_exponent);
    x += std::ldexp(1.0, place);
  }
}

}  // namespace

std::optional<Bound> bound_at_every_number(const Kernel& kernel, const Domain& domain, const Region& region,
                                           const Format& format) {
  if (format.digits > kMostDigits || region.root.size() != 1 || region.homogeneous || region.logarithmic >= 0)
    return {};
  try {
    PointErrors errors(kernel, region, format);
    const Sizes sizes(kernel, domain, region, format);
    Bound result;
    Sized most;
    std::size_t worst_output = 0;
    for_every_number(region.root[0], format, [&](double x) {
      const Box point{{x, x}};
      ++result.boxes;
      errors.move_to(x);
      for (std::size_t output = 0; output < kernel.outputs.size(); ++output) {
        const Sized error = sizes(errors.error(output), output, point);
        most.absolute = std::max(most.absolute, error.absolute);
        if (error.relative <= most.relative) continue;
        most.relative = error.relative;
        result.worst_box = point;
        worst_output = output;
      }
    });
    if (result.worst_box.empty()) return {};
    const double x = result.worst_box[0].low;
    errors.move_to(x);
    result.worst = sizes.worst_coefficients(errors.error(worst_output));
    for (std::size_t i = 0; i < result.worst.size(); ++i) {
      if (region.coordinate[i] >= 0) result.worst[i] = x;
    }
    result.eps = most.relative / format.epsilon();
    result.absolute = most.absolute;
    result.domain = region.text;
    result.every_number = true;
    return result;
  } catch (const std::domain_error&) {
    return {};
  }
}

}  // namespace sh::codegen::bound
