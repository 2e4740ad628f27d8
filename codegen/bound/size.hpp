// From bounds of the factors of coefficients to one bound in units of the family's size.
#pragma once

#include <map>
#include <optional>

#include "codegen/bound/bilinear.hpp"
#include "codegen/bound/region.hpp"
#include "codegen/bound/rounding.hpp"
#include "codegen/measure/measure.hpp"

namespace sh::codegen::bound {

/// An error in both units.
struct Sized {
  double relative = 0;  ///< divided by the family's size
  double absolute = 0;
};

/// The size of each output.
class Sizes {
 public:
  /// Throws std::domain_error, which says why, for a size that no bound can be divided by.
  Sizes(const Kernel& kernel, const Domain& domain, const Region& region, const Format& format);

  /// error: of output `output` on `box`
  [[nodiscard]] Sized operator()(const Magnitudes& error, std::size_t output, const Box& box) const;
  /// error: of output `output` of a kernel that multiplies coefficients
  [[nodiscard]] Sized operator()(const BilinearError& error, std::size_t output) const;
  /// Absolute values of all flattened inputs of a kernel that is linear in its coefficients: those for which the error
  /// divided by the size is the largest. Coordinates are 0.
  [[nodiscard]] std::vector<double> worst_coefficients(const Magnitudes& error) const;

 private:
  enum class Kind {
    kFixed,  ///< a number, or a function of the box
    kSum,    ///< a sum of |single coefficients| with fixed factors
    kNorm    ///< a product of the lengths of one or two arrays
  };
  [[nodiscard]] double at(const std::vector<double>& inputs, std::size_t output) const;
  [[nodiscard]] double of_box(const Box& box, std::size_t output) const;
  [[nodiscard]] double of_unit(std::size_t first, std::size_t second, std::size_t output) const;
  [[nodiscard]] double of_unit_arrays(std::size_t output) const;
  [[nodiscard]] Sized of_sum(const Magnitudes& error, std::size_t output) const;
  [[nodiscard]] Sized of_norm(const Magnitudes& error, std::size_t output) const;

  const Kernel& kernel_;
  const Region& region_;
  double scale_;
  Kind kind_ = Kind::kFixed;
  Size size_;
  mutable std::map<std::array<std::size_t, 3>, double> known_;
};

}  // namespace sh::codegen::bound
