#include "codegen/recipes/rotation/band_matrices.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Coupling;
using symbolic::Matrix;
using symbolic::Surd;

// Computes one band from the band below, in the orthonormal basis.
class NextBand {
 public:
  NextBand(SignedBuilder& build, const std::array<NodeId, 9>& r, int degree, const Matrix<Value>& below)
      : build_(build), r_(r), degree_(degree), below_(below), couplings_(symbolic::band_couplings(degree)) {}

  Matrix<Value> entries() {
    const int l = degree_;
    Matrix<Value> result(2 * l + 1, 2 * l + 1);
    for (int m = -l; m <= l; ++m) {
      for (int n = 1 - l; n < l; ++n) result(l + m, l + n) = column(n, n, {coupled(m, kZ, n)});
      result(l + m, 2 * l) = column(l, l - 1, {coupled(m, kX, l - 1), -coupled(m, kY, 1 - l)});
      result(l + m, 0) = column(-l, l - 1, {coupled(m, kX, 1 - l), coupled(m, kY, l - 1)});
    }
    return result;
  }

 private:
  static constexpr int kX = 0;
  static constexpr int kY = 1;
  static constexpr int kZ = 2;

  // The rational recursion in the entries k_m/k_n T_mn. The factor that depends only on the column comes last.
  Value column(int n, int n_below, const std::vector<Value>& terms) {
    const Surd factor = symbolic::orthonormal_factor(degree_ - 1, n_below) / symbolic::orthonormal_factor(degree_, n) *
                        Surd(symbolic::column_scale(degree_, n));
    return build_.times(factor, build_.sum(terms));
  }

  // sum over the couplings of row m of R(axis, coordinate) D_below(below, n)
  Value coupled(int m, int coordinate, int n) {
    std::vector<Value> products;
    for (const Coupling& c : couplings_[degree_ + m]) {
      const Surd factor = symbolic::orthonormal_factor(degree_, m) /
                          symbolic::orthonormal_factor(degree_ - 1, c.below) * Surd(c.weight);
      const Value entry = build_.times(factor, {r_[3 * c.axis + coordinate]});
      products.push_back(build_.times(entry, below_(degree_ - 1 + c.below, degree_ - 1 + n)));
    }
    return build_.sum(products);
  }

  SignedBuilder& build_;
  const std::array<NodeId, 9>& r_;
  int degree_;
  const Matrix<Value>& below_;
  std::vector<std::vector<Coupling>> couplings_;
};

}  // namespace

BandMatrices recursive_bands(SignedBuilder& build, const std::array<NodeId, 9>& r, int degree) {
  BandMatrices bands{Matrix<Value>(1, 1, {{build.constant(Surd(1))}})};
  if (degree >= 1) bands.push_back(band_one(r));
  for (int l = 2; l <= degree; ++l) bands.push_back(NextBand(build, r, l, bands.back()).entries());
  return bands;
}

}  // namespace sh::codegen::recipes
