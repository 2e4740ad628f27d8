#include "symbolic/product/product_form.hpp"

#include <stdexcept>

#include "symbolic/number/derivation.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic {
namespace {

void require_factor_degree(int degree) {
  require_degree("factor of a product", degree, kMaxProductDegree, "the tensor grows with the fifth power");
}

void require_shape(const ProductShape& shape) {
  require_factor_degree(shape.a);
  require_factor_degree(shape.b);
  require_degree("result of a product", shape.result, shape.a + shape.b, "a product holds nothing beyond");
}

// Zero where a selection rule says so; the integral otherwise.
Surd selected(int i, int j, int k) { return gaunt_may_differ_from_zero(i, j, k) ? gaunt(i, j, k) : Surd(); }

// The second factor has seconds functions, whose indices `second` gives.
template <class Second>
std::vector<BilinearForm> forms_of(const ProductShape& shape, int seconds, const Second& second) {
  require_shape(shape);
  std::vector<BilinearForm> forms;
  for (int k = 0; k < coefficient_count(shape.result); ++k) {
    BilinearForm& form = forms.emplace_back(BilinearForm{k, {}});
    for (int i = 0; i < coefficient_count(shape.a); ++i) {
      for (int j = 0; j < seconds; ++j) {
        const Surd factor = selected(i, second(j), k);
        if (!factor.is_zero()) form.terms.push_back({i, j, factor});
      }
    }
  }
  return forms;
}

}  // namespace

std::vector<BilinearForm> product_form(const ProductShape& shape) {
  return forms_of(shape, coefficient_count(shape.b), [](int j) { return j; });
}

std::vector<BilinearForm> zonal_product_form(const ProductShape& shape) {
  return forms_of(shape, shape.b + 1, [](int l) { return coefficient_index(l, 0); });
}

std::vector<BilinearForm> square_form(int degree, int result) {
  std::vector<BilinearForm> forms;
  for (const BilinearForm& product : product_form({degree, degree, result})) {
    BilinearForm form{product.output, {}};
    for (const BilinearTerm& term : product.terms) {
      if (term.i > term.j) continue;
      form.terms.push_back({term.i, term.j, term.i == term.j ? term.factor : Surd(2) * term.factor});
    }
    forms.push_back(std::move(form));
  }
  return forms;
}

Matrix<RadicalSum> transfer_matrix(const std::vector<Surd>& known, const ProductShape& shape) {
  require_shape(shape);
  if (static_cast<int>(known.size()) != coefficient_count(shape.b)) {
    throw std::invalid_argument("transfer matrix: expected " + std::to_string(coefficient_count(shape.b)) +
                                " coefficients of the known function, got " + std::to_string(known.size()));
  }
  Matrix<RadicalSum> matrix(coefficient_count(shape.result), coefficient_count(shape.a));
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.columns(); ++column) {
      for (int k = 0; k < coefficient_count(shape.b); ++k) {
        matrix(row, column) += RadicalSum(selected(row, column, k) * known[k]);
      }
    }
  }
  return matrix;
}

}  // namespace sh::symbolic
