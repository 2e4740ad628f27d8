#include "codegen/recipes/product/orbits.hpp"

#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// Even polynomials of z of degree at most 3L need floor(3L/2) + 1 nodes in t = z^2.
Rings rings_for(int degree) {
  const int nodes = 3 * degree / 2 + 1;
  return {nodes / 2, nodes % 2 != 0, false};
}

// M exceeds the largest frequency 3L. It is even, so the angles are symmetric about both axes.
int angles_for(int degree) { return 3 * degree + 1 + (3 * degree + 1) % 2; }

// The parities under x -> -x, y -> -y, z -> -z as bits 1, 2, 4.
int class_of(int i) {
  const auto [l, m] = symbolic::degree_order(i);
  const bool odd_m = m % 2 != 0;
  const bool x = m >= 0 ? odd_m : !odd_m;
  const bool z = (l + m) % 2 != 0;
  return (x ? 1 : 0) + (m < 0 ? 2 : 0) + (z ? 4 : 0);
}

std::vector<ClassRow> rows_of(int degree, const std::array<int, 4>& classes) {
  std::array<std::vector<int>, 4> members;
  std::size_t most = 0;
  for (std::size_t r = 0; r < classes.size(); ++r) {
    for (int i = 0; i < numeric::coefficient_count(degree); ++i) {
      if (class_of(i) == classes[r]) members[r].push_back(i);
    }
    most = std::max(most, members[r].size());
  }
  std::vector<ClassRow> rows(most, ClassRow{-1, -1, -1, -1});
  for (std::size_t r = 0; r < classes.size(); ++r) {
    for (std::size_t s = 0; s < members[r].size(); ++s) rows[s][r] = members[r][s];
  }
  return rows;
}

}  // namespace

OrbitQuadrature::OrbitQuadrature(int degree)
    : degree_(degree),
      angles_(angles_for(degree)),
      rings_(rings_for(degree)),
      rows_(rows_of(degree, {0, 2, 4, 1})),
      opposite_rows_(rows_of(degree, {7, 5, 3, 6})) {
  for (int ring = 0; ring < rings_.count(); ++ring) {
    for (int j = 0; rings_.is_pole(ring) ? j == 0 : 2 * (2 * j + 1) <= angles_; ++j) orbits_.push_back({ring, j});
  }
}

ExactReal OrbitQuadrature::value(int i, int orbit) const {
  const auto [ring, angle] = orbits_[orbit];
  const auto [l, m] = symbolic::degree_order(i);
  const int order = m < 0 ? -m : m;
  const ExactReal theta = rings_.theta(l, order, ring);
  if (m == 0 || is_zero(theta)) return m < 0 ? Surd() : theta;
  // m phi = 2 pi * 2 m (2j + 1) / (4 M)
  const int turn = 2 * order * (2 * angle + 1);
  const ExactReal phase = m > 0 ? cosine(turn, 4 * angles_) : sine(turn, 4 * angles_);
  return is_zero(phase) ? phase : multiply(theta, phase);
}

ExactReal OrbitQuadrature::weight(int orbit) const {
  const auto [ring, angle] = orbits_[orbit];
  const ExactReal ring_weight = rings_.weight(ring);
  const auto times_pi = [](const cln::cl_RA& factor) {
    const std::string name = "pi " + to_string(Surd(factor));
    return Computed(name, [factor](int digits) {
      const cln::float_format_t format = cln::float_format(digits + 5);
      return cln::pi(format) * cln::cl_float(factor, format);
    });
  };
  // An orbit has two poles, or four or eight points with weight 2 pi / M each.
  if (rings_.is_pole(ring)) return multiply(ring_weight, times_pi(4));
  const int points = 2 * (2 * angle + 1) == angles_ ? 4 : 8;
  return multiply(ring_weight, times_pi(cln::cl_RA(2 * points) / angles_));
}

std::string OrbitQuadrature::definition() const {
  return rings_.definition() + (rings_.rings().pole ? ", 1" : "") + "; angles (j + 1/2) 2 pi/" +
         std::to_string(angles_) + " up to pi/2";
}

}  // namespace sh::codegen::recipes
