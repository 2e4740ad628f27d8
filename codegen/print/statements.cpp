#include "codegen/print/statements.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace sh::codegen::print {
namespace {

enum Precedence { kSum = 1, kProduct = 2, kAtom = 3 };

struct Expression {
  std::string text;
  Precedence precedence = kAtom;
};

std::string bracketed(const Expression& e, bool needed) { return needed ? "(" + e.text + ")" : e.text; }

std::string infix(const Expression& left, const char* sign, const Expression& right, Precedence precedence) {
  // All operators group to the left, so the left operand keeps its own level and the right one does not.
  return bracketed(left, left.precedence < precedence) + sign + bracketed(right, right.precedence <= precedence);
}

// Names of the elements of flattened arrays: "x" for a scalar, "r[3]" for an element.
std::vector<std::string> element_names(const std::vector<Parameter>& arrays, const std::vector<std::string>& names) {
  std::vector<std::string> elements;
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    for (int i = 0; i < arrays[a].size(); ++i) {
      elements.push_back(arrays[a].shape.empty() ? names[a] : names[a] + "[" + std::to_string(i) + "]");
    }
  }
  return elements;
}

std::vector<std::string> parameter_names(const Kernel& kernel) {
  std::vector<std::string> names;
  for (const Parameter& parameter : kernel.parameters) names.push_back(parameter.name);
  return names;
}

class Lister {
 public:
  Lister(const Kernel& kernel, const std::vector<std::string>& result_names)
      : kernel_(kernel),
        uses_(kernel.nodes.size(), 0),
        expressions_(kernel.nodes.size()),
        inputs_(element_names(kernel.parameters, parameter_names(kernel))),
        results_(element_names(kernel.results, result_names)),
        taken_(result_names.begin(), result_names.end()) {
    for (const Parameter& parameter : kernel.parameters) taken_.insert(parameter.name);
    for (const Node& node : kernel.nodes) {
      for (int i = 0; i < argument_count(node.op); ++i) ++uses_[index(node.args[index(i)])];
    }
  }

  Listing list() {
    const std::vector<bool> live = live_nodes(kernel_);
    for (NodeId id = 0; id < kernel_.size(); ++id) {
      if (live[index(id)]) visit(id);
    }
    return std::move(listing_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void visit(NodeId id) {
    const Node& node = kernel_.node(id);
    std::vector<std::size_t> stores;
    for (std::size_t i = 0; i < kernel_.outputs.size(); ++i) {
      if (kernel_.outputs[i].node == id) stores.push_back(i);
    }
    Expression& expression = expressions_[index(id)];
    expression = express(node);
    const bool computed = argument_count(node.op) > 0;
    if (computed && (uses_[index(id)] + static_cast<int>(stores.size()) > 1)) {
      const std::string name = unique_name(node);
      listing_.statements.push_back({name, false, expression.text, ""});
      expression = {name, kAtom};
    }
    for (const std::size_t i : stores) {
      listing_.statements.push_back({results_[i], true, expression.text, kernel_.outputs[i].label});
    }
  }

  Expression express(const Node& node) {
    const auto arg = [&](int i) -> const Expression& { return expressions_[index(node.args[index(i)])]; };
    switch (node.op) {
      case Op::kInput:
        return {inputs_[index(node.input)], kAtom};
      case Op::kConstant:
        listing_.constants.push_back({unique_name(node), node.constant});
        return {listing_.constants.back().name, kAtom};
      case Op::kNeg:
        return {"-" + bracketed(arg(0), arg(0).precedence < kAtom), kProduct};
      case Op::kAdd:
        return {infix(arg(0), " + ", arg(1), kSum), kSum};
      case Op::kSub:
        return {infix(arg(0), " - ", arg(1), kSum), kSum};
      case Op::kMul:
        return {infix(arg(0), " * ", arg(1), kProduct), kProduct};
      case Op::kFma:
        break;
    }
    throw std::invalid_argument(kernel_.name + ": cannot print " + op_name(node.op) +
                                "; only + - * and unary - are printed");
  }

  // The node's hint, or "xy" for x * y, or a numbered name; never one that is taken.
  std::string unique_name(const Node& node) {
    std::string name = node.name;
    if (name.empty() && node.op == Op::kMul) {
      const std::string& left = expressions_[index(node.args[0])].text;
      const std::string& right = expressions_[index(node.args[1])].text;
      if (left.size() == 1 && right.size() == 1) name = left == right ? left + "2" : left + right;
    }
    if (name.empty()) name = node.op == Op::kConstant ? "k" : "t";
    std::string candidate = name;
    for (int i = 2; !taken_.insert(candidate).second; ++i) candidate = name + "_" + std::to_string(i);
    return candidate;
  }

  const Kernel& kernel_;
  std::vector<int> uses_;
  std::vector<Expression> expressions_;
  std::vector<std::string> inputs_;
  std::vector<std::string> results_;
  std::set<std::string> taken_;
  Listing listing_;
};

}  // namespace

Listing make_listing(const Kernel& kernel, const std::vector<std::string>& result_names) {
  return Lister(kernel, result_names).list();
}

std::vector<std::string> statement_lines(const Listing& listing, const std::string& indent,
                                         const std::string& declaration) {
  std::vector<std::string> lines;
  std::size_t width = 0;
  for (const Statement& s : listing.statements) {
    lines.push_back(indent + (s.is_store ? "" : declaration) + s.target + " = " + s.expression + ";");
    if (!s.comment.empty()) width = std::max(width, lines.back().size());
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& comment = listing.statements[i].comment;
    if (!comment.empty()) lines[i] += std::string(width - lines[i].size(), ' ') + "  // " + comment;
  }
  return lines;
}

std::vector<std::string> align_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line += std::string(widths[i] - row[i].size(), ' ');
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace sh::codegen::print
