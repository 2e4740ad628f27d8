#include "codegen/convention/in_convention.hpp"

#include <algorithm>
#include <cmath>
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
  const Surd scale = function_scale(convention, l, m);
  if (role == Role::kBasisValues || role == Role::kBasisGradient) return scale;
  if (role == Role::kEvaluatedCoefficients) return scale.inverse();
  return scale.inverse() * folded_factor(convention.folded, l);
}

bool has_index_order(Role role) {
  return role == Role::kCoefficients || role == Role::kEvaluatedCoefficients || role == Role::kBasisValues ||
         role == Role::kBasisGradient;
}

// Appends an array as the convention stores it.
void append(Layout& layout, const Parameter& array, const Convention& convention, const SignedPermutation& axes) {
  Parameter theirs = array;
  if (has_index_order(array.role)) theirs.shape.back() = storage_size(convention.order, array.degree);
  // Our coordinate `axis` is a coordinate of the caller with a sign; x, y, z follow each other.
  const bool turns = is_coordinate(array.role);
  const int shift = turns ? (axes.axis(array.axis) - array.axis) * theirs.size() : 0;
  const int first = total_size(layout.arrays) + shift;
  for (int i = 0; i < array.size(); ++i) {
    int place = i;
    Surd factor(turns ? axes.sign(array.axis) : 1);
    if (has_index_order(array.role)) {
      const int count = array.shape.back();
      const auto [l, m] = symbolic::degree_order(i % count);
      place = i / count * theirs.shape.back() + storage_position(convention.order, array.degree, l, m);
      factor = factor * stored_factor(convention, array.role, l, m);
    } else if (array.role == Role::kZonalCoefficients) {
      factor = stored_factor(convention, array.role, i, 0);
    } else if (array.role == Role::kRotationMatrix) {  // R' = P R P^T
      place = 3 * axes.axis(i / 3) + axes.axis(i % 3);
      factor = Surd(axes.sign(i / 3) * axes.sign(i % 3));
    }
    layout.place.push_back(first + place);
    layout.factor.push_back(factor);
  }
  layout.arrays.push_back(std::move(theirs));
}

Layout layout_of(const Kernel& kernel, const std::vector<Parameter>& arrays, const Convention& convention,
                 const SignedPermutation& axes) {
  Layout layout;
  for (const Parameter& array : arrays) {
    if (array.role == Role::kQuaternion || array.role == Role::kBandMatrices || array.role == Role::kQuadraticForm) {
      throw std::invalid_argument(kernel.family + ": expected roles that other conventions share, got " + array.name +
                                  " (" + role_name(array.role) + ")");
    }
    append(layout, array, convention, axes);
  }
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

// The kernel with arrays in the layout of the convention.
Kernel relaid(Kernel kernel, const Layout& inputs, const Layout& outputs) {
  kernel = with_gauges(kernel, inputs.factor, outputs.factor);
  for (Node& node : kernel.nodes) {
    if (node.op == Op::kInput) node.input = inputs.place[node.input];
  }
  kernel.parameters = inputs.arrays;
  kernel.results = outputs.arrays;
  std::vector<Output> stored(total_size(outputs.arrays));
  for (std::size_t i = 0; i < kernel.outputs.size(); ++i) stored[output_place(kernel, outputs, i)] = kernel.outputs[i];
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

Convention chosen_convention(const Kernel& kernel, const ConventionOptions& options) {
  const Convention convention =
      options.convention.empty() ? our_convention() : symbolic::find_preset(options.convention).convention;
  if (convention.complex)
    throw std::invalid_argument("convention " + options.convention + ": expected a real convention, got a complex one");
  int degree = kernel.degree;
  for (const Parameter& result : kernel.results) degree = std::max(degree, result.degree);
  require_convention(convention, degree);
  if (multiplies_coefficients(kernel) && convention.folded != symbolic::Folded::kNothing)
    throw std::invalid_argument("convention " + options.convention +
                                ": expected coefficients of radiance for a product, got coefficients that "
                                "include a clamped cosine");
  return convention;
}

}  // namespace

std::string ConventionOptions::arguments() const {
  return (convention.empty() ? "" : " --convention " + convention) + (axes.empty() ? "" : " --axes " + axes);
}

FinishedKernel in_convention(const FinishedKernel& finished, const Reference& points,
                             const ConventionOptions& options) {
  const Convention convention = chosen_convention(finished.kernel, options);
  const SignedPermutation axes = options.axes.empty() ? SignedPermutation() : SignedPermutation(options.axes);
  const Layout inputs = layout_of(finished.kernel, finished.kernel.parameters, convention, axes);
  const Layout outputs = layout_of(finished.kernel, finished.kernel.results, convention, axes);
  Kernel kernel = relaid(finished.kernel, inputs, outputs);
  kernel.arguments += options.arguments();
  if (!options.convention.empty()) {
    kernel.result = "arrays as " + options.convention + " has them (" +
                    symbolic::find_preset(options.convention).source +
                    "); in this project's own convention: " + finished.kernel.result;
    kernel.name += "_" + options.convention;
    std::replace(kernel.name.begin(), kernel.name.end(), '-', '_');
  }
  if (!options.axes.empty())
    kernel.domain += ". Directions are the caller's; the convention's coordinates are (" + options.axes + ") of them";
  const Reference reference = reference_in(finished.kernel, kernel, points, inputs, outputs);
  return finish(run_pipeline(std::move(kernel), reference, kPasses).back().kernel,
                domain_in(finished.kernel, finished.domain, inputs, outputs));
}

}  // namespace sh::codegen
