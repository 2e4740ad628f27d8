#include "codegen/print/dump.hpp"

#include <sstream>

#include "codegen/ir/cost.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen::print {

std::string dump(const Kernel& kernel) {
  const Cost total = cost(kernel);
  const std::vector<bool> live = live_nodes(kernel);
  std::ostringstream text;
  text << kernel.name << ": " << kernel.nodes.size() << " nodes, mul " << total.mul << ", add " << total.add << ", fma "
       << total.fma << ", neg " << total.neg << ", chain " << total.depth << ", live " << total.max_live << '\n';
  std::vector<std::vector<std::string>> rows;
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    std::string operation = op_name(node.op);
    for (int i = 0; i < argument_count(node.op); ++i)
      operation += " %" + std::to_string(node.args[i]);
    if (node.op == Op::kInput) operation += " " + std::to_string(node.input);
    if (node.op == Op::kConstant) operation += " " + to_string(node.constant);
    std::string note = node.name.empty() ? "" : "  ; " + node.name;
    if (!live[id]) note += note.empty() ? "  ; dead" : ", dead";
    rows.push_back({"%" + std::to_string(id), " = " + operation, note});
  }
  for (std::string line : align_columns(rows)) {
    line.erase(line.find_last_not_of(' ') + 1);
    text << line << '\n';
  }
  for (std::size_t i = 0; i < kernel.outputs.size(); ++i) {
    text << "output " << kernel.element(i) << " = %" << kernel.outputs[i].node << "  ; " << kernel.outputs[i].label
         << '\n';
  }
  return text.str();
}

}  // namespace sh::codegen::print
