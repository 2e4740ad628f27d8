#include "codegen/bound/bilinear.hpp"

#include <numeric>
#include <stdexcept>

namespace sh::codegen::bound {
bool is_bilinear(const Kernel& kernel, const Region& region) {
  if (!region.root.empty()) return false;
  std::vector<int> degree;
  for (const Node& node : kernel.nodes) {
    int most = node.op == Op::kInput ? 1 : 0;
    for (const NodeId argument : arguments(node)) {
      most = node.op == Op::kMul ? most + degree[argument] : std::max(most, degree[argument]);
    }
    degree.push_back(most);
  }
  return std::count(degree.begin(), degree.end(), 2) > 0;
}

BilinearAnalysis::BilinearAnalysis(const Kernel& kernel, const Format& format) : derivatives_(kernel.nodes.size()) {
  for (const Parameter& parameter : kernel.parameters) {
    blocks_.push_back({static_cast<int>(block_of_.size()), parameter.size(), {}, 0});
    block_of_.insert(block_of_.end(), parameter.size(), static_cast<int>(blocks_.size()) - 1);
  }
  if (blocks_.size() > 2) throw std::domain_error("it has more than two arrays of coefficients");
  for (const Output& output : kernel.outputs) outputs_.push_back(output.node);
  forward(kernel, format);
  mark_split(kernel);
}

// --- forward: the values

void BilinearAnalysis::forward(const Kernel& kernel, const Format& format) {
  for (const Node& node : kernel.nodes) {
    Step& step = steps_.emplace_back();
    step.op = node.op;
    step.args = node.args;
    constants_.emplace_back();
    values_.emplace_back();
    product_of_.push_back(-1);
    describe(node, format);
    Form& value = values_.back();
    for (Form::Term& term : value.terms) {
      if (step.degree > 0) term.factor = widened(term.factor, above(step.unit * term.factor.magnitude()));
    }
    rows_.push_back(step.degree == 1 ? row_of(value) : Row{});
    require_range(format);
  }
}

// The arrays are at most as long as the format's scale.
void BilinearAnalysis::require_range(const Format& format) const {
  const double scale = format.scale;
  double largest = steps_.back().degree == 1 ? rows_.back().most() * scale : 0;
  for (const Form::Term& term : values_.back().terms) {
    if (steps_.back().degree != 2) break;
    const Product& product = products_[term.monomial - 1];
    largest += term.factor.magnitude() * product.left.most() * scale * product.right.most() * scale;
  }
  if (!(largest * 2 < format.largest)) throw std::domain_error("a value may overflow");
}

void BilinearAnalysis::describe(const Node& node, const Format& format) {
  Step& step = steps_.back();
  Form& value = values_.back();
  const auto argument = [&](int i) -> const Step& { return steps_[node.args[i]]; };
  const auto argument_value = [&](int i) -> const Form& { return values_[node.args[i]]; };
  switch (node.op) {
    case Op::kInput:
      step.degree = 1;
      value.terms = {{monomial_of(node.input), {1, 1}}};
      return;
    case Op::kConstant:
      constants_.back() = rounded(node.constant, format);
      value.set(constants_.back().value);
      return;
    case Op::kNeg:
      step.degree = argument(0).degree;
      if (step.degree == 0) throw std::domain_error("it has the negative of a constant");
      step.contractible = argument(0).contractible;
      return set_negative(value, argument_value(0));
    case Op::kAdd:
    case Op::kSub:
      step.degree = argument(0).degree;
      if (step.degree == 0 || step.degree != argument(1).degree) {
        throw std::domain_error("a sum is not homogeneous in the coefficients");
      }
      // Twice a number is exact, but twice a product may be contracted.
      if (node.args[0] != node.args[1] || argument(0).contractible) step.unit = format.epsilon() / 2;
      return node.op == Op::kAdd ? set_sum(value, argument_value(0), argument_value(1))
                                 : set_difference(value, argument_value(0), argument_value(1));
    case Op::kMul:
      return describe_product(node, format);
    default:
      throw std::domain_error("it has the operation " + op_name(node.op));
  }
}

void BilinearAnalysis::describe_product(const Node& node, const Format& format) {
  Step& step = steps_.back();
  const NodeId a = node.args[0], b = node.args[1];
  step.degree = steps_[a].degree + steps_[b].degree;
  if (step.degree > 2) throw std::domain_error("it multiplies more than two coefficients");
  // Sums of subnormal numbers are exact. Twice the error of a product covers what it changes in other factors.
  step.tiny = 2 * format.tiny();
  if (steps_[a].degree == 1 && steps_[b].degree == 1) {
    step.unit = format.epsilon() / 2;
    step.contractible = true;
    product_of_.back() = static_cast<int>(products_.size());
    values_.back().terms = {{monomial_of(product_of_.back()), {1, 1}}};
    products_.push_back({rows_[a], rows_[b]});
    return;
  }
  const RoundedConstant& constant = constants_[steps_[a].degree == 0 ? a : b];
  if (!(constant.value.mignitude() > 0)) throw std::domain_error("a factor may be zero");
  step.contractible = !constant.power_of_two;
  step.unit = above((constant.power_of_two ? 0 : format.epsilon() / 2) +
                    constant.error.magnitude() / constant.value.mignitude() * kSlack);
  set_product(values_.back(), values_[a], values_[b]);
}

void BilinearAnalysis::mark_split(const Kernel& kernel) {
  std::vector<int> uses(steps_.size(), 0);
  for (const Node& node : kernel.nodes) {
    for (const NodeId argument : arguments(node)) ++uses[argument];
  }
  for (const NodeId output : outputs_) ++uses[output];
  for (std::size_t id = 0; id < steps_.size(); ++id) {
    Step& step = steps_[id];
    step.split = step.contractible && (uses[id] > 1 || step.op == Op::kNeg);
    // The uses of a negative are uses of the product.
    if (step.op != Op::kNeg || !step.contractible) continue;
    steps_[step.args[0]].split = true;
    step.unit = steps_[step.args[0]].unit;
    step.tiny = steps_[step.args[0]].tiny;
  }
}

BilinearAnalysis::Row BilinearAnalysis::row_of(const Form& form) {
  Row row;
  double square = 0, radius = 0;
  for (const Form::Term& term : form.terms) {
    const double middle = term.factor.low + term.factor.width() / 2;
    const double off = above(std::max(term.factor.high - middle, middle - term.factor.low));
    row.middle.emplace_back(static_cast<int>(term.monomial) - 1, middle);
    square += middle * middle;
    radius += off * off;
  }
  row.length = std::sqrt(square);
  row.radius = std::sqrt(radius) * kSlack;
  return row;
}

// --- reverse: the derivatives

BilinearError BilinearAnalysis::operator()(std::size_t output) {
  BilinearError error;
  terms_.clear();
  of_products_.assign(products_.size(), 0.0);
  reverse(outputs_[output], error);
  for (std::size_t i = 0; i < products_.size(); ++i) add_term(of_products_[i], products_[i].left, products_[i].right);
  bound_terms(error);
  error.linear *= kSlack;
  return error;
}

void BilinearAnalysis::bound_terms(BilinearError& error) {
  for (Block& block : blocks_) {
    block.matrix.assign(static_cast<std::size_t>(block.size) * block.size, 0.0);
    block.radius = 0;
  }
  for (const Term& term : terms_) {
    const double weight = term.right.most() / term.left->most();
    add_square(term.factor * weight / 2, *term.left);
    add_square(term.factor / weight / 2, term.right);
  }
  double product = 1;
  for (Block& block : blocks_) {
    const LargestEigenvalue largest = largest_eigenvalue(std::move(block.matrix), block.size);
    const double root = std::sqrt(largest.at_most) + std::sqrt(block.radius);
    product *= root * root;
    error.worst.insert(error.worst.end(), largest.vector.begin(), largest.vector.end());
  }
  // x + y for one array; for two, scaling a against b makes both parts equal: 2 sqrt(x y).
  error.bilinear = (blocks_.size() == 2 ? 2 * std::sqrt(product) : product) * kSlack;
}

void BilinearAnalysis::reverse(NodeId output, BilinearError& error) {
  for (NodeId id = 0; id <= output; ++id) derivatives_[id].terms.clear();
  derivatives_[output].set({1, 1});
  if (steps_[output].split) add_rounding(output, derivatives_[output], error);
  for (NodeId id = output; id >= 0; --id) {
    if (derivatives_[id].terms.empty()) continue;
    if (!steps_[id].split) add_rounding(id, derivatives_[id], error);
    pass_on(id, error);
  }
}

void BilinearAnalysis::add_rounding(NodeId id, const Form& derivative, BilinearError& error) {
  const Step& step = steps_[id];
  if (step.unit == 0 && step.tiny == 0) return;
  if (step.degree == 2) {
    const double number = derivative.number().magnitude() * kSlack;
    error.one += number * step.tiny;
    for (const Form::Term& term : values_[id].terms) {
      of_products_[term.monomial - 1] += number * step.unit * term.factor.magnitude();
    }
    return;
  }
  Row by = row_of(derivative);
  error.linear += by.most() * step.tiny;
  add_term(step.unit, rows_[id], std::move(by));
}

void BilinearAnalysis::pass_on(NodeId id, BilinearError& error) {
  const Step& step = steps_[id];
  const Form& derivative = derivatives_[id];
  const auto pass_product = [&](int to, int other) {
    if (steps_[step.args[to]].degree == 0) return;  // the unit of the product holds the constant's error
    set_product(part_, derivative, values_[step.args[other]]);
    pass_to(step.args[to], false, error);
  };
  const auto pass_same = [&](int to, bool negative) {
    if (negative) {
      set_negative(part_, derivative);
    } else {
      part_.terms = derivative.terms;
    }
    pass_to(step.args[to], step.op == Op::kNeg, error);
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
    default:
      return;
  }
}

// Adds `part_`, the derivative that a use passes to an argument.
void BilinearAnalysis::pass_to(NodeId argument, bool to_negative, BilinearError& error) {
  accumulate(derivatives_[argument], part_);
  if (steps_[argument].split && !to_negative) add_rounding(argument, part_, error);
}

void BilinearAnalysis::add_term(double factor, const Row& left, Row right) {
  if (factor > 0 && left.most() > 0 && right.most() > 0) terms_.push_back({factor, &left, std::move(right)});
}

void BilinearAnalysis::add_square(double factor, const Row& row) {
  Block& block = blocks_[block_of_[row.middle[0].first]];
  if (block_of_[row.middle.back().first] != block_of_[row.middle[0].first]) {
    throw std::domain_error("it adds coefficients of two arrays");
  }
  block.radius += factor * row.radius * row.radius * kSlack;
  for (const auto& [i, x] : row.middle) {
    double* const line = block.matrix.data() + static_cast<std::size_t>(i - block.first) * block.size - block.first;
    for (const auto& [k, y] : row.middle) line[k] += factor * x * y;
  }
}

LargestEigenvalue largest_eigenvalue(std::vector<double> matrix, int size) {
  constexpr int kSquarings = 10;
  const auto n = static_cast<std::size_t>(size);
  LargestEigenvalue result;
  result.vector.assign(n, 0.0);
  const auto trace = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += matrix[i * n + i];
    return sum;
  };
  const double first = trace();
  if (!(first > 0)) return result;
  // bound = the product of trace(A_k)^(1 / 2^k), where A_0 = A and A_(k+1) = (A_k / trace(A_k))^2
  double present = first;
  double power = 1;
  std::vector<double> squared(n * n);
  result.at_most = present;
  for (int k = 0; k < kSquarings; ++k) {
    for (double& entry : matrix) entry /= present;
    std::fill(squared.begin(), squared.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const double factor = matrix[i * n + j];
        if (factor == 0) continue;
        for (std::size_t c = 0; c < n; ++c) squared[i * n + c] += factor * matrix[j * n + c];
      }
    }
    matrix.swap(squared);
    present = trace();
    power /= 2;
    result.at_most *= std::pow(present, power);
  }
  // Roundings: of the entries of A, sums of squares, relative to its trace; of the powers, relative.
  result.at_most = (result.at_most + first * 1e-11) * kSlack;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (matrix[i * n + i] > matrix[largest * n + largest]) largest = i;
  }
  double square = 0;
  for (std::size_t i = 0; i < n; ++i) square += matrix[largest * n + i] * matrix[largest * n + i];
  for (std::size_t i = 0; i < n; ++i) result.vector[i] = matrix[largest * n + i] / std::sqrt(square);
  return result;
}

}  // namespace sh::codegen::bound
