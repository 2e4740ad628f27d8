// Light that bounces between diffuse surfaces, as a linear system.
//   x = b + A x,   A = albedo * K,
// x_v the light that leaves vertex v after any number of bounces, b its part without bounces (emitted, or reflected
// from the sky at once), K the form factors. Solved as the Neumann series b + A b + A^2 b + ... while that is quick,
// and by BiCGSTAB [VanDerVorst92] on the same operator where it is not (closed rooms with bright walls).
// The error is certified, for either. A has no negative entry; so if y > 0 and s = (I - A) y > 0, then I - A is a
// nonsingular M-matrix [BermanPlemmons94, theorem 6.2.3] and, since (I - A)^-1 is not negative either,
//   |(I - A)^-1| <= max y / min s in the maximum norm,   |x - x_exact| <= max y / min s * |b - (I - A) x|.
// y is one more right side, b = 1, solved along with the others; no count of bounces is guessed.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/bake/form_factors.hpp"
#include "prt/scene/bake_options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The columns of the system's panel: for each channel `count` right sides, then the 1 that certifies them. The last
/// `emitted` of the right sides (0 or 1) are light of the surfaces' own, which has another unit than the others, so
/// that either kind must reach the tolerance by itself.
struct BounceLayout {
  static constexpr std::size_t kChannels = 3;
  std::size_t count;
  std::size_t emitted = 0;
  [[nodiscard]] std::size_t channel(std::size_t c) const { return c * (count + 1); }
  [[nodiscard]] std::size_t certificate(std::size_t c) const { return channel(c) + count; }
  [[nodiscard]] std::size_t columns() const { return channel(kChannels); }
};

/// x holds b in the columns of the right sides and is replaced by the solution; albedo (vertices), linear RGB, 0..1.
/// The same bits for any number of threads. Throws std::invalid_argument for shapes that differ or a tolerance that is
/// not positive.
BounceReport solve_bounces(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, BounceLayout layout,
                           Panel& x, const BounceOptions& options = {});

}  // namespace sh::prt
