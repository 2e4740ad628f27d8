// The rounding errors of a kernel on one box of inputs, by reverse interval analysis.
//
// Let F(d) be an output if every node v adds d_v to its exact result, and every constant differs from its exact value by
// d_v. The kernel in floating point computes F(d) for some |d_v| <= D_v; the reference is F(0). By the mean value theorem
// F(d) - F(0) is the sum of dF/dd_v(t d) d_v for one t in [0, 1]. The forward pass encloses every node for all such t d,
// so the reverse pass encloses the derivatives there, and the sum of |dF/dd_v| D_v bounds the error with all its terms of
// higher order. Intervals have their ends rounded outwards.
//
// A compiler may contract a * b + c to one rounding, for any of the uses of the product. That leaves out d_v of the
// product for these uses: the derivative of a product's d_v is therefore the largest over all subsets of its uses by
// additions.
#pragma once

#include "codegen/bound/form.hpp"
#include "codegen/bound/region.hpp"

namespace sh::codegen::bound {

/// A linear form of the absolute values of the coefficients, with factors that are not negative.
class Magnitudes {
 public:
  /// inputs: the number of flattened inputs.
  explicit Magnitudes(std::size_t inputs) : factors_(inputs + 1) {}

  double& operator[](Monomial m) { return factors_[m]; }
  [[nodiscard]] double one() const { return factors_[0]; }
  [[nodiscard]] double of(std::size_t input) const { return factors_[input + 1]; }
  [[nodiscard]] std::size_t inputs() const { return factors_.size() - 1; }
  void clear() { std::fill(factors_.begin(), factors_.end(), 0.0); }

 private:
  std::vector<double> factors_;
};

class RoundingAnalysis {
 public:
  /// kernel: straight. Throws std::domain_error, which says why, for a kernel that it cannot analyze.
  RoundingAnalysis(const Kernel& kernel, const Region& region, Format format);

  /// Computes the values on a box. Throws std::domain_error if a value may overflow or a divisor may be zero.
  void move_to(const Box& box);
  /// A bound of the error of an output on the box of the last call.
  const Magnitudes& error(std::size_t output);

  /// The sign of the derivative of an output by every flattened input, at the box of the last call: 1 or -1; 0 where it
  /// depends on the other inputs or has no fixed sign.
  std::vector<int> signs(std::size_t output);

  /// The number of nodes that the error of an output visits.
  [[nodiscard]] std::size_t cost(std::size_t output) const { return reach_[output].size(); }

 private:
  struct Step {
    Op op = Op::kInput;
    std::array<NodeId, 4> args{};
    int input = -1;
    RoundedConstant constant;
    bool computed = false;      // an operation that may round
    bool relative = false;      // it rounds also where the result is a normal number
    bool contractible = false;  // a product, or its negative: an addition that uses it may take it unrounded
    bool split = false;         // the same with several uses, of which a compiler may contract some
    double tiny = 0;            // the error of a subnormal result
  };

  void describe(const Kernel& kernel, const Region& region);
  void describe_operation(Step& step) const;
  void set_tiny(const Kernel& kernel, const Region& region);
  void set_reach();

  void forward(NodeId id, const Box& box);
  void exact_result(const Step& step, Form& result);
  [[nodiscard]] double exact_magnitude(const Step& step, Interval result) const;
  void round_number(NodeId id, Interval exact);
  void round_form(NodeId id);
  [[nodiscard]] int sum_grid(const Step& step) const;

  void reverse(std::size_t output);
  void pass_on(NodeId id);
  void pass_to(NodeId user, NodeId argument);
  void pass_quotient(NodeId id);
  void pass_root(NodeId id);
  void add_error(NodeId id, Magnitudes& error);
  [[nodiscard]] const Form& of_rounding(NodeId id) const;

  Format format_;
  std::vector<int> coordinate_;
  bool homogeneous_;
  std::vector<Step> steps_;
  std::vector<NodeId> outputs_;
  std::vector<std::vector<NodeId>> reach_;  // for every output: the nodes that it depends on, the last first
  std::vector<Form> values_;
  std::vector<double> absolute_;    // the error of a number
  std::vector<int> grid_;           // the computed number is a multiple of 2^grid
  std::vector<Form> derivatives_;   // of the present output by a change of the node
  std::vector<Form> by_roundings_;  // of the present output by the node's own rounding, for split nodes
  Form constants_;                  // the present output's error from constants
  Form part_, factor_;
  Magnitudes error_;  // of the present output
};

}  // namespace sh::codegen::bound
