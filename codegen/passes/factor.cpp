// Pass: writes polynomials of one or two terms in factored form if that saves operations.
//
// If the exact value of a node is c, c v, c v w, or [v] (c1 v^d + c0) with d = 1 or 2, the pass rebuilds the node in
// that form with one exact constant for each coefficient. The rewrite stays only if it reduces the operations of the
// kernel after sharing. Longer polynomials keep the form of the recipe, because their forms trade operations against
// error, and this choice belongs to the recipe.
#include <algorithm>
#include <map>
#include <optional>

#include "codegen/ir/cost.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {
namespace {

using Factors = std::vector<NodeId>;        // a product of inputs, sorted; z^2 is {z, z}
using Form = std::map<Factors, ExactReal>;  // a sum of at most kMostTerms of them
using Forms = std::vector<std::optional<Form>>;

constexpr std::size_t kMostTerms = 2;
constexpr std::size_t kMostFactors = 3;
constexpr std::size_t kMostNodes = 1500;  // the time to try every product grows with the cube of the nodes

bool accumulate(Form& sum, const Factors& factors, const ExactReal& coefficient) {
  const auto [position, inserted] = sum.try_emplace(factors, coefficient);
  if (inserted) return true;
  const std::optional<ExactReal> total = add(position->second, coefficient);
  if (!total) return false;
  position->second = *total;
  if (as_rational(*total) == cln::cl_RA(0)) sum.erase(position);
  return true;
}

std::optional<Form> sum_of(Form a, const Form& b, bool subtract) {
  for (const auto& [factors, coefficient] : b) {
    if (!accumulate(a, factors, subtract ? negate(coefficient) : coefficient)) return std::nullopt;
  }
  return a;
}

std::optional<Form> product_of(const Form& a, const Form& b) {
  Form result;
  for (const auto& [factors_a, coefficient_a] : a) {
    for (const auto& [factors_b, coefficient_b] : b) {
      Factors factors = factors_a;
      factors.insert(factors.end(), factors_b.begin(), factors_b.end());
      std::sort(factors.begin(), factors.end());
      if (!accumulate(result, factors, multiply(coefficient_a, coefficient_b))) return std::nullopt;
    }
  }
  return result;
}

bool is_short(const Form& form) {
  return form.size() <= kMostTerms &&
         std::all_of(form.begin(), form.end(), [](const auto& term) { return term.first.size() <= kMostFactors; });
}

std::optional<Form> form_of(const Kernel& kernel, NodeId id, const Forms& forms) {
  const Node& node = kernel.node(id);
  const auto arg = [&](std::size_t i) -> const std::optional<Form>& { return forms[node.args[i]]; };
  for (int i = 0; i < argument_count(node.op); ++i) {
    if (!arg(i)) return std::nullopt;
  }
  std::optional<Form> form;
  switch (node.op) {
    case Op::kInput:
      form = Form{{{id}, symbolic::Surd(1)}};
      break;
    case Op::kConstant:
      form = Form{{{}, node.constant}};
      break;
    case Op::kNeg:
      form = sum_of({}, *arg(0), true);
      break;
    case Op::kAdd:
    case Op::kSub:
      form = sum_of(*arg(0), *arg(1), node.op == Op::kSub);
      break;
    case Op::kMul:
      form = product_of(*arg(0), *arg(1));
      break;
    case Op::kFma:
      form = product_of(*arg(0), *arg(1));
      if (form) form = sum_of(*form, *arg(2), false);
      break;
    case Op::kDiv:
    case Op::kSqrt:
    case Op::kSelect:
    case Op::kTable:
    case Op::kRowSum:
      break;
  }
  return form && is_short(*form) ? form : std::nullopt;
}

Forms forms_of(const Kernel& kernel) {
  Forms forms;
  for (NodeId id = 0; id < kernel.size(); ++id) forms.push_back(form_of(kernel, id, forms));
  return forms;
}

// Names the constants of a rewritten node p_3_0: k_3_0 for a single constant, a_3_0 and b_3_0 in a sum.
std::string constant_name(char letter, const std::string& node_name) {
  const std::size_t underscore = node_name.find('_');
  return underscore == std::string::npos ? std::string() : letter + node_name.substr(underscore);
}

// Appends factored forms. `position` maps the inputs of the original kernel to the new kernel.
class FormBuilder {
 public:
  FormBuilder(Kernel& kernel, const std::vector<NodeId>& position, std::string name)
      : kernel_(kernel), build_(kernel), position_(position), name_(std::move(name)) {}

  std::optional<NodeId> append(const Form& form) {
    return form.size() == 1 ? one_term(*form.begin()) : two_terms(*form.begin(), *form.rbegin());
  }

 private:
  using Term = Form::value_type;

  [[nodiscard]] NodeId at(NodeId input) const { return position_[input]; }

  NodeId product(NodeId v, NodeId w) {
    const std::string& left = kernel_.node(at(v)).name;
    const std::string& right = kernel_.node(at(w)).name;
    std::string name = v == w ? left + "2" : left + right;
    return build_.mul(at(v), at(w), std::move(name));
  }

  std::optional<NodeId> one_term(const Term& term) {
    const auto& [factors, coefficient] = term;
    if (factors.size() == kMostFactors) return std::nullopt;
    const NodeId k = build_.constant(coefficient, constant_name('k', name_));
    if (factors.empty()) return k;
    return build_.mul(k, factors.size() == 1 ? at(factors[0]) : product(factors[0], factors[1]));
  }

  // [v] (c1 v^d + c0)
  std::optional<NodeId> two_terms(const Term& first, const Term& second) {
    const auto& [low, high] =
        first.first.size() < second.first.size() ? std::tie(first, second) : std::tie(second, first);
    const NodeId v = high.first.front();
    if (high.first != Factors(high.first.size(), v) || low.first != Factors(low.first.size(), v)) return std::nullopt;
    const std::size_t gap = high.first.size() - low.first.size();
    if (low.first.size() > 1 || gap > 2) return std::nullopt;
    const NodeId a = build_.constant(high.second, constant_name('a', name_));
    const NodeId leading = build_.mul(a, gap == 1 ? at(v) : product(v, v));
    const bool minus = is_negative(low.second);
    const NodeId b = build_.constant(minus ? negate(low.second) : low.second, constant_name('b', name_));
    const NodeId sum = minus ? build_.sub(leading, b) : build_.add(leading, b);
    return low.first.empty() ? sum : build_.mul(at(v), sum);
  }

  Kernel& kernel_;
  Builder build_;
  const std::vector<NodeId>& position_;
  std::string name_;
};

// The kernel after sharing, with the nodes in `chosen` rebuilt from their forms if these have a factored shape.
template <class Chosen>
Kernel rebuilt(const Kernel& kernel, const Forms& forms, const Chosen& chosen) {
  Kernel result = kernel;
  result.nodes.clear();
  Builder build(result);
  std::vector<NodeId> position;
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    const auto& form = forms[id];
    if (argument_count(node.op) > 0 && form && !form->empty() && chosen(id, *form)) {
      if (const auto replacement = FormBuilder(result, position, node.name).append(*form)) {
        if (result.node(*replacement).op != Op::kConstant) build.name(*replacement, node.name);
        position.push_back(*replacement);
        continue;
      }
    }
    position.push_back(build.append(moved(node, position)));
  }
  for (Output& output : result.outputs) output.node = position[output.node];
  return share(result);
}

// Rewrites all sums at once, because the square in [v] (c1 v^2 + c0) saves operations only if several sums share it.
Kernel with_factored_sums(const Kernel& kernel) {
  const auto is_sum = [&kernel](NodeId id, const Form& form) {
    return kernel.node(id).op != Op::kMul && form.size() == 2;
  };
  Kernel candidate = rebuilt(kernel, forms_of(kernel), is_sum);
  return cost(candidate).operations() < cost(kernel).operations() ? candidate : kernel;
}

// The first product whose rewrite saves operations, if there is one.
std::optional<Kernel> with_better_product(const Kernel& kernel) {
  const Forms forms = forms_of(kernel);
  const std::vector<bool> live = live_nodes(kernel);
  const int operations = cost(kernel).operations();
  for (NodeId target = 0; target < kernel.size(); ++target) {
    const auto& form = forms[target];
    if (!live[target] || !form || form->size() != 1) continue;
    Kernel candidate = rebuilt(kernel, forms, [target](NodeId id, const Form&) { return id == target; });
    if (cost(candidate).operations() < operations) return candidate;
  }
  return std::nullopt;
}

}  // namespace

Kernel factor(const Kernel& kernel) {
  if (kernel.factored || kernel.nodes.size() > kMostNodes) return kernel;
  Kernel result = with_factored_sums(kernel);
  while (std::optional<Kernel> better = with_better_product(result)) result = std::move(*better);
  return result;
}

}  // namespace sh::codegen::passes
