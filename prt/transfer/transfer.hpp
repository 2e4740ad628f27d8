// What a bake produces: a mesh and vectors of SH coefficients per vertex; L (3, bands^2) are those of the incident
// radiance. Without bounces there is one, which holds the cosine and 1/pi but not the albedo, so that a baked mesh can
// be recoloured:
//   exit radiance (RGB) = albedo * sum_i T_i L_i.
// A vertex under constant unit radiance and an open sky thus has sum_i T_i L_i = 1. With bounces there is one a
// channel, and it holds everything, since the light that comes back depends on every albedo:
//   exit radiance of channel c = sum_i T_ci L_ci.
// Surfaces that shine of their own add `emitted` to either, whatever the light.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/transfer/decision.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

inline constexpr int kMaxDegree = 10;

/// Unshadowed (DU): every vertex sees its whole hemisphere. Shadowed (DS): rays decide. Interreflected (DI): what they
/// hit reflects, any number of times.
enum class TransferKind : std::uint32_t { kUnshadowed = 0, kShadowed = 1, kInterreflected = 2 };

/// Where the rays of a vertex point to; prt/rays/directions.hpp has the sets.
enum class Sampler : std::uint32_t { kFibonacci, kStratified, kSobol, kRandom, kCosine };

/// How the bounces were solved; see prt/bake/bounces.hpp. Errors are those of any number of the solution.
struct BounceReport {
  std::string solver;           // series or bicgstab; empty where there are no bounces
  int applications = 0;         // of the form factors; each is one bounce of the series
  bool certified = false;       // bound <= tolerance * largest, or the bound that was reached when time was over
  double bound = 0.0;           // certified: no number is further from the system's solution
  double residual = 0.0;        // largest number of b - (I - A) x
  double largest = 0.0;         // number of the solution
  double spectral_bound = 0.0;  // certified: no eigenvalue of albedo times form factors is larger
  double emitted_bound = 0.0;   // as `bound`, of the surfaces' own light
  double emitted_largest = 0.0;
};

/// What was asked for where a limited time did not allow it; see prt/bake/budget.hpp.
struct Shortfall {
  std::uint32_t directions = 0;  // asked for; 0: there are as many
  double tolerance = 0.0;        // of the bounces, asked for; 0: reached
  [[nodiscard]] bool any() const { return directions > 0 || tolerance > 0.0; }
};

/// Transfer vectors of every vertex of `mesh`.
struct Transfer {
  std::string scene;  // the scene's name, for people
  Mesh mesh;
  int degree = 0;  // 0..kMaxDegree
  TransferKind kind = TransferKind::kUnshadowed;
  std::uint32_t directions = 0;  // over the whole sphere; 0 where no ray was traced
  Sampler sampler = Sampler::kFibonacci;
  std::uint32_t seed = 0;           // of the sampler
  std::string instruction_set;      // bits are reproducible on this instruction set
  BounceReport bounces;             // of interreflected transfer
  std::vector<float> coefficients;  // (vertices, channels, bands^2), row-major, i = l(l+1)+m
  /// (vertices), or empty where nothing shines: linear RGB exit radiance of the surfaces' own light, with its bounces.
  std::vector<Eigen::Vector3f> emitted;
  Storage storage;  // of the coefficients in a file; here they are whole
  PlanRecord plan;  // what the bake left out
  Shortfall missing;
  [[nodiscard]] std::size_t bands_squared() const {
    const auto bands = static_cast<std::size_t>(degree) + 1;
    return bands * bands;
  }
  [[nodiscard]] std::size_t channels() const { return kind == TransferKind::kInterreflected ? 3 : 1; }
  [[nodiscard]] std::size_t row_length() const { return channels() * bands_squared(); }
  [[nodiscard]] RowShape row_shape() const { return {channels(), bands_squared()}; }
};

}  // namespace sh::prt
