#include "symbolic/errata/ramamoorthi_rendering.hpp"

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/ramamoorthi_basis.hpp"
#include "symbolic/number/matrix.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic::errata {
namespace {

Polynomial axis(int i) { return i == 3 ? Polynomial(1) : Polynomial::variable(i); }

// One product in the upper triangle of M: sign * c_constant * L_(degree,order).
struct Place {
  int row;
  int column;
  int degree;
  int order;
  int sign;
  int constant;  // 1..5
};

}  // namespace

std::array<Surd, 5> ramamoorthi_constants() {
  return {Surd::square_root(ratio(15, 256), 1), Surd::square_root(ratio(3, 36), 1),
          Surd::square_root(ratio(45, 256), 1), Surd::square_root(ratio(1, 4), 1), Surd::square_root(ratio(5, 256), 1)};
}

Surd irradiance_band_factor(int degree) {
  return convolution_factor(degree) * zonal_family("clamped-cosine").integral(degree).at({});
}

std::vector<SurdTerm> matrix_form(int degree, int order) {
  constexpr std::array<Place, 11> upper{{{0, 0, 2, 2, 1, 1},
                                         {0, 1, 2, -2, 1, 1},
                                         {0, 2, 2, 1, 1, 1},
                                         {0, 3, 1, 1, 1, 2},
                                         {1, 1, 2, 2, -1, 1},
                                         {1, 2, 2, -1, 1, 1},
                                         {1, 3, 1, -1, 1, 2},
                                         {2, 2, 2, 0, 1, 3},
                                         {2, 3, 1, 0, 1, 2},
                                         {3, 3, 0, 0, 1, 4},
                                         {3, 3, 2, 0, -1, 5}}};
  std::vector<SurdTerm> terms;
  for (const Place& p : upper) {
    if (p.degree != degree || p.order != order) continue;
    const int times = p.row == p.column ? p.sign : 2 * p.sign;
    terms.push_back(
        {Surd(cln::cl_RA(times)) * ramamoorthi_constants()[to_size(p.constant - 1)], axis(p.row) * axis(p.column)});
  }
  return terms;
}

std::vector<SurdTerm> expanded_form(int degree, int order) {
  const Polynomial x = axis(0);
  const Polynomial y = axis(1);
  const Polynomial z = axis(2);
  const std::array<Surd, 5> c = ramamoorthi_constants();
  const Surd two(cln::cl_RA(2));
  switch (degree * (degree + 1) + order) {
    case 0:
      return {{c[3], Polynomial(1)}};
    case 1:
      return {{two * c[1], y}};
    case 2:
      return {{two * c[1], z}};
    case 3:
      return {{two * c[1], x}};
    case 4:
      return {{two * c[0], x * y}};
    case 5:
      return {{two * c[0], y * z}};
    case 6:
      return {{c[2], z * z}, {-c[4], Polynomial(1)}};
    case 7:
      return {{two * c[0], x * z}};
    default:
      return {{c[0], x * x - y * y}};
  }
}

bool renders_irradiance(Rendering form) {
  for (const PrintedFunction& f : ramamoorthi_functions()) {
    const BasisFunction y = reduced_basis_function(f.degree, f.order);
    std::vector<SurdTerm> sum = form(f.degree, f.order);
    sum.push_back({-(irradiance_band_factor(f.degree) * y.factor), y.axial * y.azimuthal});
    if (!vanishes(sum)) return false;
  }
  return true;
}

}  // namespace sh::symbolic::errata
