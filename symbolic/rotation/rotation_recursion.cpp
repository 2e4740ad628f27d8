#include "symbolic/rotation/rotation_recursion.hpp"

#include <cstdlib>

#include "symbolic/basis/normalisation.hpp"

namespace sh::symbolic {
namespace {

constexpr int kX = 0;
constexpr int kY = 1;
constexpr int kZ = 2;

// coordinate * S_(l-1,below) = sum over above of g S_(l,above) + (x^2+y^2+z^2)(...)
struct Ladder {
  int axis;
  int below;
  int above;
  cln::cl_RA g;
};

// The terms of one below = +-c: from (2l-1) sin(t) P_(l-1)^c = P_l^(c+1) - P_(l-2)^(c+1)
// = (l+c-1)(l+c-2) P_(l-2)^(c-1) - (l-c)(l-c+1) P_l^(c-1), P without the Condon-Shortley sign
// [AbramowitzStegun64] 8.5.3, 8.5.5, times cos or sin of (c +- 1) phi.
std::vector<Ladder> ladders_of(int l, int c) {
  const cln::cl_RA up = cln::cl_RA(1) / (2 * (2 * l - 1));
  const cln::cl_RA down = up * ((l - c) * (l - c + 1));
  if (c == 0) {
    return {{kZ, 0, 0, cln::cl_RA(l) / (2 * l - 1)}, {kX, 0, 1, 2 * up}, {kY, 0, -1, 2 * up}};
  }
  const cln::cl_RA axial = cln::cl_RA(l - c) / (2 * l - 1);
  std::vector<Ladder> list{{kZ, c, c, axial},    {kZ, -c, -c, axial}, {kX, c, c + 1, up},   {kX, c, c - 1, -down},
                           {kX, -c, -c - 1, up}, {kY, c, -c - 1, up}, {kY, -c, c + 1, -up}, {kY, -c, c - 1, -down}};
  if (c > 1) {  // the sine function of order 0 is zero
    list.push_back({kX, -c, -c + 1, -down});
    list.push_back({kY, c, -c + 1, down});
  }
  return list;
}

}  // namespace

std::vector<std::vector<Coupling>> band_couplings(int degree) {
  std::vector<std::vector<Coupling>> result(to_size(2 * degree + 1));
  for (int c = 0; c < degree; ++c) {
    for (const Ladder& ladder : ladders_of(degree, c)) {
      const cln::cl_RA weight =
          ladder.g * squared_factor(degree - 1, ladder.below) / squared_factor(degree, ladder.above);
      result[to_size(degree + ladder.above)].push_back({ladder.axis, ladder.below, weight});
    }
  }
  return result;
}

cln::cl_RA column_scale(int degree, int column) {
  const int a = std::abs(column);
  const cln::cl_RA inverse_g = a == degree ? cln::cl_RA(2 * degree - 1) : cln::cl_RA(2 * degree - 1) / (degree - a);
  return squared_factor(degree, a) / squared_factor(degree - 1, a == degree ? a - 1 : a) * inverse_g;
}

void require_recursion_degree(int degree, int limit) {
  if (degree < 0 || degree > limit) {
    throw std::invalid_argument("rotation recursion: degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(limit) + " (exact entries grow with the degree)");
  }
}

}  // namespace sh::symbolic
