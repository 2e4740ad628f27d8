// The rounding errors of kernels that multiply two linear forms of coefficients, such as products of functions.
//
// Such a kernel computes forms A_v a and B_v b of the arrays, products p = (A a)(B b) of two forms, and sums of products.
// To rounding v belongs an error of at most |D_v| epsilon/2 |v|, where D_v is the derivative of the output by v
// (rounding.hpp): D_v is a form of the other array before a product, and a number after it. As a sum of products is at
// most the sum of their magnitudes, the error of an output is at most a sum of t |l a| |r b|, which is at most
//     1/2 sum of t (w (l a)^2 + (r b)^2 / w)
// for any w > 0: two quadratic forms. We take w = |r| / |l|, which makes both parts of a term equal. So the largest eigenvalues of their matrices bound the error for all arrays of
// length 1. The signs of coefficients count in l and r: most of what a sum of magnitudes would add up cancels.
//
// Forms have intervals as factors, which hold them for all roundings (rounding.hpp). l is then a middle and a radius, and
// the triangle inequality takes the root of the sum of t w |radius|^2 as an addition to the root of the eigenvalue.
#pragma once

#include <optional>

#include "codegen/bound/form.hpp"
#include "codegen/bound/region.hpp"

namespace sh::codegen::bound {

/// True if the kernel multiplies coefficients and has no other inputs: then BilinearAnalysis serves it.
bool is_bilinear(const Kernel& kernel, const Region& region);

/// A bound of |error| <= bilinear |a| |b| + linear (|a| + |b|) + one for all arrays a and b, which may be the same.
struct BilinearError {
  double bilinear = 0;
  double linear = 0;  ///< from subnormal numbers, as `one`
  double one = 0;
  std::vector<double> worst;  ///< arrays of length 1 near which the bound is attained, flattened
};

class BilinearAnalysis {
 public:
  /// kernel: straight. Throws std::domain_error, which says why, for a kernel that it cannot analyze.
  BilinearAnalysis(const Kernel& kernel, const Format& format);

  BilinearError operator()(std::size_t output);

 private:
  // A form whose factors are intervals: middles, and the length of the radii.
  struct Row {
    std::vector<std::pair<int, double>> middle;  // (input, factor)
    double length = 0;
    double radius = 0;
    /// The largest value for an array of length 1.
    [[nodiscard]] double most() const { return length + radius; }
  };
  // Products of two forms of coefficients.
  struct Product {
    Row left, right;
  };
  struct Step {
    Op op = Op::kInput;
    std::array<NodeId, 4> args{};
    int degree = 0;             // in the coefficients
    double unit = 0;            // the largest error, of rounding and of a constant, relative to the value
    double tiny = 0;            // the error of a subnormal result
    bool contractible = false;  // an addition may take it unrounded
    bool split = false;         // the same with several uses: the error is counted for each of them
  };
  // factor |left x| |right x|
  struct Term {
    double factor = 0;
    const Row* left = nullptr;
    Row right;
  };
  // A matrix of the quadratic form of one array.
  struct Block {
    int first = 0, size = 0;
    std::vector<double> matrix;
    double radius = 0;  // the sum of all w |radius|^2
  };

  void forward(const Kernel& kernel, const Format& format);
  void require_range(const Format& format) const;
  void describe(const Node& node, const Format& format);
  void describe_product(const Node& node, const Format& format);
  void mark_split(const Kernel& kernel);
  void reverse(NodeId output, BilinearError& error);
  void pass_on(NodeId id, BilinearError& error);
  void pass_to(NodeId argument, bool to_negative, BilinearError& error);
  void add_rounding(NodeId id, const Form& derivative, BilinearError& error);
  void add_term(double factor, const Row& left, Row right);
  void bound_terms(BilinearError& error);
  void add_square(double factor, const Row& row);
  [[nodiscard]] static Row row_of(const Form& form);

  std::vector<int> block_of_;  // by input
  std::vector<Block> blocks_;
  std::vector<Step> steps_;
  std::vector<Form> values_;  // of coefficients, or of products
  std::vector<RoundedConstant> constants_;
  std::vector<Row> rows_;        // the values of degree 1
  std::vector<int> product_of_;  // by node: its product, or -1
  std::vector<Product> products_;
  std::vector<double> of_products_;  // the present output's error by every product
  std::vector<Form> derivatives_;
  std::vector<Term> terms_;
  std::vector<NodeId> outputs_;
  Form part_, factor_;
};

/// An upper bound of the largest eigenvalue of a symmetric matrix, row by row, without negative eigenvalues but for
/// roundings of a sum of squares; and a vector of length 1 near its eigenvector. From traces of its powers: the trace of
/// A^n is at least the n-th power of the eigenvalue.
struct LargestEigenvalue {
  double at_most = 0;
  std::vector<double> vector;
};
LargestEigenvalue largest_eigenvalue(std::vector<double> matrix, int size);

}  // namespace sh::codegen::bound
