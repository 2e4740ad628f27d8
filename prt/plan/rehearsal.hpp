// Bakes in small, for measurements: two coarse bakes of the whole mesh, and bakes of a few of its vertices along any number
// of directions. With bounces, the few vertices see the surfaces as the mean of the coarse bakes shows them (a final
// gathering): what is left out is how the errors of the other vertices come back, which spread() measures.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "prt/bake/row_tracer.hpp"
#include "prt/bake/traced_part.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/plan/row_shape.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

class Rehearsal {
 public:
  static constexpr int kCoarseDirections = 64;

  /// Traces the whole mesh twice, each time along kCoarseDirections of its own. Mirrors are gray; what surfaces emit does
  /// not count. Kind and degree are those of the scene's bake.
  Rehearsal(const Scene& scene, const std::string& instruction_set);

  /// The numbers of all vertices after a coarse bake, 0 or 1, in the shape of the asked kind.
  [[nodiscard]] const std::vector<float>& coarse(std::size_t half) const {
    return halves_[half]->transfer.coefficients;
  }
  /// The same minus those of the other bake, with its matrices; without the mesh but for its size.
  [[nodiscard]] Transfer difference() const;
  [[nodiscard]] const std::vector<Sight>& sight(std::size_t half) const { return halves_[half]->sight; }
  /// Rays of one bake of the whole mesh for each direction, the mean of both coarse bakes.
  [[nodiscard]] double rays_a_direction() const { return rays_a_direction_; }

  /// The rows of the wanted vertices of a part, (wanted, length of the RowShape of the kind of `options`), as a bake with
  /// these options makes them; vertices with open != 0 are unshadowed, none if `open` is empty. The degree is the asked
  /// one; light bounces between lobes at the degree of `options`, and matrices are zero above it.
  [[nodiscard]] std::vector<float> rows(const BakeOptions& options, const TracedPart& part,
                                        const std::vector<std::uint8_t>& open) const;

  /// How much larger errors of directions are after all bounces than in rows(), RMS over all vertices and these lights, at
  /// least 1. The two coarse solutions x and y and their mean operator A tell: |x - y| over |(I - A) (x - y)|.
  [[nodiscard]] double spread(const std::vector<LightCoefficients>& lights) const;

 private:
  struct Half {
    Half(const RaySetup& first, const BakeOptions& options);
    RaySetup setup;
    Transfer transfer;
    FormFactors factors;
    std::vector<Sight> sight;
  };
  [[nodiscard]] BakeOptions coarse_options(std::uint32_t half) const;
  void bake(Half& half) const;
  [[nodiscard]] MatrixTable reaching(int degree) const;
  void gather_from_lobes(const BakeOptions& options, const RaySetup& setup, const TracedPart& part,
                         const std::vector<std::uint8_t>& open, float* rows) const;
  [[nodiscard]] double spread_between_lobes(const std::vector<LightCoefficients>& lights) const;

  std::string name_;  // the scene's
  Mesh mesh_;
  BakeOptions asked_;
  RaySetup first_;
  std::array<std::unique_ptr<Half>, 2> halves_;
  double rays_a_direction_;
};

}  // namespace sh::prt
