// Recipes: evaluate a function with given coefficients at a direction, in one or three channels, without storing the
// basis.
//
//   chebyshev  sum over orders of A_m (sum of c T_n over even n + T_1 (c + sum of c E_n over odd n)): coefficients
//              multiply the polynomials of chebyshev_columns.hpp instead of both sectoral functions
//   columns    the same with those of parity_columns.hpp
//   sum        the scalar product of the coefficients with the basis by parity
#include <utility>

#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/basis/chebyshev_columns.hpp"

namespace sh::codegen::recipes {
namespace {

constexpr const char* kUnitDirection = "|d| = 1 for d = (x, y, z); z is the polar axis; any c";
constexpr const char* kOrder = "coefficients of the orthonormal Y_lm, no Condon-Shortley phase, at index l(l+1)+m";

// The factors of the orders and the polynomials.
template <class Columns>
struct Functions {
  std::vector<Pair> sectoral;
  Columns columns;
};

Functions<ParityColumns> by_parity(SignedBuilder& build, const Direction& d, int degree) {
  const Squares squares = unit_squares(build, d.z);
  const ParityChoices choices = accurate_choices(degree);
  std::vector<Pair> sectoral = append_sectoral(build, d, degree, squares, choices.split_square);
  return {std::move(sectoral), {build, d.z, squares, degree, choices}};
}

Functions<ChebyshevColumns> by_chebyshev(SignedBuilder& build, const Direction& d, int degree) {
  const Squares squares = chebyshev_squares(build, d);
  std::vector<Pair> sectoral = append_sectoral(build, d, degree, squares, false);
  return {std::move(sectoral), {build, d.z, squares, degree}};
}

// The sums of products of coefficients and functions.
template <class Columns>
class Evaluation {
 public:
  Evaluation(SignedBuilder& build, const Functions<Columns>& functions, int degree)
      : build_(build), functions_(functions), degree_(degree) {}

  // The sum over all columns for one channel.
  NodeId channel(int index) {
    offset_ = index * coefficient_count(degree_);
    // The sum starts with the largest order, so that it adds the large terms of low degree last.
    Value sum;
    for (int m = degree_; m > 0; --m) {
      sum = build_.plus(sum, build_.times(column(m, m), {functions_.sectoral[m].cosine}));
      sum = build_.plus(sum, build_.times(column(m, -m), {functions_.sectoral[m].sine}));
    }
    return build_.plus(sum, column(0, 0)).node;
  }

 private:
  Value coefficient(int l, int m) { return {build_.input(offset_ + coefficient_index(l, m), "")}; }

  // sum over n of c T_n for order `signed_m` = +-m
  Value column(int m, int signed_m) {
    Value even;
    Value odd;
    for (int n = degree_ - m; n > 1; --n) {
      Value& sum = n % 2 == 0 ? even : odd;
      sum = build_.plus(sum, build_.times(coefficient(m + n, signed_m), {functions_.columns.at(m, n)}));
    }
    if (m < degree_) odd = build_.times(build_.plus(odd, coefficient(m + 1, signed_m)), {functions_.columns.at(m, 1)});
    Value lowest = coefficient(m, signed_m);
    if (m == 0) lowest = build_.times(lowest, {functions_.columns.at(0, 0)});
    const Value last = build_.plus(even, lowest);
    return build_.plus(odd, last);
  }

  SignedBuilder& build_;
  const Functions<Columns>& functions_;
  int degree_;
  int offset_ = 0;
};

void describe(Kernel& kernel, int degree, int channels) {
  const int count = coefficient_count(degree);
  kernel.domain = kUnitDirection;
  kernel.factored = true;
  const std::string bands = "bands 0 to " + std::to_string(degree);
  if (channels == 1) {
    kernel.title = "The value of a function with " + bands + " in one direction";
    kernel.result = std::string("returns the sum of c_lm Y_lm(d); c: ") + kOrder;
    kernel.parameters = with_direction({array(Role::kEvaluatedCoefficients, "c", degree)});
    kernel.results = {parameter(Role::kValue, "value")};
    kernel.outputs = {{-1, ""}};
  } else {
    kernel.title = "The value of a colour with " + bands + " in one direction";
    kernel.result = std::string("red, green, blue: the sums of c_lm Y_lm(d); c (3, ") + std::to_string(count) +
                    "), channel by channel: " + kOrder;
    kernel.parameters = with_direction({array(Role::kEvaluatedCoefficients, "c", degree, 3)});
    kernel.results = {{"rgb", {3}, Role::kValue}};
    kernel.outputs = {{-1, "red"}, {-1, "green"}, {-1, "blue"}};
  }
}

template <class Columns>
Kernel by_columns(int degree, int channels, const char* source,
                  Functions<Columns> (*append)(SignedBuilder&, const Direction&, int)) {
  Kernel kernel;
  describe(kernel, degree, channels);
  kernel.citation = source;
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build, channels * coefficient_count(degree));
  const Functions<Columns> functions = append(build, d, degree);
  Evaluation<Columns> evaluation(build, functions, degree);
  for (int channel = 0; channel < channels; ++channel) {
    kernel.outputs[channel].node = evaluation.channel(channel);
  }
  return kernel;
}

Kernel by_sum(int degree, int channels) {
  Kernel kernel;
  describe(kernel, degree, channels);
  kernel.citation = kParitySource;
  SignedBuilder build(kernel);
  const int count = coefficient_count(degree);
  const Direction d = direction_inputs(build, channels * count);
  const std::vector<NodeId> values = append_parity(build, d, degree, accurate_choices(degree));
  for (int channel = 0; channel < channels; ++channel) {
    Value sum;
    for (int i = count - 1; i >= 0; --i) {
      const NodeId c = build.input(channel * count + i, "");
      sum = build.plus(sum, {build.mul(c, values[i])});
    }
    kernel.outputs[channel].node = sum.node;
  }
  return kernel;
}

}  // namespace

Kernel evaluate_columns(int degree) { return by_columns(degree, 1, kParitySource, by_parity); }
Kernel evaluate_sum(int degree) { return by_sum(degree, 1); }
Kernel evaluate_rgb_chebyshev(int degree) { return by_columns(degree, 3, kChebyshevSource, by_chebyshev); }
Kernel evaluate_rgb_columns(int degree) { return by_columns(degree, 3, kParitySource, by_parity); }
Kernel evaluate_rgb_sum(int degree) { return by_sum(degree, 3); }

}  // namespace sh::codegen::recipes
