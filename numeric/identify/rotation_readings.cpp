// The conventions of rotation matrices, and which of them someone's matrices follow; see rotation_check.hpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "numeric/identify/rotation_check.hpp"
#include "numeric/oracle/rotation.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<long double>;

constexpr std::size_t kMostCases = 4;  // general ones that the search looks at
constexpr int kSearchDegree = 3;

// axes R axes^-1, of the inverse where the reading has it.
std::array<long double, 9> own_rotation(const RotationReading& reading, const RotationCase& rotation) {
  const Axes& axes = reading.convention.axes;
  std::array<long double, 9> result{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto sign = static_cast<long double>(axes.sign[i] * axes.sign[k]);
      const int row = axes.axis[reading.inverse ? k : i];
      const int column = axes.axis[reading.inverse ? i : k];
      result[3 * i + k] = sign * rotation.r[3 * row + column];
    }
  }
  return result;
}

// U of the complex functions g = U y: g_0 = y_0, g_(+-a) = (y_a +- i y_-a) / sqrt 2.
Band complex_functions(int l) {
  const long double half_root = std::numbers::sqrt2_v<long double> / 2;
  Band u = Band::Zero(2 * l + 1, 2 * l + 1);
  u(l, l) = 1;
  for (int m = 1; m <= l; ++m) {
    u(l + m, l + m) = u(l - m, l + m) = half_root;
    u(l + m, l - m) = Complex(0, half_root);
    u(l - m, l - m) = Complex(0, -half_root);
  }
  return u;
}

// The conventions of a matrix, axes and direction left open.
std::vector<Convention> matrix_conventions(bool complex, int degree) {
  using enum Normalization;
  std::vector<Convention> all;
  for (const auto normalization : {kOrthonormal, kUnnormalized, kPrimitive}) {
    if (complex && normalization != kOrthonormal) continue;
    for (const auto order : {IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands}) {
      for (const bool phase : {false, true}) all.push_back({normalization, phase, complex, order});
    }
  }
  const Convention fuma{.normalization = kFuMa, .order = IndexOrder::kFuMa};
  if (!complex && degree <= largest_degree(fuma)) all.push_back(fuma);
  return all;
}

// A preset's matrices are those of the orthonormal convention unless its functions vary in size inside a band. An axis
// matrix and its negative turn alike.
PresetNames names_of(const Convention& convention) {
  const auto same_matrices = [&](Convention preset) {
    using enum Normalization;
    preset.axes = convention.axes;
    preset.folded = convention.folded;
    if (preset.normalization != kUnnormalized && preset.normalization != kPrimitive && preset.normalization != kFuMa)
      preset.normalization = kOrthonormal;
    return convention == preset;
  };
  const auto same_turns = [](const Axes& a, Axes b) {
    if (a == b) return true;
    for (int& sign : b.sign) sign = -sign;
    return a == b;
  };
  return preset_names(convention.axes, same_matrices, same_turns);
}

int rank_of(const RotationReading& reading) {
  const int other_way = reading.inverse || reading.transposed ? 1 : 0;
  if (!reading.presets.own.empty()) return other_way;
  if (!reading.presets.world.empty()) return 2 + other_way;
  return (reading.convention.axes == Axes{} ? 4 : 6) + other_way;
}

struct Candidate {
  RotationReading reading;
  long wrong = 0;
  int rank = 0;
};

// The readings of one choice of axes and direction.
void add_candidates(const std::vector<const RotationCase*>& cases, const std::vector<Convention>& conventions,
                    int degree, const RotationReading& turn, std::vector<Candidate>& all) {
  std::vector<std::vector<Band>> expected;
  for (const auto* one : cases) expected.push_back(expected_bands(turn, *one, degree));
  for (Convention convention : conventions) {
    convention.axes = turn.convention.axes;
    for (const bool transposed : {false, true}) {
      const bool same = !convention.complex && convention.normalization == Normalization::kOrthonormal;
      if (same && transposed) continue;
      Candidate candidate{{convention, turn.inverse, transposed, names_of(convention)}};
      for (std::size_t i = 0; i < cases.size(); ++i) {
        for (int l = 0; l <= degree; ++l) {
          const Band off = own_band(candidate.reading, *cases[i], l) - expected[i][l];
          candidate.wrong += (off.array().abs() > kFar).count();
        }
      }
      candidate.rank = rank_of(candidate.reading);
      all.push_back(std::move(candidate));
    }
  }
}

}  // namespace

std::string RotationReading::describe() const {
  const Convention& c = convention;
  const bool plain = c.normalization == Normalization::kOrthonormal;
  std::string text = std::string(c.complex ? "complex, " : "real, ") +
                     (plain ? "orthonormal (or N3D, SN3D, Schmidt: the same)" : name_of(c.normalization)) + ", " +
                     (c.condon_shortley ? "Condon-Shortley phase, " : "no Condon-Shortley phase, ") + name_of(c.order) +
                     ", axes " + c.axes.to_string();
  if (plain && !c.complex) return text + (inverse ? ", transposed (or of the inverse rotation)" : ", c' = D(R) c");
  text += inverse ? ", of the inverse rotation" : ", of the rotation";
  return text + (transposed ? ", transposed" : "");
}

std::vector<Band> expected_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree) {
  const auto r = own_rotation(reading, rotation);
  const auto values = rotation_bands<long double>(max_degree, r.data());
  std::vector<Band> bands;
  for (int l = 0; l <= max_degree; ++l) {
    const int width = 2 * l + 1;
    const auto entry = [&](Eigen::Index m, Eigen::Index n) { return Complex(values[l][m * width + n]); };
    const Band real = Band::NullaryExpr(width, width, entry);
    const Band u = complex_functions(l);
    bands.push_back(reading.convention.complex ? Band(u.conjugate() * real * u.transpose()) : real);
  }
  return bands;
}

// C = A^-T is 1 / size on the diagonal, so D'_mn = D_mn size_n / size_m.
Band own_band(const RotationReading& reading, const RotationCase& rotation, int l) {
  std::vector<long double> size;
  std::vector<int> place;
  for (int m = -l; m <= l; ++m) {
    size.push_back(relative_size(reading.convention, l, m));
    place.push_back(storage_position(reading.convention.order, l, l, m) - l * l);
  }
  const int width = 2 * l + 1;
  const auto entry = [&](Eigen::Index m, Eigen::Index n) {
    const int row = place[reading.transposed ? n : m];
    const int column = place[reading.transposed ? m : n];
    return Complex(rotation.bands[l][row * width + column]) * size[m] / size[n];
  };
  return Band::NullaryExpr(width, width, entry);
}

std::vector<RotationReading> best_rotation_readings(const RotationCases& cases) {
  std::vector<const RotationCase*> general;
  for (const auto& one : cases.cases) {
    if (is_general(one) && general.size() < kMostCases) general.push_back(&one);
  }
  const auto conventions = matrix_conventions(cases.complex, cases.degree);
  std::vector<Candidate> all;
  for (const Axes& axes : all_axes()) {
    if (axes.determinant() < 0) continue;
    for (const bool inverse : {false, true}) {
      const RotationReading turn{{.complex = cases.complex, .axes = axes}, inverse};
      add_candidates(general, conventions, std::min(cases.degree, kSearchDegree), turn, all);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.wrong, a.rank) < std::tuple(b.wrong, b.rank);
  });
  std::vector<RotationReading> best;
  for (const Candidate& c : all) {
    if (c.wrong == all.front().wrong) best.push_back(c.reading);
  }
  return best;
}

}  // namespace sh::numeric::identify
