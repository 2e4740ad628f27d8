// Products of functions as bilinear forms of their coefficients, exact.
//
//     c_k = sum G_ijk a_i b_j,   c = the projection of a b on a chosen number of bands
//
// Convention: orthonormal, no Condon-Shortley phase, index l(l+1)+m. The factors and the result may have different
// numbers of bands. Two factors of degree a and b need a result of degree a + b to be exact: n bands times n bands give
// 2n - 1 bands. Entries come from gaunt() (gaunt.hpp); those that are zero are left out.
#pragma once

#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

/// factor * a_i * b_j (in a square: factor * a_i * a_j).
struct BilinearTerm {
  int i = 0;
  int j = 0;
  Surd factor;
};

/// One coefficient of the result: c_output = sum of terms, ordered by (i, j).
struct BilinearForm {
  int output = 0;
  std::vector<BilinearTerm> terms;
};

/// Degrees of the two factors and of the result.
struct ProductShape {
  int a = 0;
  int b = 0;
  int result = 0;
};

/// Limit of the degrees of the factors; that of the result is twice as large.
inline constexpr int kMaxProductDegree = 12;

/// c = a b, one form for each of the (result+1)^2 coefficients. Throws std::invalid_argument unless 0 <= a, b <=
/// kMaxProductDegree and 0 <= result <= a + b (every coefficient beyond a + b is zero).
std::vector<BilinearForm> product_form(const ProductShape& shape);

/// c = a^2: terms with i <= j only, the mixed ones doubled. Same limits.
std::vector<BilinearForm> square_form(int degree, int result);

/// c = a h for a zonal h about +z: j is the degree l of the zonal coefficient h_l. Same limits.
std::vector<BilinearForm> zonal_product_form(const ProductShape& shape);

/// The matrix that multiplies by a known function b [Green03] eq. 8, [SloanKautzSnyder02] eq. 7:
///     M_ij = integral b Y_i Y_j = sum_k b_k G_ijk,   projection of a b = M a.
/// shape.a is the degree of the columns, shape.b of the known function, shape.result of the rows. known: the exact
/// coefficients of b, (shape.b+1)^2 of them; throws std::invalid_argument for another count. Same limits as
/// product_form.
Matrix<RadicalSum> transfer_matrix(const std::vector<Surd>& known, const ProductShape& shape);

}  // namespace sh::symbolic
