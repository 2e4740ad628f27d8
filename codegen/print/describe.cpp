#include "codegen/print/describe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "codegen/ir/literal.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen::print {
namespace {

// "x, y, z" or "r (9), c (25)"
std::string list_of(const std::vector<Parameter>& arrays, const Dialect& dialect) {
  std::string text;
  for (const Parameter& array : arrays) {
    text += (text.empty() ? "" : ", ") + dialect.name(array.name);
    if (!array.shape.empty()) text += " (" + std::to_string(array.size()) + ")";
  }
  return text;
}

std::string cost_line(const Cost& cost) {
  std::string text = std::to_string(cost.mul) + " multiplications, " + std::to_string(cost.add) + " additions";
  for (const auto& [count, name] : {std::pair(cost.fma, "fused multiply-adds"),
                                    {cost.neg, "negations"},
                                    {cost.div, "divisions"},
                                    {cost.sqrt, "square roots"},
                                    {cost.select, "selections"}}) {
    if (count > 0) text += ", " + std::to_string(count) + " " + name;
  }
  return text + "; longest chain " + std::to_string(cost.depth) + "; at most " + std::to_string(cost.max_live) +
         " values live";
}

// Breaks long lines at spaces. Indents the rest like the first word after the label.
std::vector<std::string> wrapped(const std::vector<std::string>& lines) {
  constexpr std::size_t kWidth = 117;
  constexpr std::size_t kLabel = 14;
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    result.push_back(line);
    while (result.back().size() > kWidth) {
      const std::string last = result.back();
      const std::size_t space = last.rfind(' ', kWidth);
      if (space == std::string::npos || space <= kLabel) break;
      result.back() = last.substr(0, space);
      result.push_back(std::string(kLabel, ' ') + last.substr(space + 1));
    }
  }
  return result;
}

// "3.8e-07 (4.2 eps)"
std::string both_units(const Error& error) { return fmt::format("{:.1e} ({:.1f} eps)", error.absolute, error.eps); }

// The same, rounded upwards; without the absolute error where the bound states none.
std::string both_units(const bound::Bound& proved) {
  std::string eps = fmt::format("{:.1f} eps", raised(proved.eps, 1));
  if (proved.absolute == 0) return eps;
  const double unit = std::pow(10.0, std::floor(std::log10(proved.absolute)) - 1);
  return fmt::format("{:.1e} ({})", std::ceil(proved.absolute / unit) * unit, eps);
}

// The rows of one type.
std::vector<std::vector<std::string>> error_rows(const std::string& type, const MeasuredError& error, bool total) {
  const bool proved = error.proved && error.proved->is_proved();
  std::vector<std::vector<std::string>> rows{{"              " + type + "  ", "rounding",
                                              proved ? "  at most " + both_units(*error.proved) : "",
                                              "  largest seen " + both_units(error.rounding)}};
  if (total) rows.push_back({"", "total", "", "  largest seen " + both_units(error.total)});
  return rows;
}

// How the errors of a kernel were found.
std::vector<std::string> explained(const FinishedKernel& finished) {
  const MeasuredError& error = finished.in_float;
  std::vector<std::string> lines;
  lines.emplace_back("              rounding: against this formula in exact arithmetic at the same input");
  if (error.proved) {
    lines.push_back("              at most:  " + (error.proved->is_proved()
                                                      ? "proved for " + error.proved->domain +
                                                            "; operations round to nearest, with or without contraction"
                                                      : "no bound is proved: " + error.proved->missing));
  }
  const std::string nearest = nearest_point(finished.kernel.parameters);
  if (!nearest.empty()) lines.push_back("              total:    against the exact function at " + nearest);
  const std::string search =
      error.searched > 0 ? " and " + std::to_string(error.searched) + " evaluations of a search" : "";
  lines.push_back("              seen:     among " + std::to_string(error.inputs) + " " + finished.domain.inputs +
                  search + ", without contraction");
  return lines;
}

// The inputs with the largest errors, if they have few numbers.
std::vector<std::string> worst_inputs(const FinishedKernel& finished, const Dialect& dialect) {
  constexpr std::size_t kMostPrinted = 4;
  const std::vector<double>& in_float = finished.in_float.worst;
  if (finished.in_float.searched == 0 || in_float.empty() || in_float.size() > kMostPrinted) return {};
  const auto values = [](const std::vector<double>& input, const auto& decimal) {
    std::string text;
    for (const double value : input) text += (text.empty() ? "" : ", ") + decimal(value);
    return text;
  };
  const std::string name = list_of(finished.kernel.parameters, dialect) + " = ";
  return {"              worst:    float " + name +
              values(in_float, [](double value) { return decimal(static_cast<float>(value)); }),
          "                        double " + name +
              values(finished.in_double.worst, [](double value) { return decimal(value); })};
}

}  // namespace

double raised(double value, int places) {
  const double unit = std::pow(10.0, places);
  return std::ceil(value * unit) / unit;
}

std::string two_digits(double value) { return fmt::format("{:.1e}", value); }

std::vector<std::string> describe(const FinishedKernel& finished, const std::string& language, const Dialect& dialect) {
  const Kernel& kernel = finished.kernel;
  const Domain& domain = finished.domain;
  const std::string output = kernel.returns_scalar() ? "" : list_of(kernel.results, dialect) + ": ";
  std::vector<std::string> lines{kernel.title + ".",
                                 "",
                                 "Generated by: shgen emit " + kernel.arguments + " --lang " + language,
                                 "Licence:      MIT-0; paste it anywhere.",
                                 "",
                                 "Input:        " + list_of(kernel.parameters, dialect),
                                 "Domain:       " + kernel.domain,
                                 "Output:       " + output + kernel.result,
                                 "Recipe:       " + kernel.recipe,
                                 "Source:       " + kernel.citation,
                                 "Cost:         " + cost_line(finished.cost),
                                 "Error:        eps counts units of machine epsilon x " + domain.unit};
  const bool total = !nearest_point(kernel.parameters).empty();
  std::vector<std::vector<std::string>> rows = error_rows("float", finished.in_float, total);
  for (auto& row : error_rows("double", finished.in_double, total)) rows.push_back(std::move(row));
  for (std::string& row : align_columns(rows)) lines.push_back(std::move(row));
  for (std::string& line : explained(finished)) lines.push_back(std::move(line));
  std::vector<std::string> result = wrapped(lines);
  for (std::string& line : worst_inputs(finished, dialect)) result.push_back(std::move(line));
  return result;
}

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
    for (int i = 0; i < argument_count(node.op); ++i) operation += " %" + std::to_string(node.args[i]);
    if (node.op == Op::kInput) operation += " " + std::to_string(node.input);
    if (node.stride != 0) operation += " + " + std::to_string(node.stride) + " row";
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
