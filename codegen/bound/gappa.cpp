#include "codegen/bound/gappa.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "codegen/bound/size.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen::bound {
namespace {

std::string exact(double value) { return fmt::format("{:a}", value); }
std::string range(Interval interval) { return fmt::format("[{},{}]", exact(interval.low), exact(interval.high)); }

// Names: r3 is node 3 as the kernel computes it, e3 the same in exact arithmetic, d3 the rounding of a constant.
class Script {
 public:
  Script(const Kernel& kernel, const Region& region, const Format& format, const Box& box)
      : kernel_(kernel), region_(region), format_(format), box_(box), exact_(kernel.nodes.size(), false) {
    const std::string name = format.name == "half" ? "16" : format.name == "float" ? "32" : "64";
    text_ = "@rnd = float<ieee_" + name + ",ne>;\n";
    for (NodeId id = 0; id < kernel.size(); ++id) add(id);
  }

  std::string with_goal(NodeId output, double error) {
    const std::string name = std::to_string(output);
    return text_ + "\n{ " + facts_ + "\n  -> |r" + name + " - " + (exact_[output] ? "r" : "e") + name +
           "| <= " + exact(error) + " }\n";
  }

 private:
  void add(NodeId id) {
    const Node& node = kernel_.node(id);
    const std::string name = std::to_string(id);
    if (node.op == Op::kInput) {
      text_ += "r" + name + " = rnd(i" + name + ");\n";
      exact_[id] = true;
      add_fact("r" + name + " in " + range(box_[region_.coordinate[node.input]]));
    } else if (node.op == Op::kConstant) {
      add_constant(id, rounded(node.constant, format_));
    } else {
      text_ += "r" + name + " rnd= " + operation(node, false) + ";\n";
      text_ += "e" + name + " = " + operation(node, true) + ";\n";
    }
  }

  // The rounded constant is a number; the exact one differs from it by an unknown error in an interval.
  void add_constant(NodeId id, const RoundedConstant& constant) {
    const std::string name = std::to_string(id);
    const double exponent = constant.grid;
    const double number = std::nearbyint(std::ldexp(constant.value.low + constant.value.width() / 2, -constant.grid));
    text_ += "r" + name + " = " + fmt::format("{:.0f}b{:.0f}", number, exponent) + ";\n";
    exact_[id] = constant.error.is_zero();
    if (exact_[id]) return;
    text_ += "e" + name + " = r" + name + " - d" + name + ";\n";
    add_fact("d" + name + " in " + range(constant.error));
  }

  [[nodiscard]] std::string operation(const Node& node, bool exactly) const {
    const auto argument = [&](int i) {
      return (exactly && !exact_[node.args[i]] ? "e" : "r") + std::to_string(node.args[i]);
    };
    switch (node.op) {
      case Op::kNeg:
        return "-" + argument(0);
      case Op::kAdd:
        return argument(0) + " + " + argument(1);
      case Op::kSub:
        return argument(0) + " - " + argument(1);
      case Op::kMul:
        return argument(0) + " * " + argument(1);
      default:
        throw std::invalid_argument("--gappa: expected a kernel of + - *, got the operation " + op_name(node.op));
    }
  }

  void add_fact(const std::string& fact) { facts_ += (facts_.empty() ? "" : "\n  /\\ ") + fact; }

  const Kernel& kernel_;
  const Region& region_;
  const Format& format_;
  const Box& box_;
  std::vector<bool> exact_;  // the node is its own exact value: an input or an exact constant
  std::string text_;
  std::string facts_;
};

}  // namespace

std::string gappa_script(const Kernel& kernel, const Domain& domain, const Format& format, const Bound& proved) {
  const auto refuse = [&](const std::string& got) {
    throw std::invalid_argument("--gappa: expected a kernel of directions or single parameters, got " + got);
  };
  if (!proved.is_proved()) refuse("one without a bound: " + proved.missing);
  const Kernel nodes = passes::unroll(kernel);
  const Region region = region_of(nodes, domain, format);
  if (region.homogeneous) refuse("one of vectors of any length");
  if (std::count(region.coordinate.begin(), region.coordinate.end(), -1) > 0) refuse("one with coefficients");
  RoundingAnalysis analysis(nodes, region, format);
  analysis.move_to(proved.worst_box);
  std::size_t output = 0;
  double largest = 0;
  for (std::size_t i = 0; i < nodes.outputs.size(); ++i) {
    const double error = analysis.error(i).one();
    if (error <= largest) continue;
    largest = error;
    output = i;
  }
  return "# " + nodes.name + " in " + format.name + ": our bound on the box where it is largest.\n" +
         Script(nodes, region, format, proved.worst_box).with_goal(nodes.outputs[output].node, largest);
}

}  // namespace sh::codegen::bound
