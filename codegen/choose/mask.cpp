#include "codegen/choose/mask.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "codegen/passes/passes.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

using Kind = KnownInput::Kind;

struct Coefficient {
  int l = 0;
  int m = 0;
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> items{""};
  for (const char c : list) {
    if (c == ',') {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

std::string joined(const std::vector<int>& items, const char* separator) {
  std::string text;
  for (const int item : items) text += (text.empty() ? "" : separator) + std::to_string(item);
  return text;
}

// Replaces every character that is neither a letter nor a digit by an underscore.
std::string as_name(const std::string& text) {
  std::string name;
  for (const char c : text) name += c == ',' || c == '-' ? '_' : c;
  return name;
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

Coefficient coefficient(const Parameter& array, int entry) {
  const int i = entry % std::max(1, entries(array));
  if (is_zonal(array)) return {i, 0};
  const symbolic::DegreeOrder lm = symbolic::degree_order(i);
  return {lm.degree, lm.order};
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
  switch (std::abs(m) % 4) {
    case 0:
      return {m >= 0, 0};
    case 2:
      return {m < 0, 0};
    case 1:
      return {true, 1};
    default:
      return {true, -1};
  }
}

Allowed allowed(const std::string& symmetry, const Coefficient& c) {
  const bool odd = c.m % 2 != 0;
  if (symmetry == "zonal") return {c.m == 0, 0};
  if (symmetry == "mirror-x") return {odd == (c.m < 0), 0};
  if (symmetry == "mirror-y") return {c.m >= 0, 0};
  if (symmetry == "mirror-z" || symmetry == "hemisphere") return {(c.l + c.m) % 2 == 0, 0};
  if (symmetry == "mirror-xy") return under_exchange(c.m);
  std::string known;
  for (const std::string& name : mask_symmetries()) known += (known.empty() ? "" : ", ") + name;
  throw std::invalid_argument("unknown symmetry '" + symmetry + "': expected one of: " + known);
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool is_kept(const MaskOptions& options, const Coefficient& c) {
  return (options.keep_bands.empty() || contains(options.keep_bands, c.l)) &&
         (options.keep_orders.empty() || contains(options.keep_orders, c.m));
}

// The combined effect of all symmetries and of the kept bands and orders.
Allowed allowed(const MaskOptions& options, const std::string& symmetries, const Coefficient& c) {
  Allowed result{is_kept(options, c), 0};
  if (symmetries.empty()) return result;
  for (const std::string& symmetry : split(symmetries)) {
    const Allowed one = allowed(symmetry, c);
    result.free = result.free && one.free;
    if (one.mirrored != 0) result.mirrored = one.mirrored;
  }
  return result;
}

// --- making a mask

void mask_array(Mask& mask, const Parameter& array, int first, const MaskOptions& options,
                const std::string& symmetries) {
  for (int entry = 0; entry < array.size(); ++entry) {
    KnownInput& known = mask.inputs[first + entry];
    const Coefficient c = coefficient(array, entry);
    const Allowed here = allowed(options, symmetries, c);
    if (!here.free) {
      known.kind = Kind::kZero;
    } else if (here.mirrored != 0) {
      // The coefficient of order |m| represents both orders; if one of them is zero, the other is zero too.
      const bool partner_free = allowed(options, symmetries, {c.l, -c.m}).free;
      if (!partner_free) known.kind = Kind::kZero;
      if (partner_free && c.m < 0) known = {here.mirrored > 0 ? Kind::kSame : Kind::kOpposite, first + entry - 2 * c.m};
    }
  }
}

int parse_entry(const std::string& item, int size) {
  const bool digits = !item.empty() && item.size() < 6 && item.find_first_not_of("0123456789") == std::string::npos;
  const int entry = digits ? std::stoi(item) : -1;
  if (entry < 0 || entry >= size) {
    throw std::invalid_argument("--outputs: expected a number from 0 to " + std::to_string(size - 1) +
                                " or a symmetry such as zonal, got '" + item + "'");
  }
  return entry;
}

void mask_result(Mask& mask, const Parameter& result, int first, const MaskOptions& options) {
  const int count = entries(result);
  const bool list = !options.outputs.empty() && options.outputs.find_first_not_of("0123456789,") == std::string::npos;
  std::vector<int> listed;
  if (list) {
    for (const std::string& item : split(options.outputs)) {
      listed.push_back(parse_entry(item, count > 0 ? count : result.size()));
    }
  }
  for (int entry = 0; entry < result.size(); ++entry) {
    bool wanted = !list || contains(listed, count > 0 ? entry % count : entry);
    if (count > 0) {
      wanted = wanted && allowed(options, list ? "" : options.outputs, coefficient(result, entry)).free;
    } else if (!list && !options.outputs.empty()) {
      throw std::invalid_argument("--outputs: expected a list of entries, because " + result.name +
                                  " holds no coefficients, got " + options.outputs);
    }
    if (!wanted) mask.wanted[first + entry] = false;
  }
}

void require_in_range(const char* option, const std::vector<int>& values, int least, int most) {
  for (const int value : values) {
    if (value >= least && value <= most) continue;
    throw std::invalid_argument(std::string(option) + ": expected " + std::to_string(least) + " to " +
                                std::to_string(most) + ", got " + std::to_string(value));
  }
}

// In arrays that are updated in place, entries that are known to be zero do not change.
void drop_unchanged(Mask& mask, const Kernel& kernel) {
  int first_result = 0;
  for (const Parameter& result : kernel.results) {
    int first = 0;
    for (const Parameter& parameter : kernel.parameters) {
      for (int i = 0; parameter.name == result.name && i < parameter.size(); ++i) {
        if (mask.inputs[first + i].kind == Kind::kZero) mask.wanted[first_result + i] = false;
      }
      first += parameter.size();
    }
    first_result += result.size();
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
  int first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    std::vector<int> read;
    bool zero = false;
    bool equal = false;
    for (int i = 0; i < parameter.size(); ++i) {
      const Kind kind = mask.inputs[first + i].kind;
      zero = zero || kind == Kind::kZero;
      equal = equal || kind == Kind::kSame || kind == Kind::kOpposite;
      if (kind == Kind::kFree) read.push_back(i);
    }
    first += parameter.size();
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
  int first = 0;
  for (const Parameter& result : kernel.results) {
    std::vector<int> written;
    for (int i = 0; i < result.size(); ++i) {
      if (mask.wanted[first + i]) written.push_back(i);
    }
    if (static_cast<int>(written.size()) < result.size())
      text += "; of " + result.name + " only entries " + numbered(result, written) + " are written";
    first += result.size();
  }
  return text;
}

}  // namespace

bool MaskOptions::empty() const {
  return left.empty() && right.empty() && outputs.empty() && keep_bands.empty() && keep_orders.empty();
}

std::string MaskOptions::arguments() const {
  std::string text;
  if (!left.empty()) text += " --left " + left;
  if (!right.empty()) text += " --right " + right;
  if (!keep_bands.empty()) text += " --keep-bands " + joined(keep_bands, ",");
  if (!keep_orders.empty()) text += " --keep-orders=" + joined(keep_orders, ",");
  if (!outputs.empty()) text += " --outputs " + outputs;
  return text;
}

std::string MaskOptions::suffix() const {
  std::string text;
  if (!left.empty()) text += "_left_" + as_name(left);
  if (!right.empty()) text += "_right_" + as_name(right);
  if (!keep_bands.empty()) text += "_bands_" + joined(keep_bands, "_");
  if (!keep_orders.empty()) {
    text += "_orders";
    for (const int m : keep_orders) text += (m < 0 ? "_n" : "_") + std::to_string(std::abs(m));
  }
  if (!outputs.empty()) text += "_outputs_" + as_name(outputs);
  return text;
}

const std::vector<std::string>& mask_symmetries() {
  static const std::vector<std::string> kSymmetries{"zonal",    "mirror-x",   "mirror-y",
                                                    "mirror-z", "hemisphere", "mirror-xy"};
  return kSymmetries;
}

Mask make_mask(const Kernel& kernel, const MaskOptions& options) {
  require_in_range("--keep-bands", options.keep_bands, 0, kernel.degree);
  require_in_range("--keep-orders", options.keep_orders, -kernel.degree, kernel.degree);
  Mask mask;
  int first = 0;
  int arrays = 0;
  for (const Parameter& parameter : kernel.parameters) {
    mask.inputs.resize(mask.inputs.size() + static_cast<std::size_t>(parameter.size()));
    if (entries(parameter) > 0) {
      const std::string symmetries = arrays == 0 ? options.left : arrays == 1 ? options.right : "";
      mask_array(mask, parameter, first, options, symmetries);
      ++arrays;
    }
    first += parameter.size();
  }
  if ((!options.left.empty() && arrays < 1) || (!options.right.empty() && arrays < 2)) {
    throw std::invalid_argument(kernel.family + " has " + std::to_string(arrays) +
                                " coefficient arrays; --left is for the first and --right for the second");
  }
  first = 0;
  for (const Parameter& result : kernel.results) {
    mask.wanted.resize(mask.wanted.size() + static_cast<std::size_t>(result.size()), true);
    if (!kernel.returns_scalar()) mask_result(mask, result, first, options);
    first += result.size();
  }
  if (kernel.returns_scalar() && !options.outputs.empty()) {
    throw std::invalid_argument("--outputs: expected no such option, because " + kernel.family + " returns one number");
  }
  drop_unchanged(mask, kernel);
  if (std::find(mask.wanted.begin(), mask.wanted.end(), true) == mask.wanted.end())
    throw std::invalid_argument("mask: expected at least one result of " + kernel.family +
                                ", got a mask that leaves no result");
  return mask;
}

Kernel apply_mask(const Kernel& kernel, const Mask& mask) {
  Kernel result = kernel;
  result.nodes.clear();
  result.outputs.clear();
  Builder build(result);
  std::vector<NodeId> position;
  for (const Node& original : kernel.nodes) {
    Node node = original;
    const KnownInput known = node.op == Op::kInput ? mask.inputs[node.input] : KnownInput{};
    for (NodeId& arg : node.args) {
      if (arg >= 0) arg = position[arg];
    }
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
