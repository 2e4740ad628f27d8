#include "codegen/convention/in_convention.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/passes/passes.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention.hpp"

namespace sh::codegen {
namespace {

using symbolic::Convention;
using symbolic::SignedPermutation;
using symbolic::Surd;

const std::vector<Pass> kPasses{{"associate", passes::associate}, {"schedule", passes::schedule}};

// The place of each element of our flattened arrays in their arrays, and its factor: theirs[place] = factor * ours.
struct Layout {
  std::vector<Parameter> arrays;  // their arrays
  std::vector<int> place;         // place of each of our elements
  std::vector<Surd> factor;
};

const Convention& our_convention() { return symbolic::presets().front().convention; }

// Y'_lm = s Y_lm for a real convention without axes.
Surd function_scale(const Convention& convention, int l, int m) {
  return convention_factor(convention, l, m) / convention_factor(our_convention(), l, m);
}

// Y' = s Y and c' = c / s times the folded factor. Evaluated coefficients multiply the basis as they are stored.
Surd stored_factor(const Convention& convention, Role role, int l, int m) {
  Surd scale = function_scale(convention, l, m);
  if (role == Role::kBasisValues || role == Role::kBasisGradient) return scale;
  if (role == Role::kEvaluatedCoefficients) return scale.inverse();
  return scale.inverse() * folded_factor(convention.folded, l);
}

// True for arrays by degree and order, which the convention stores in its own order.
bool has_index_order(Role role) {
  return role == Role::kCoefficients || role == Role::kEvaluatedCoefficients || role == Role::kIrradiance ||
         role == Role::kLight || role == Role::kBasisValues || role == Role::kBasisGradient;
}

// True if the functions of the convention decide the numbers of the array.
bool depends_on_functions(const Parameter& array) {
  return has_index_order(array.role) || array.role == Role::kZonalCoefficients || array.role == Role::kBandMatrices;
}

// True if the numbers belong to the caller's axes.
bool depends_on_axes(const Parameter& array) {
  return is_coordinate(array.role) || array.role == Role::kRotationMatrix || array.role == Role::kQuaternion ||
         array.role == Role::kLinearForm || array.role == Role::kQuadraticForm;
}

// An element of an array: its place in their array, and its factor.
struct Stored {
  int place;
  Surd factor{1};
};

Stored stored_function(const Convention& convention, const Parameter& array, int i) {
  const int count = array.shape.back();
  const auto [l, m] = symbolic::degree_order(i % count);
  return {
      i / count * storage_size(convention.order, array.degree) + storage_position(convention.order, array.degree, l, m),
      stored_factor(convention, array.role, l, m)};
}

// The place of order m among the functions of its band.
int place_in_band(const Convention& convention, int l, int m) {
  int before = 0;
  for (int other = -l; other <= l; ++other) {
    before += storage_position(convention.order, l, l, other) < storage_position(convention.order, l, l, m) ? 1 : 0;
  }
  return before;
}

// c' = F c gives D' = F D F^-1; rows and columns as the convention orders a band.
Stored stored_band_entry(const Convention& convention, int i) {
  int l = 0;
  int first = 0;
  for (; i - first >= (2 * l + 1) * (2 * l + 1); ++l) first += (2 * l + 1) * (2 * l + 1);
  const int row = (i - first) / (2 * l + 1) - l;
  const int column = (i - first) % (2 * l + 1) - l;
  return {first + (2 * l + 1) * place_in_band(convention, l, row) + place_in_band(convention, l, column),
          stored_factor(convention, Role::kCoefficients, l, row) /
              stored_factor(convention, Role::kCoefficients, l, column)};
}

// Element i of a tensor of `rank` 1 or 2 with indices x, y, z and, for forms, a fourth that stays: T' = P T (P^T).
Stored stored_tensor_entry(const SignedPermutation& axes, int size, int rank, int i) {
  const auto place = [&](int k) { return k < 3 ? axes.axis(k) : k; };
  const auto sign = [&](int k) { return k < 3 ? axes.sign(k) : 1; };
  if (rank == 1) return {place(i), Surd(sign(i))};
  return {size * place(i / size) + place(i % size), Surd(sign(i / size) * sign(i % size))};
}

// w, then the axis of the turn, a vector that a reflection turns around.
Stored stored_quaternion_entry(const SignedPermutation& axes, int i) {
  if (i == 0) return {0};
  return {1 + axes.axis(i - 1), Surd(axes.determinant() * axes.sign(i - 1))};
}

// The constant, then the coefficients of y, z, x.
Stored stored_linear_entry(const SignedPermutation& axes, int i) {
  if (i == 0) return {0};
  const auto [place, sign] = stored_tensor_entry(axes, 3, 1, i % 3);
  return {place == 0 ? 3 : place, sign};
}

Stored stored(const Convention& convention, const SignedPermutation& axes, const Parameter& array, int i) {
  if (has_index_order(array.role)) return stored_function(convention, array, i);
  switch (array.role) {
    case Role::kZonalCoefficients:
      return {i, stored_factor(convention, array.role, i, 0)};
    case Role::kBandMatrices:
      return stored_band_entry(convention, i);
    case Role::kRotationMatrix:
      return stored_tensor_entry(axes, 3, 2, i);
    case Role::kQuadraticForm:
      return stored_tensor_entry(axes, 4, 2, i);
    case Role::kQuaternion:
      return stored_quaternion_entry(axes, i);
    case Role::kLinearForm:
      return stored_linear_entry(axes, i);
    default:
      return {i};
  }
}

// Appends an array as the convention stores it.
void append(Layout& layout, const Parameter& array, const Convention& convention, const SignedPermutation& axes) {
  Parameter theirs = array;
  if (has_index_order(array.role)) theirs.shape.back() = storage_size(convention.order, array.degree);
  // Our coordinate `axis` is a coordinate of the caller with a sign; x, y, z follow each other.
  const bool turns = is_coordinate(array.role);
  const int first = total_size(layout.arrays) + (turns ? (axes.axis(array.axis) - array.axis) * theirs.size() : 0);
  const Surd sign(turns ? axes.sign(array.axis) : 1);
  for (int i = 0; i < array.size(); ++i) {
    const Stored element = stored(convention, axes, array, i);
    layout.place.push_back(first + element.place);
    layout.factor.push_back(sign * element.factor);
  }
  layout.arrays.push_back(std::move(theirs));
}

Layout layout_of(const std::vector<Parameter>& arrays, const Convention& convention) {
  Layout layout;
  for (const Parameter& array : arrays) append(layout, array, convention, convention.axes);
  return layout;
}

// Our inputs or outputs as the convention stores them. Places without an element are zero.
std::vector<cln::cl_F> as_stored(const std::vector<cln::cl_F>& ours, const Layout& layout, int digits) {
  std::vector<cln::cl_F> theirs(total_size(layout.arrays), cln::cl_float(0, cln::float_format(digits)));
  for (std::size_t i = 0; i < ours.size(); ++i) {
    theirs[layout.place[i]] = ours[i] * layout.factor[i].evaluate(digits);
  }
  return theirs;
}

std::vector<cln::cl_F> as_ours(const std::vector<cln::cl_F>& theirs, const Layout& layout, int digits) {
  std::vector<cln::cl_F> ours;
  for (std::size_t i = 0; i < layout.place.size(); ++i) {
    ours.push_back(theirs[layout.place[i]] / layout.factor[i].evaluate(digits));
  }
  return ours;
}

// The place of one of our outputs.
std::size_t output_place(const Kernel& kernel, const Layout& outputs, std::size_t output) {
  return static_cast<std::size_t>(outputs.place[kernel.element(output)]);
}

// "d/dy l=1 m=0" names the caller's coordinate of the array that holds the derivative.
std::string label_in(const std::vector<Parameter>& arrays, std::size_t place, std::string label) {
  for (const Parameter& array : arrays) {
    const auto size = static_cast<std::size_t>(array.size());
    if (place < size) {
      if (array.role == Role::kBasisGradient) label[3] = "xyz"[array.axis];
      break;
    }
    place -= size;
  }
  return label;
}

// The kernel with arrays in the layout of the convention.
Kernel relaid(Kernel kernel, const Layout& inputs, const Layout& outputs) {
  kernel = with_gauges(kernel, inputs.factor, outputs.factor);
  for (Node& node : kernel.nodes) {
    if (node.op == Op::kInput) node.input = inputs.place[node.input];
  }
  kernel.parameters = inputs.arrays;
  kernel.results = outputs.arrays;
  std::vector<Output> stored(total_size(outputs.arrays));
  for (std::size_t i = 0; i < kernel.outputs.size(); ++i) {
    const std::size_t place = output_place(kernel, outputs, i);
    stored[place] = kernel.outputs[i];
    stored[place].label = label_in(outputs.arrays, place, kernel.outputs[i].label);
  }
  // Places without one of our elements are zero. Elements that the kernel does not write stay unwritten.
  std::vector<bool> hole(stored.size(), true);
  for (const int place : outputs.place) hole[place] = false;
  NodeId none = -1;
  kernel.outputs.clear();
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (hole[i] && none < 0) none = Builder(kernel).constant(Surd(), "none");
    if (hole[i]) stored[i] = {none, "unused"};
    stored[i].element = static_cast<int>(i);
    if (stored[i].node >= 0) kernel.outputs.push_back(std::move(stored[i]));
  }
  return kernel;
}

// The reference for the outputs of `relaid`: the mapped values of our kernel at the points. The inputs are exact to the
// digits of the check.
Reference reference_in(const Kernel& kernel, const Kernel& relaid, const Reference& points, const Layout& inputs,
                       const Layout& outputs) {
  Evaluator<cln::cl_F> ours(kernel, kCheckDigits);
  Reference reference;
  for (const ReferencePoint& point : points) {
    std::vector<cln::cl_F> in;
    for (const cln::cl_RA& value : point.inputs) in.push_back(cln::cl_float(value, cln::float_format(kCheckDigits)));
    ReferencePoint mapped;
    for (const cln::cl_F& value : as_stored(in, inputs, kCheckDigits)) mapped.inputs.push_back(cln::rational(value));
    std::vector<cln::cl_F> all(outputs.place.size(), cln::cl_float(0, cln::float_format(kCheckDigits)));
    const std::vector<cln::cl_F> written = ours(in);
    for (std::size_t i = 0; i < written.size(); ++i) all[kernel.element(i)] = written[i];
    const std::vector<cln::cl_F> stored = as_stored(all, outputs, kCheckDigits);
    for (std::size_t i = 0; i < relaid.outputs.size(); ++i) mapped.outputs.push_back(stored[relaid.element(i)]);
    reference.push_back(std::move(mapped));
  }
  return reference;
}

Domain domain_in(const Kernel& kernel, const Domain& ours, const Layout& inputs, const Layout& outputs) {
  constexpr int kDigits = 40;
  std::vector<std::size_t> from(total_size(outputs.arrays), 0);
  std::vector<double> factor(from.size(), 1);
  for (std::size_t i = 0; i < outputs.place.size(); ++i) {
    from[outputs.place[i]] = i;
    factor[outputs.place[i]] = std::abs(cln::double_approx(outputs.factor[i].evaluate(20)));
  }
  const auto in_double = [](const std::vector<cln::cl_F>& values) {
    std::vector<double> result;
    result.reserve(values.size());
    for (const cln::cl_F& value : values) result.push_back(cln::double_approx(value));
    return result;
  };
  const auto exact = [](std::span<const double> values) {
    std::vector<cln::cl_F> result;
    for (const double value : values) result.push_back(cln::cl_float(value, cln::float_format(kDigits)));
    return result;
  };
  Domain domain = ours;
  domain.test_inputs = [=](int of_degree) {
    std::vector<std::vector<double>> mapped;
    for (const std::vector<double>& input : ours.test_inputs(of_degree))
      mapped.push_back(in_double(as_stored(exact(input), inputs, kDigits)));
    return mapped;
  };
  domain.size = [=, size = size_of(kernel, ours)](std::span<const double> theirs, std::size_t output) {
    return factor[output] * size(in_double(as_ours(exact(theirs), inputs, kDigits)), from[output]);
  };
  return domain;
}

// True if a result contains a product of two coefficients.
bool multiplies_coefficients(const Kernel& kernel) {
  std::vector<bool> of_input;
  for (const Parameter& p : kernel.parameters) of_input.insert(of_input.end(), p.size(), holds_coefficients(p.role));
  std::vector<bool> depends(kernel.nodes.size());
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    int dependent = node.op == Op::kInput && of_input[node.input] ? 1 : 0;
    for (const NodeId arg : arguments(node)) dependent += depends[arg] ? 1 : 0;
    if (node.op == Op::kMul && dependent == 2) return true;
    depends[id] = dependent > 0;
  }
  return false;
}

bool any_array(const Kernel& kernel, const std::function<bool(const Parameter&)>& property) {
  return std::any_of(kernel.parameters.begin(), kernel.parameters.end(), property) ||
         std::any_of(kernel.results.begin(), kernel.results.end(), property);
}

// Coefficients that hold A_l / pi cannot be multiplied or convolved again. In the value of a function at a direction,
// products of coefficients are lengths and angles of its bands.
void require_radiance(const Kernel& kernel, const std::string& name) {
  const auto has_role = [&](Role role) {
    return any_array(kernel, [role](const Parameter& array) { return array.role == role; });
  };
  const bool evaluates = has_role(Role::kDirection) && has_role(Role::kValue);
  const bool multiplies = has_role(Role::kSamples) || (!evaluates && multiplies_coefficients(kernel));
  const bool convolves = any_array(kernel, [](const Parameter& array) { return array.role == Role::kIrradiance; });
  if (!multiplies && !convolves) return;
  throw std::invalid_argument("convention " + name + ": expected coefficients of radiance for " +
                              (multiplies ? "a product" : "family " + kernel.family) +
                              ", got coefficients that include a clamped cosine");
}

// True if the numbers belong to the coordinates of the convention.
bool stays_in_convention(const Parameter& array) {
  return depends_on_functions(array) || array.role == Role::kMoments || array.role == Role::kPolynomial;
}

// An option that changes nothing would be ignored in silence.
void require_effect(const Kernel& kernel, const Convention& convention, const ConventionOptions& options) {
  const bool turns = any_array(kernel, depends_on_axes) && any_array(kernel, stays_in_convention);
  if (!options.axes.empty() && !turns)
    throw std::invalid_argument("--axes: expected a family with coefficients and directions, rotations or forms, got " +
                                kernel.family + ", which is the same for all axes");
  const bool changes = any_array(kernel, depends_on_functions) || (turns && !(convention.axes == SignedPermutation()));
  if (!options.convention.empty() && !changes)
    throw std::invalid_argument("--convention: expected a family with coefficients or basis functions, got " +
                                kernel.family + ", which is the same in every convention");
}

// The convention with its coordinates in terms of the caller's.
Convention chosen_convention(const Kernel& kernel, const ConventionOptions& options) {
  Convention convention =
      options.convention.empty() ? our_convention() : symbolic::find_preset(options.convention).convention;
  if (convention.complex)
    throw std::invalid_argument("convention " + options.convention + ": expected a real convention, got a complex one");
  int degree = kernel.degree;
  for (const auto* arrays : {&kernel.parameters, &kernel.results}) {
    for (const Parameter& array : *arrays) {
      const bool meets_visibility = array.role == Role::kSamples;
      degree = std::max(degree, meets_visibility ? 2 * array.degree : array.degree);
    }
  }
  require_convention(convention, degree);
  require_effect(kernel, convention, options);
  if (convention.folded != symbolic::Folded::kNothing) require_radiance(kernel, options.convention);
  if (!options.axes.empty()) convention.axes = convention.axes * SignedPermutation(options.axes);
  return convention;
}

// The texts of the recipe speak of this project's convention.
void describe_convention(Kernel& kernel, const Convention& convention, const ConventionOptions& options) {
  kernel.arguments += options.arguments();
  if (!options.convention.empty()) {
    const symbolic::Preset& preset = symbolic::find_preset(options.convention);
    kernel.domain = "in this project's own convention: " + kernel.domain;
    kernel.result = "arrays as " + preset.name + " has them (" + preset.source + ": " + preset.covers +
                    "); in this project's own convention: " + kernel.result;
    kernel.name += "_" + options.convention;
    std::replace(kernel.name.begin(), kernel.name.end(), '-', '_');
  }
  if (!(convention.axes == SignedPermutation()))
    kernel.domain += ". Directions, rotations and forms are in the caller's axes; this project's (x, y, z) are (" +
                     convention.axes.to_string() + ") there";
}

struct Converted {
  Kernel kernel;
  Layout inputs;
  Layout outputs;
};

Converted converted(const FinishedKernel& finished, const Reference& points, const ConventionOptions& options) {
  const Convention convention = chosen_convention(finished.kernel, options);
  const Layout inputs = layout_of(finished.kernel.parameters, convention);
  const Layout outputs = layout_of(finished.kernel.results, convention);
  Kernel kernel = relaid(finished.kernel, inputs, outputs);
  describe_convention(kernel, convention, options);
  const Reference reference = reference_in(finished.kernel, kernel, points, inputs, outputs);
  return {run_pipeline(std::move(kernel), reference, kPasses).back().kernel, inputs, outputs};
}

}  // namespace

std::string ConventionOptions::arguments() const {
  return (convention.empty() ? "" : " --convention " + convention) + (axes.empty() ? "" : " --axes " + axes);
}

Kernel converted_kernel(const FinishedKernel& finished, const Reference& points, const ConventionOptions& options) {
  return converted(finished, points, options).kernel;
}

FinishedKernel in_convention(const FinishedKernel& finished, const Reference& points,
                             const ConventionOptions& options) {
  Converted result = converted(finished, points, options);
  return finish(std::move(result.kernel), domain_in(finished.kernel, finished.domain, result.inputs, result.outputs));
}

}  // namespace sh::codegen
