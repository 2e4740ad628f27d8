#include "codegen/print/statements.hpp"

#include <algorithm>
#include <map>
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

Expression infix(const Expression& left, const char* sign, const Expression& right, Precedence precedence) {
  // All operators group to the left, so the left operand keeps its own level and the right one does not.
  return {bracketed(left, left.precedence < precedence) + sign + bracketed(right, right.precedence <= precedence),
          precedence};
}

// An element of a flattened array.
struct Element {
  std::string form;   // "x" for a scalar, "r[$at]" for an element
  std::string local;  // the variable it is copied to where it has to be
  int index = 0;      // within its array
  bool may_be_overwritten = false;

  // "x", "r[3]", or "r[8 * row + 3]" if it moves on from row to row.
  [[nodiscard]] std::string name(int stride = 0) const {
    const std::string row = std::to_string(stride) + " * " + kRow;
    const std::string here = std::to_string(index);
    return filled(form, {{"at", stride == 0 ? here : index == 0 ? row : row + " + " + here}});
  }
};

std::vector<Element> elements_of(const std::vector<Parameter>& arrays, const Dialect& dialect, bool read) {
  std::vector<Element> elements;
  for (const Parameter& array : arrays) {
    const std::string name = dialect.name(array.name);
    const bool shared = read && is_shared(array.role) && !dialect.shared_element.empty();
    for (int i = 0; i < array.size(); ++i) {
      std::string form = array.shape.empty() ? name : name + "[$at]";
      if (shared) form = filled(dialect.shared_element, {{"element", form}});
      elements.push_back({std::move(form), name + std::to_string(i), i, false});
    }
  }
  return elements;
}

// An array parameter may be the result array itself when both have the same shape.
void mark_overwritten(std::vector<Element>& inputs, const Kernel& kernel) {
  std::size_t first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const auto size = parameter.size();
    const bool overwritten = !parameter.shape.empty() &&
                             std::any_of(kernel.results.begin(), kernel.results.end(),
                                         [&](const Parameter& result) { return result.shape == parameter.shape; });
    for (std::size_t i = first; i < first + size; ++i) inputs[i].may_be_overwritten = overwritten;
    first += size;
  }
}

class Lister {
 public:
  Lister(const Kernel& kernel, const Dialect& dialect)
      : kernel_(kernel),
        dialect_(dialect),
        uses_(kernel.nodes.size(), 0),
        expressions_(kernel.nodes.size()),
        inputs_(elements_of(kernel.parameters, dialect, true)),
        results_(elements_of(kernel.results, dialect, false)),
        stores_(kernel.nodes.size()),
        users_(kernel.nodes.size(), -1),
        phases_(phases(kernel)),
        last_phase_(phases_) {
    taken_ = dialect.reserved;
    mark_overwritten(inputs_, kernel);
    if (has_loop()) taken_.insert({kRow, kRowStart, dialect.table_name(kernel.name)});
    for (const auto& names : {&kernel.parameters, &kernel.results}) {
      for (const Parameter& parameter : *names) taken_.insert(dialect.name(parameter.name));
    }
    for (std::size_t i = 0; i < kernel.outputs.size(); ++i) stores_[kernel.outputs[i].node].push_back(i);
    const std::vector<bool> live = live_nodes(kernel);
    for (NodeId id = 0; id < kernel.size(); ++id) {
      if (!live[id]) continue;
      live_.push_back(id);
      const Node& node = kernel.node(id);
      for (int i = 0; i < argument_count(node.op); ++i) {
        ++uses_[node.args[i]];
        users_[node.args[i]] = id;
        Phase& last = last_phase_[node.args[i]];
        last = std::max(last, node.op == Op::kRowSum ? Phase::kBody : phases_[id]);
      }
    }
    for (const NodeId id : live_) {
      const Node& node = kernel.node(id);
      if (node.op != Op::kInput) continue;
      Element& element = inputs_[node.input];
      if (is_read_by_own_store(id)) element.may_be_overwritten = false;
      // Stores follow the loop.
      if (has_loop() && last_phase_[id] != Phase::kAfter && stores_[id].empty()) element.may_be_overwritten = false;
      if (element.may_be_overwritten) overwritable_[element.index].push_back(id);
    }
  }

  Listing list() {
    visit_all(Phase::kBefore);
    if (has_loop()) {
      list_loop();
      for (const NodeId id : live_) {
        if (phases_[id] == Phase::kBefore) store_all(id);
      }
      visit_all(Phase::kAfter);
    }
    return std::move(listing_);
  }

 private:
  [[nodiscard]] const Element& result_of(std::size_t output) const { return results_[kernel_.element(output)]; }

  void add(const std::string& text, const std::string& comment = {}) {
    listing_.statements.push_back({text, comment, in_loop_});
  }

  [[nodiscard]] bool has_loop() const { return !kernel_.table.empty(); }

  void visit_all(Phase phase) {
    for (const NodeId id : live_) {
      if (phases_[id] == phase && kernel_.node(id).op != Op::kRowSum) visit(id);
    }
  }

  void list_loop() {
    std::vector<NodeId> sums;
    for (const NodeId id : live_) {
      const Node& node = kernel_.node(id);
      if (node.op != Op::kRowSum) continue;
      sums.push_back(id);
      expressions_[id] = {unused_name(node.name.empty() ? "sum" : node.name), kAtom};
      add(dialect_.scalar + " " + expressions_[id].text + " = " + dialect_.literal(symbolic::Surd()) + ";");
    }
    const std::string rows = std::to_string(kernel_.table.size());
    add(std::string("for (int ") + kRow + " = 0; " + kRow + " < " + rows + "; ++" + kRow + ") {");
    in_loop_ = true;
    add(std::string("int ") + kRowStart + " = " + std::to_string(kernel_.table[0].size()) + " * " + kRow + ";");
    for (const NodeId id : live_) {
      const Node& node = kernel_.node(id);
      if (node.op == Op::kRowSum) {
        const Expression& sum = expressions_[id];
        add(sum.text + " = " + infix(sum, " + ", expressions_[node.args[0]], kSum).text + ";");
      } else if (phases_[id] == Phase::kBody) {
        visit(id);
      }
    }
    in_loop_ = false;
    add("}");
    for (const NodeId sum : sums) store_all(sum);
  }

  // True when the element is needed only by the expression that is stored at its own index.
  [[nodiscard]] bool is_read_by_own_store(NodeId id) const {
    if (kernel_.results.size() != 1) return false;  // the element of another result might be stored before
    const int element = inputs_[kernel_.node(id).input].index;
    for (NodeId at = id;; at = users_[at]) {
      const std::vector<std::size_t>& stores = stores_[at];
      if (uses_[at] + static_cast<int>(stores.size()) != 1) return false;
      if (!stores.empty()) return result_of(stores[0]).index == element;
    }
  }

  void visit(NodeId id) {
    const Node& node = kernel_.node(id);
    const std::vector<std::size_t>& stores = stores_[id];
    if (node.op == Op::kInput) {
      if (!stores.empty()) load(id);
    } else {
      expressions_[id] = express(node);
      const bool kept = last_phase_[id] != phases_[id] || (postponed(id) && !stores.empty());
      if (argument_count(node.op) > 0 && (kept || uses_[id] + static_cast<int>(stores.size()) > 1)) {
        const std::string name = unique_name(node);
        add(dialect_.variable + name + " = " + expressions_[id].text + ";");
        expressions_[id] = {name, kAtom};
      }
    }
    if (!postponed(id)) store_all(id);
  }

  // Nothing is stored before or in the loop.
  [[nodiscard]] bool postponed(NodeId id) const { return has_loop() && phases_[id] != Phase::kAfter; }

  void store_all(NodeId id) {
    for (const std::size_t i : stores_[id]) store(i, expressions_[id]);
  }

  void store(std::size_t output, const Expression& expression) {
    const std::string& label = kernel_.outputs[output].label;
    if (kernel_.returns_scalar()) {
      add("return " + expression.text + ";", label);
      return;
    }
    const Element& result = result_of(output);
    if (expression.text == result.name()) return;  // an element that stays as it is
    for (const NodeId input : overwritable_[result.index]) load(input);
    add(result.name() + " = " + expression.text + ";", label);
  }

  // The element under its name, or as a variable when a store might change it.
  void load(NodeId id) {
    Expression& expression = expressions_[id];
    if (!expression.text.empty()) return;
    const Element& element = inputs_[kernel_.node(id).input];
    const std::string name = element.name(kernel_.node(id).stride);
    expression = {name, kAtom};
    if (!element.may_be_overwritten) return;
    expression.text = unused_name(element.local);
    add(dialect_.variable + expression.text + " = " + name + ";");
  }

  Expression express(const Node& node) {
    for (int i = 0; i < argument_count(node.op); ++i) {
      if (kernel_.node(node.args[i]).op == Op::kInput) load(node.args[i]);
    }
    const auto arg = [&](int i) -> const Expression& { return expressions_[node.args[i]]; };
    switch (node.op) {
      case Op::kConstant:
        listing_.constants.push_back({unique_name(node), node.constant});
        return {listing_.constants.back().name, kAtom};
      case Op::kNeg:
        return {"-" + bracketed(arg(0), arg(0).precedence < kAtom), kProduct};
      case Op::kAdd:
        return infix(arg(0), " + ", arg(1), kSum);
      case Op::kSub:
        return infix(arg(0), " - ", arg(1), kSum);
      case Op::kMul:
        return infix(arg(0), " * ", arg(1), kProduct);
      case Op::kDiv:
        return infix(arg(0), " / ", arg(1), kProduct);
      case Op::kSqrt:
        return {dialect_.square_root + "(" + arg(0).text + ")", kAtom};
      case Op::kSelect:
        return {filled(dialect_.select,
                       {{"a", arg(0).text}, {"b", arg(1).text}, {"then", arg(2).text}, {"otherwise", arg(3).text}}),
                kAtom};
      case Op::kTable:
        return {filled(dialect_.table_entry, {{"table", dialect_.table_name(kernel_.name)},
                                              {"at", std::string(kRowStart) + "+" + std::to_string(node.input)}}),
                kAtom};
      case Op::kInput:
      case Op::kFma:
      case Op::kRowSum:
        break;
    }
    throw std::invalid_argument(kernel_.name + ": cannot print " + op_name(node.op) +
                                "; only + - * / unary - sqrt and select are printed");
  }

  // The node's hint, or "xy" for x * y, or a numbered name; never one that is taken.
  std::string unique_name(const Node& node) {
    std::string name = node.name;
    if (name.empty() && node.op == Op::kMul) {
      const std::string& left = expressions_[node.args[0]].text;
      const std::string& right = expressions_[node.args[1]].text;
      if (left.size() == 1 && right.size() == 1) name = left == right ? left + "2" : left + right;
    }
    return unused_name(name.empty() ? (node.op == Op::kConstant ? "k" : "t") : name);
  }

  std::string unused_name(const std::string& name) {
    std::string candidate = name;
    for (int& i = copies_[name]; !taken_.insert(candidate).second; ++i) candidate = name + "_" + std::to_string(i + 2);
    return candidate;
  }

  const Kernel& kernel_;
  const Dialect& dialect_;
  std::vector<NodeId> live_;
  std::vector<int> uses_;
  std::vector<Expression> expressions_;
  std::vector<Element> inputs_;
  std::vector<Element> results_;
  std::vector<std::vector<std::size_t>> stores_;  // outputs, by node
  std::vector<NodeId> users_;                     // the last node that uses a node
  std::vector<Phase> phases_;
  std::vector<Phase> last_phase_;                    // of the users of a node
  std::map<int, std::vector<NodeId>> overwritable_;  // input nodes that a store may change, by index in their array
  std::set<std::string> taken_;
  std::map<std::string, int> copies_;
  Listing listing_;
  bool in_loop_ = false;
};

// Breaks a line that is too long in front of + and -.
std::vector<std::string> wrapped(const std::string& line, const std::string& indent) {
  constexpr std::size_t kWidth = 118;
  std::vector<std::string> lines{line};
  while (lines.back().size() > kWidth) {
    const std::string last = lines.back();
    const std::size_t at = std::max(last.rfind(" + ", kWidth) + 1, last.rfind(" - ", kWidth) + 1);
    if (at <= indent.size() + 4) break;
    lines.back() = last.substr(0, at - 1);
    lines.push_back(indent + "    " + last.substr(at));
  }
  return lines;
}

}  // namespace

Listing make_listing(const Kernel& kernel, const Dialect& dialect) { return Lister(kernel, dialect).list(); }

std::vector<std::string> statement_lines(const Listing& listing, const Dialect& dialect) {
  std::vector<std::string> lines;
  std::vector<std::pair<std::size_t, std::string>> comments;  // by line
  std::size_t width = 0;
  for (const Statement& s : listing.statements) {
    const std::string indent = dialect.indent + (s.in_loop ? dialect.indent : "");
    for (std::string& line : wrapped(indent + s.text, indent)) lines.push_back(std::move(line));
    if (s.comment.empty()) continue;
    width = std::max(width, lines.back().size());
    comments.emplace_back(lines.size() - 1, s.comment);
  }
  for (const auto& [line, comment] : comments) {
    lines[line] += std::string(width - lines[line].size(), ' ') + "  // " + comment;
  }
  return lines;
}

std::string wrapped_list(const std::vector<std::string>& items, std::size_t indent, std::size_t width) {
  std::string text;
  std::string line(indent, ' ');
  for (const std::string& item : items) {
    if (line.size() + item.size() + 2 > width) {
      text += line.substr(0, line.size() - 1) + "\n";
      line.assign(indent, ' ');
    }
    line += item + ", ";
  }
  return text + line.substr(0, line.size() - 2);
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
