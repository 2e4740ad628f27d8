// Light that bounces between diffuse surfaces, as a linear system.
//   x = b + A x,   A = albedo * K,
// where x_v is the light that leaves vertex v after any number of bounces, b is its part without bounces (emitted
// light, or light reflected directly from the sky), and K are the form factors. The solver sums the Neumann series b +
// A b + A^2 b + ... while this is quick. Otherwise (closed rooms with bright walls) it uses BiCGSTAB [VanDerVorst92] on
// the same operator. Both solvers certify their error. A has no negative entry; so if y > 0 and s = (I - A) y > 0, then
// I - A is a nonsingular M-matrix [BermanPlemmons94, theorem 6.2.3] and, since (I - A)^-1 is not negative either,
//   |(I - A)^-1| <= max y / min s in the maximum norm,   |x - x_exact| <= max y / min s * |b - (I - A) x|.
// y is the solution of one more right side, b = 1, solved together with the others; no count of bounces is guessed.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/bake/bounce_checkpoint.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/scene/options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The columns of the system's panel: for each channel `count` right sides, then the right side 1 that certifies them.
/// The last `emitted` of the right sides (0 or 1) are light that the surfaces emit. It has a different unit, so that
/// both kinds of columns must reach the tolerance separately.
struct BounceLayout {
  static constexpr std::size_t kChannels = 3;
  std::size_t count;
  std::size_t emitted = 0;
  [[nodiscard]] std::size_t channel(std::size_t c) const { return c * (count + 1); }
  [[nodiscard]] std::size_t columns() const { return channel(kChannels); }
};

/// On input `light` holds b in the columns of the right sides; on output it holds the solution. albedo (vertices), linear
/// RGB, 0..1. The same bits for any number of threads, and where the solver goes on from a checkpoint. Throws
/// std::invalid_argument if shapes differ or the tolerance is not positive, and like BounceCheckpoint.
BounceReport solve_bounces(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, BounceLayout layout,
                           Panel& light, const BounceOptions& options = {}, BounceCheckpoint* checkpoint = nullptr);

}  // namespace sh::prt
