// See rotation_readings.hpp.
#include "numeric/identify/rotation_readings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "numeric/identify/candidates.hpp"
#include "numeric/oracle/rotation.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<long double>;

constexpr std::size_t kMostCases = 4;  // general ones that the search looks at
constexpr int kSearchDegree = 3;

std::size_t place(int l, int row, int column) { return static_cast<std::size_t>((row + l) * (2 * l + 1) + column + l); }

// axes R axes^-1, of the inverse if asked.
std::array<long double, 9> own_rotation(const RotationReading& reading, const RotationCase& rotation) {
  const Axes& axes = reading.convention.axes;
  std::array<long double, 9> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      auto from_row = static_cast<std::size_t>(axes.axis[i]);
      auto from_column = static_cast<std::size_t>(axes.axis[k]);
      if (reading.inverse) std::swap(from_row, from_column);
      result[3 * i + k] =
          static_cast<long double>(axes.sign[i] * axes.sign[k]) * rotation.r[3 * from_row + from_column];
    }
  }
  return result;
}

// conj(U) D U^T for the complex functions g = U y: g_0 = y_0, g_(+-a) = (y_a +- i y_-a) / sqrt 2.
Band to_complex(const std::vector<long double>& d, int l) {
  const auto times_conjugate = [&](int m, auto&& of) -> Complex {  // sum over n of conj(U)_mn of(n)
    if (m == 0) return of(0);
    const Complex i(0, m > 0 ? -1.0L : 1.0L);
    return (of(std::abs(m)) + i * of(-std::abs(m))) / std::numbers::sqrt2_v<long double>;
  };
  Band band(d.size());
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      band[place(l, m, n)] = times_conjugate(m, [&](int row) {
        return std::conj(times_conjugate(n, [&](int column) -> Complex { return d[place(l, row, column)]; }));
      });
    }
  }
  return band;
}

// Place inside its band, from 0, of order m in the convention's order.
int place_in_band(IndexOrder order, int l, int m) { return storage_position(order, l, l, m) - l * l; }

int wrong_entries(const std::vector<Band>& expected, const std::vector<Band>& own) {
  int wrong = 0;
  for (std::size_t l = 0; l < expected.size(); ++l) {
    for (std::size_t i = 0; i < expected[l].size(); ++i) wrong += std::abs(expected[l][i] - own[l][i]) > kFar ? 1 : 0;
  }
  return wrong;
}

// What a matrix can be but for axes and direction.
std::vector<Convention> matrix_conventions(bool complex) {
  using enum Normalisation;
  std::vector<Convention> all;
  for (const auto normalisation : {kOrthonormal, kUnnormalised, kPrimitive}) {
    if (complex && normalisation != kOrthonormal) continue;
    for (const auto order : {IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands}) {
      for (const bool phase : {false, true}) {
        Convention convention;
        convention.normalisation = normalisation;
        convention.condon_shortley = phase;
        convention.complex = complex;
        convention.order = order;
        all.push_back(convention);
      }
    }
  }
  return all;
}

int rank_of(const RotationReading& reading) {
  const int other_way = reading.inverse || reading.transposed ? 1 : 0;
  if (!reading.presets().empty()) return other_way;
  if (!reading.world_presets().empty()) return 2 + other_way;
  return (reading.convention.axes == Axes{} ? 4 : 6) + other_way;
}

class Search {
 public:
  explicit Search(const RotationCases& cases) : degree_(std::min(cases.degree, kSearchDegree)) {
    for (const auto& one : cases.cases) {
      if (is_general(one) && cases_.size() < kMostCases) cases_.push_back(&one);
    }
    conventions_ = matrix_conventions(cases.complex);
  }

  [[nodiscard]] std::vector<RotationCandidate> run() const {
    std::vector<RotationCandidate> all;
    for (const Axes& axes : all_axes()) {
      if (axes.determinant() < 0) continue;
      for (const bool inverse : {false, true}) add(axes, inverse, all);
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.wrong, a.rank) < std::tuple(b.wrong, b.rank);
    });
    return all;
  }

 private:
  void add(const Axes& axes, bool inverse, std::vector<RotationCandidate>& all) const {
    std::vector<std::vector<Band>> expected;
    Convention any = conventions_.front();
    any.axes = axes;
    for (const auto* one : cases_) expected.push_back(expected_bands({any, inverse, false}, *one, degree_));
    for (Convention convention : conventions_) {
      convention.axes = axes;
      for (const bool transposed : {false, true}) {
        const bool same = !convention.complex && convention.normalisation == Normalisation::kOrthonormal;
        if (same && transposed) continue;
        RotationCandidate candidate{{convention, inverse, transposed}, 0, 0};
        for (std::size_t i = 0; i < cases_.size(); ++i) {
          candidate.wrong += wrong_entries(expected[i], own_bands(candidate.reading, *cases_[i], degree_));
        }
        candidate.rank = rank_of(candidate.reading);
        all.push_back(candidate);
      }
    }
  }

  int degree_;
  std::vector<const RotationCase*> cases_;
  std::vector<Convention> conventions_;
};

// A preset's matrices are those of the orthonormal convention unless its functions vary in size inside a band.
bool same_matrices(const Convention& convention, const Convention& preset) {
  const bool plain =
      preset.normalisation != Normalisation::kUnnormalised && preset.normalisation != Normalisation::kPrimitive;
  return convention.normalisation == (plain ? Normalisation::kOrthonormal : preset.normalisation) &&
         convention.condon_shortley == preset.condon_shortley && convention.complex == preset.complex &&
         convention.order == preset.order;
}

// An axis matrix and its negative turn alike.
bool same_turns(const Axes& a, const Axes& b) {
  Axes negative = b;
  for (int& sign : negative.sign) sign = -sign;
  return a == b || a == negative;
}

}  // namespace

std::string RotationReading::describe() const {
  const Convention& c = convention;
  const bool plain = c.normalisation == Normalisation::kOrthonormal;
  std::string text = std::string(c.complex ? "complex, " : "real, ") +
                     (plain ? "orthonormal (or N3D, SN3D, Schmidt: the same)" : name_of(c.normalisation)) + ", " +
                     (c.condon_shortley ? "Condon-Shortley phase, " : "no Condon-Shortley phase, ") + name_of(c.order) +
                     ", axes " + c.axes.to_string();
  if (plain && !c.complex) return text + (inverse ? ", transposed (or of the inverse rotation)" : ", c' = D(R) c");
  text += inverse ? ", of the inverse rotation" : ", of the rotation";
  return text + (transposed ? ", transposed" : "");
}

std::vector<std::string> RotationReading::presets() const {
  std::vector<std::string> names;
  for (const Preset& preset : identify::presets()) {
    if (same_matrices(convention, preset.convention) && same_turns(convention.axes, preset.convention.axes)) {
      names.push_back(preset.name);
    }
  }
  return names;
}

std::vector<std::string> RotationReading::world_presets() const {
  std::vector<std::string> names;
  for (const Preset& preset : identify::presets()) {
    const bool differs = !same_turns(preset.world, preset.convention.axes);
    if (differs && same_matrices(convention, preset.convention) && same_turns(convention.axes, preset.world)) {
      names.push_back(preset.name);
    }
  }
  return names;
}

std::vector<Band> expected_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree) {
  const auto r = own_rotation(reading, rotation);
  const auto ours = rotation_bands<long double>(max_degree, r.data());
  std::vector<Band> bands;
  for (int l = 0; l <= max_degree; ++l) {
    const auto& band = ours[l];
    bands.push_back(reading.convention.complex ? to_complex(band, l) : Band(band.begin(), band.end()));
  }
  return bands;
}

// C = A^-T is 1 / size on the diagonal, so D'_mn = D_mn size_n / size_m.
std::vector<Band> own_bands(const RotationReading& reading, const RotationCase& rotation, int max_degree) {
  std::vector<Band> bands;
  for (int l = 0; l <= max_degree; ++l) {
    std::vector<long double> size;
    std::vector<std::size_t> from;
    for (int m = -l; m <= l; ++m) {
      size.push_back(relative_size(reading.convention, l, m));
      from.push_back(place_in_band(reading.convention.order, l, m));
    }
    Band band;
    for (std::size_t m = 0; m < size.size(); ++m) {
      for (std::size_t n = 0; n < size.size(); ++n) {
        const std::size_t row = reading.transposed ? from[n] : from[m];
        const std::size_t column = reading.transposed ? from[m] : from[n];
        band.push_back(Complex(rotation.bands[l][row * size.size() + column]) * size[m] / size[n]);
      }
    }
    bands.push_back(std::move(band));
  }
  return bands;
}

std::vector<RotationCandidate> ranked_rotation_readings(const RotationCases& cases) { return Search(cases).run(); }

}  // namespace sh::numeric::identify
