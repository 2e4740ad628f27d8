// Coefficients from the project's convention to another one and back.
//
// Coefficients go the opposite way to the functions: f = sum c Y = sum c' Y' and Y' = A Y give c' = A^-T c. A is a
// size for each function (normalization, phase, folded factors), the unitary map between real and complex functions,
// and the band matrices D_l(P) of the axes, which are full from band 2 on (numeric/README.md). Each element is a short
// sum of factor times coefficient. Without axes the sum has one term: each coefficient is multiplied once, by a factor
// that is rounded once, and signs and orders change no bit.
#pragma once

#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"

namespace sh::numeric::identify {

/// The preset of that name; throws std::invalid_argument with the names that exist.
const Preset& find_preset(const std::string& name);

/// The preset's convention for directions of our world (x right, y forward, z up): its functions, with `world` as axes.
Convention in_world(const Preset& preset);

class CoefficientMap {
 public:
  /// `hold` is the factor of each band that the other's coefficients include and its functions do not: a preset's
  /// `coefficients_hold`. Throws std::invalid_argument for a degree outside 0 to largest_mapped_degree.
  CoefficientMap(const Convention& convention, int degree, Folded hold = Folded::kNothing);
  /// Of in_world(preset).
  CoefficientMap(const Preset& preset, int degree);

  [[nodiscard]] int degree() const { return degree_; }
  /// Elements of one channel: ours, bands^2, and theirs, with the holes of an array order, which hold zero. A complex
  /// number is two elements, real part first.
  [[nodiscard]] int our_size() const { return static_cast<int>(from_.size()); }
  [[nodiscard]] int their_size() const { return static_cast<int>(to_.size()); }
  /// One factor for each coefficient: no axes mix them.
  [[nodiscard]] bool is_diagonal() const;

  /// theirs (their_size) from ours (our_size), one channel; Number is float or double. The arrays do not overlap.
  template <class Number>
  void to(const Number* ours, Number* theirs) const {
    apply(to_, ours, theirs);
  }
  /// The inverse. Complex coefficients of a function that is not real: those of its real part.
  template <class Number>
  void from(const Number* theirs, Number* ours) const {
    apply(from_, theirs, ours);
  }

  /// All channels, one after the other. Throws std::invalid_argument unless the size is a multiple of a channel's.
  [[nodiscard]] std::vector<double> to(const std::vector<double>& ours) const;
  [[nodiscard]] std::vector<double> from(const std::vector<double>& theirs) const;

 private:
  struct Term {
    int place;  // in the other array
    double factor;
  };
  using Rows = std::vector<std::vector<Term>>;

  template <class Number>
  static void apply(const Rows& rows, const Number* in, Number* out) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double sum = -0.0;  // adding it changes no number, zeros of either sign included
      for (const Term& term : rows[i]) sum += term.factor * static_cast<double>(in[term.place]);
      out[i] = static_cast<Number>(rows[i].empty() ? 0 : sum);
    }
  }
  static std::vector<double> apply_to_channels(const Rows& rows, std::size_t in_size, const std::vector<double>& in);
  class Maker;

  int degree_;
  Rows to_, from_;
};

/// largest_degree(convention), or 2 where a clamped cosine is folded in or held: A_3 = 0 cannot be undone.
int largest_mapped_degree(const Convention& convention, Folded hold = Folded::kNothing);

}  // namespace sh::numeric::identify
