#include "codegen/recipes/parts.hpp"

namespace sh::codegen::recipes {

std::string degrees_to(int degree) { return degree == 0 ? "degree 0" : "degree 0 to " + std::to_string(degree); }

std::string numbered(const std::string& letter, int i) { return letter + std::to_string(i); }

std::string indexed(const std::string& letter, int l, int m) {
  return letter + "_" + std::to_string(l) + "_" + std::to_string(m);
}

Direction direction_inputs(Builder& build, int first) {
  const NodeId x = build.input(first, "x");
  const NodeId y = build.input(first + 1, "y");
  const NodeId z = build.input(first + 2, "z");
  return {x, y, z};
}

std::vector<NodeId> inputs(Builder& build, int first, int count, const std::string& letter) {
  std::vector<NodeId> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(build.input(first + i, numbered(letter, i)));
  return nodes;
}

void label_coefficients(Kernel& kernel, int degree, int channels) {
  constexpr const char* kChannels[] = {"red ", "green ", "blue "};
  for (int channel = 0; channel < channels; ++channel) {
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const std::string label = "l=" + std::to_string(l) + " m=" + std::to_string(m);
        kernel.outputs.push_back({-1, (channels == 1 ? "" : kChannels[channel]) + label});
      }
    }
  }
}

void set_outputs(Kernel& kernel, const std::vector<NodeId>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) kernel.outputs.at(i).node = nodes[i];
}

std::vector<NodeId> splice(Builder& build, const Kernel& part, const std::vector<NodeId>& inputs) {
  std::vector<NodeId> position;
  for (Node node : part.nodes) {
    if (node.op == Op::kInput) {
      position.push_back(inputs[node.input]);
      continue;
    }
    for (NodeId& arg : node.args) {
      if (arg >= 0) arg = position[arg];
    }
    position.push_back(build.append(std::move(node)));
  }
  std::vector<NodeId> results;
  for (const Output& output : part.outputs) results.push_back(position[output.node]);
  return results;
}

}  // namespace sh::codegen::recipes
