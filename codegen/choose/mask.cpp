#include "codegen/choose/mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "codegen/passes/passes.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

using Kind = KnownInput::Kind;
using symbolic::DegreeOrder;

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream stream(list + ",");
  for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
  return items;
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

// Replaces commas and hyphens by underscores.
std::string as_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '-'; }, '_');
  return text;
}

// "0-3, 6" for {0, 1, 2, 3, 6}
std::string ranges(const std::vector<int>& sorted) {
  std::string text;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i;
    while (end + 1 < sorted.size() && sorted[end + 1] == sorted[end] + 1) ++end;
    text += (text.empty() ? "" : ", ") + std::to_string(sorted[i]);
    if (end > i) text += (end > i + 1 ? "-" : ", ") + std::to_string(sorted[end]);
    i = end + 1;
  }
  return text;
}

// --- coefficient arrays

bool is_zonal(const Parameter& array) { return array.role == Role::kZonalCoefficients; }

// The number of entries of a channel, for arrays whose entries can have a symmetry; 0 for all other arrays.
int entries(const Parameter& array) {
  return is_zonal(array) || is_by_degree_and_order(array.role) ? array.shape.back() : 0;
}

// The place of an entry in its channel.
int in_channel(const Parameter& array, int entry) { return entry % std::max(1, entries(array)); }

DegreeOrder coefficient(const Parameter& array, int entry) {
  const int i = in_channel(array, entry);
  return is_zonal(array) ? DegreeOrder{i, 0} : symbolic::degree_order(i);
}

// --- symmetries

// The effect of a symmetry on a coefficient: whether the coefficient may differ from zero, and whether it equals plus
// or minus the coefficient of order -m.
struct Allowed {
  bool free = true;
  int mirrored = 0;  // +1, -1: the coefficient is this times the coefficient of order -m
};

// Exchanging x and y turns Re (x + iy)^m into Re i^m (x - iy)^m.
Allowed under_exchange(int m) {
  const int turns = std::abs(m) % 4;
  if (turns % 2 == 0) return {turns == 0 ? m >= 0 : m < 0, 0};
  return {true, turns == 1 ? 1 : -1};
}

struct Symmetry {
  const char* name;
  Allowed (*allowed)(int l, int m);
};

Allowed under_mirror_z(int l, int m) { return {(l + m) % 2 == 0, 0}; }

constexpr Symmetry kSymmetries[] = {
    {"zonal",
     [](int, int m) {
       return Allowed{m == 0, 0};
     }},
    {"mirror-x",
     [](int, int m) {
       return Allowed{(m % 2 != 0) == (m < 0), 0};
     }},
    {"mirror-y",
     [](int, int m) {
       return Allowed{m >= 0, 0};
     }},
    {"mirror-z", under_mirror_z},
    {"hemisphere", under_mirror_z},
    {"mirror-xy", [](int, int m) { return under_exchange(m); }},
};

Allowed allowed(const std::string& symmetry, const DegreeOrder& c) {
  std::string known;
  for (const Symmetry& one : kSymmetries) {
    if (symmetry == one.name) return one.allowed(c.degree, c.order);
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  throw std::invalid_argument("unknown symmetry '" + symmetry + "': expected one of: " + known);
}

// The combined effect of all symmetries and of the kept bands and orders.
Allowed allowed(const MaskOptions& options, const std::string& symmetries, const DegreeOrder& c) {
  Allowed result{(options.keep_bands.empty() || contains(options.keep_bands, c.degree)) &&
                     (options.keep_orders.empty() || contains(options.keep_orders, c.order)),
                 0};
  if (symmetries.empty()) return result;
  for (const std::string& symmetry : split(symmetries)) {
    const Allowed one = allowed(symmetry, c);
    result.free = result.free && one.free;
    if (one.mirrored != 0) result.mirrored = one.mirrored;
  }
  return result;
}

// --- making a mask

bool is_list(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789,") == std::string::npos;
}

int parse_entry(const char* option, const std::string& item, int size) {
  const bool digits = !item.empty() && item.size() < 6 && item.find_first_not_of("0123456789") == std::string::npos;
  const int entry = digits ? std::stoi(item) : -1;
  if (entry >= 0 && entry < size) return entry;
  throw std::invalid_argument(std::string(option) + ": expected a number from 0 to " + std::to_string(size - 1) +
                              " or a symmetry such as zonal, got '" + item + "'");
}

std::vector<int> parse_list(const char* option, const std::string& list, int size) {
  std::vector<int> listed;
  for (const std::string& item : split(list)) listed.push_back(parse_entry(option, item, size));
  return listed;
}

// The knowledge about an entry; `first` is the place of its array among the flattened inputs; symmetries: or a list of
// the entries that are not zero.
KnownInput known_input(const Parameter& array, int entry, int first, const MaskOptions& options,
                       const std::string& symmetries) {
  const DegreeOrder c = coefficient(array, entry);
  if (is_list(symmetries)) {
    const bool listed = contains(parse_list("--left, --right", symmetries, entries(array)), in_channel(array, entry));
    return {listed && allowed(options, "", c).free ? Kind::kFree : Kind::kZero, -1};
  }
  const Allowed here = allowed(options, symmetries, c);
  if (!here.free) return {Kind::kZero, -1};
  if (here.mirrored == 0) return {};
  // The coefficient of order |m| represents both orders; if one of them is zero, the other is zero too.
  if (!allowed(options, symmetries, {c.degree, -c.order}).free) return {Kind::kZero, -1};
  if (c.order > 0) return {};
  return {here.mirrored > 0 ? Kind::kSame : Kind::kOpposite, first + entry - 2 * c.order};
}

// For every entry of a result: whether it is wanted.
std::vector<bool> wanted_entries(const Parameter& result, const MaskOptions& options) {
  const int count = entries(result);
  const std::string& outputs = options.outputs;
  const bool list = is_list(outputs);
  if (count == 0 && !list && !outputs.empty()) {
    throw std::invalid_argument("--outputs: expected a list of entries, because " + result.name +
                                " holds no coefficients, got " + outputs);
  }
  const int size = count > 0 ? count : result.size();
  const std::vector<int> listed = list ? parse_list("--outputs", outputs, size) : std::vector<int>();
  std::vector<bool> wanted;
  for (int entry = 0; entry < result.size(); ++entry) {
    const bool is_allowed = count == 0 || allowed(options, list ? "" : outputs, coefficient(result, entry)).free;
    wanted.push_back(is_allowed && (!list || contains(listed, entry % size)));
  }
  return wanted;
}

void require_in_range(const char* option, const std::vector<int>& values, int least, int most) {
  for (const int value : values) {
    if (value >= least && value <= most) continue;
    throw std::invalid_argument(std::string(option) + ": expected " + std::to_string(least) + " to " +
                                std::to_string(most) + ", got " + std::to_string(value));
  }
}

// The place of an array among the flattened elements of all arrays.
int first_of(const std::vector<Parameter>& arrays, int position) {
  return total_size({arrays.begin(), arrays.begin() + position});
}

// In arrays that are updated in place, entries that are known to be zero do not change.
void drop_unchanged(Mask& mask, const Kernel& kernel) {
  int element = 0;
  for (const Parameter& result : kernel.results) {
    const int position = position_of(kernel.parameters, result.name);
    const int first = position < 0 ? 0 : first_of(kernel.parameters, position);
    for (int i = 0; i < result.size(); ++i, ++element) {
      if (position >= 0 && mask.inputs[first + i].kind == Kind::kZero) mask.wanted[element] = false;
    }
  }
}

// --- texts in the head of a file

// "0, 2, 6 (by l(l+1)+m)"
std::string numbered(const Parameter& array, const std::vector<int>& entries_of) {
  const bool by_index = entries(array) > 0 && !is_zonal(array) && array.shape.size() == 1;
  return ranges(entries_of) + (by_index ? " (by l(l+1)+m)" : "");
}

std::string read_entries(const Kernel& kernel, const Mask& mask) {
  std::string text;
  int element = 0;
  for (const Parameter& parameter : kernel.parameters) {
    std::vector<int> read;
    bool zero = false;
    bool equal = false;
    for (int i = 0; i < parameter.size(); ++i) {
      const Kind kind = mask.inputs[element++].kind;
      zero = zero || kind == Kind::kZero;
      equal = equal || kind == Kind::kSame || kind == Kind::kOpposite;
      if (kind == Kind::kFree) read.push_back(i);
    }
    if (!zero && !equal) continue;
    text += "; of " + parameter.name + (read.empty() ? " no entries" : " only entries " + numbered(parameter, read)) +
            " are read, the others are " + (zero ? "zero" : "") + (zero && equal ? " or " : "") +
            (equal ? "plus or minus one of these" : "") +
            (position_of(kernel.results, parameter.name) >= 0 ? " and stay so" : "");
  }
  return text;
}

std::string written_entries(const Kernel& kernel, const Mask& mask) {
  std::string text;
  int element = 0;
  for (const Parameter& result : kernel.results) {
    std::vector<int> written;
    for (int i = 0; i < result.size(); ++i) {
      if (mask.wanted[element++]) written.push_back(i);
    }
    if (static_cast<int>(written.size()) == result.size()) continue;
    text += "; of " + result.name + " only entries " + numbered(result, written) + " are written";
  }
  return text;
}

}  // namespace

std::string MaskOptions::arguments() const {
  std::string text;
  if (!left.empty()) text += " --left " + left;
  if (!right.empty()) text += " --right " + right;
  if (!keep_bands.empty()) text += fmt::format(" --keep-bands {}", fmt::join(keep_bands, ","));
  if (!keep_orders.empty()) text += fmt::format(" --keep-orders={}", fmt::join(keep_orders, ","));
  if (!outputs.empty()) text += " --outputs " + outputs;
  return text;
}

std::string MaskOptions::suffix() const {
  std::string text;
  if (!left.empty()) text += "_left_" + as_name(left);
  if (!right.empty()) text += "_right_" + as_name(right);
  if (!keep_bands.empty()) text += fmt::format("_bands_{}", fmt::join(keep_bands, "_"));
  if (!keep_orders.empty()) text += "_orders";
  for (const int m : keep_orders) text += (m < 0 ? "_n" : "_") + std::to_string(std::abs(m));
  if (!outputs.empty()) text += "_outputs_" + as_name(outputs);
  return text;
}

Mask make_mask(const Kernel& kernel, const MaskOptions& options) {
  require_in_range("--keep-bands", options.keep_bands, 0, kernel.degree);
  require_in_range("--keep-orders", options.keep_orders, -kernel.degree, kernel.degree);
  Mask mask;
  int arrays = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const bool has_symmetry = entries(parameter) > 0;
    const std::string symmetries = arrays == 0 ? options.left : arrays == 1 ? options.right : "";
    const int first = static_cast<int>(mask.inputs.size());
    for (int entry = 0; entry < parameter.size(); ++entry) {
      mask.inputs.push_back(has_symmetry ? known_input(parameter, entry, first, options, symmetries) : KnownInput{});
    }
    if (has_symmetry) ++arrays;
  }
  if ((!options.left.empty() && arrays < 1) || (!options.right.empty() && arrays < 2)) {
    throw std::invalid_argument(kernel.family + " has " + std::to_string(arrays) +
                                " coefficient arrays; --left is for the first and --right for the second");
  }
  if (kernel.returns_scalar() && !options.outputs.empty()) {
    throw std::invalid_argument("--outputs: expected no such option, because " + kernel.family + " returns one number");
  }
  for (const Parameter& result : kernel.results) {
    const std::vector<bool> wanted =
        kernel.returns_scalar() ? std::vector<bool>{true} : wanted_entries(result, options);
    mask.wanted.insert(mask.wanted.end(), wanted.begin(), wanted.end());
  }
  drop_unchanged(mask, kernel);
  if (std::find(mask.wanted.begin(), mask.wanted.end(), true) == mask.wanted.end()) {
    throw std::invalid_argument("mask: expected at least one result of " + kernel.family +
                                ", got a mask that leaves no result");
  }
  return mask;
}

Kernel apply_mask(const Kernel& kernel, const Mask& mask) {
  Kernel result = kernel;
  result.nodes.clear();
  result.outputs.clear();
  Builder build(result);
  std::vector<NodeId> position;
  for (const Node& original : kernel.nodes) {
    Node node = moved(original, position);
    const KnownInput known = node.op == Op::kInput ? mask.inputs[node.input] : KnownInput{};
    if (known.kind == Kind::kZero) {
      position.push_back(build.constant(symbolic::Surd(), "none"));
      continue;
    }
    if (known.kind != Kind::kFree) {
      node.input = known.of;
      node.name.clear();
    }
    const NodeId appended = build.append(std::move(node));
    position.push_back(known.kind == Kind::kOpposite ? build.neg(appended) : appended);
  }
  for (std::size_t i = 0; i < kernel.outputs.size(); ++i) {
    Output output = kernel.outputs[i];
    output.element = kernel.element(i);
    if (!mask.wanted[output.element]) continue;
    output.node = position[output.node];
    result.outputs.push_back(std::move(output));
  }
  result.domain += read_entries(kernel, mask);
  result.result += written_entries(kernel, mask);
  return passes::prune(passes::fold(result));
}

}  // namespace sh::codegen
