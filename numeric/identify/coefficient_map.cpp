// See coefficient_map.hpp.
#include "numeric/identify/coefficient_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/index.hpp"
#include "numeric/oracle/require.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric::identify {
namespace {

// To degree 20 an entry of D_l(P) that is not zero is at least 2^-19, and the recursion errs by 1e-18: what is next to
// zero or one is zero or one.
long double exact_entry(long double entry) {
  constexpr long double kBetween = 1e-12L;
  if (std::abs(entry) < kBetween) return 0;
  return std::abs(std::abs(entry) - 1) < kBetween ? std::copysign(1.0L, entry) : entry;
}

// D_0 .. D_degree of a signed permutation P: Y(P s) = D(P) Y(s); (2l+1, 2l+1) row by row. A reflection is -1 times a
// rotation, and D_l(-1) = (-1)^l.
std::vector<std::vector<long double>> axes_bands(const Axes& axes, int degree) {
  const int handedness = axes.determinant();
  std::array<long double, 9> rotation{};
  for (std::size_t row = 0; row < 3; ++row) {
    rotation[3 * row + static_cast<std::size_t>(axes.axis[row])] =
        static_cast<long double>(handedness * axes.sign[row]);
  }
  auto bands = rotation_bands(degree, rotation.data());
  for (int l = 0; l <= degree; ++l) {
    for (long double& entry : bands[l]) entry = exact_entry(entry) * (l % 2 != 0 ? handedness : 1);
  }
  return bands;
}

long double held(Folded hold, int l) {
  if (hold == Folded::kNothing) return 1;
  const auto factor = clamped_cosine_factor<long double>(l);
  return hold == Folded::kCosine ? factor : factor / std::numbers::pi_v<long double>;
}

bool folds(const Convention& convention, Folded hold) {
  return convention.folded != Folded::kNothing || hold != Folded::kNothing;
}

}  // namespace

const Preset& find_preset(const std::string& name) {
  std::string names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset;
    names += (names.empty() ? "" : ", ") + preset.name;
  }
  throw std::invalid_argument("convention: expected one of " + names + ", got '" + name + "'");
}

Convention in_world(const Preset& preset) {
  Convention convention = preset.convention;
  convention.axes = preset.world;
  return convention;
}

int largest_mapped_degree(const Convention& convention, Folded hold) {
  return std::min(largest_degree(convention), folds(convention, hold) ? 2 : kMaxDegree);
}

// Fills both lists of rows. In the other's axes the coefficients are r = D c, and c = D^T r. An element is
// weight * hold / size of one r, and gives weight * size / hold back to it: weight 1, or for the parts of complex
// numbers +-1/sqrt 2, as size c'_m = (r_a -+ i r_-a) / sqrt 2 for m = +-a.
class CoefficientMap::Maker {
 public:
  Maker(CoefficientMap& map, const Convention& convention, Folded hold)
      : map_(map), convention_(convention), hold_(hold), bands_(axes_bands(convention.axes, map.degree_)) {
    map_.to_.resize(((convention.complex ? 2 : 1) * storage_size(convention.order, map.degree_)));
    map_.from_.resize((coefficient_count(map.degree_)));
  }

  void make(int l, int m) {
    const int position = storage_position(convention_.order, map_.degree_, l, m);
    const long double scale = held(hold_, l) / relative_size(convention_, l, m);
    if (!convention_.complex) return element({position, l, m}, 1, scale);
    if (m == 0) return element({2 * position, l, 0}, 1, scale);
    const long double half = 1 / std::numbers::sqrt2_v<long double>;
    element({2 * position, l, std::abs(m)}, half, scale);
    element({2 * position + 1, l, -std::abs(m)}, m > 0 ? -half : half, scale);
  }

 private:
  struct Element {
    int place, degree, order;  // order of r
  };

  void element(const Element& e, long double weight, long double scale) {
    const int width = 2 * e.degree + 1;
    for (int n = -e.degree; n <= e.degree; ++n) {
      const long double entry = weight * bands_[e.degree][((e.order + e.degree) * width + n + e.degree)];
      if (entry == 0) continue;
      const int ours = coefficient_index(e.degree, n);
      map_.to_[e.place].push_back({ours, static_cast<double>(entry * scale)});
      map_.from_[ours].push_back({e.place, static_cast<double>(entry / scale)});
    }
  }

  CoefficientMap& map_;
  const Convention& convention_;
  Folded hold_;
  std::vector<std::vector<long double>> bands_;
};

CoefficientMap::CoefficientMap(const Convention& convention, int degree, Folded hold) : degree_(degree) {
  require_range("degree", degree, 0, largest_mapped_degree(convention, hold));
  Maker maker(*this, convention, hold);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) maker.make(l, m);
  }
}

CoefficientMap::CoefficientMap(const Preset& preset, int degree)
    : CoefficientMap(in_world(preset), degree, preset.coefficients_hold) {}

bool CoefficientMap::is_diagonal() const {
  const auto one = [](const std::vector<Term>& row) { return row.size() <= 1; };
  return std::ranges::all_of(to_, one) && std::ranges::all_of(from_, one);
}

std::vector<double> CoefficientMap::to(const std::vector<double>& ours) const {
  return apply_to_channels(to_, from_.size(), ours);
}

std::vector<double> CoefficientMap::from(const std::vector<double>& theirs) const {
  return apply_to_channels(from_, to_.size(), theirs);
}

std::vector<double> CoefficientMap::apply_to_channels(const Rows& rows, std::size_t in_size,
                                                      const std::vector<double>& in) {
  if (in.size() % in_size != 0) {
    throw std::invalid_argument("coefficients: expected " + std::to_string(in_size) + " a channel, got " +
                                std::to_string(in.size()));
  }
  std::vector<double> out(in.size() / in_size * rows.size());
  for (std::size_t channel = 0; channel < in.size() / in_size; ++channel) {
    apply(rows, in.data() + channel * in_size, out.data() + channel * rows.size());
  }
  return out;
}

}  // namespace sh::numeric::identify
