// What a bake produces: a mesh and the transfer of every vertex (prt/transfer/shape.hpp says what its numbers are);
// L (3, bands^2) are the coefficients of the incident radiance.
//   without the albedo, one channel     exit radiance (RGB) = albedo * sum_i T_i L_i: it can be recolored
//   with the albedo, three channels     exit radiance of channel c = sum_i T_ci L_ci, since the light that bounces
//                                       depends on every albedo
// A vertex under constant unit radiance and an open sky thus has sum_i T_i L_i = 1. Surfaces that shine of their own
// add `emitted` to either, whatever the light.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/kinds/kinds.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/names.hpp"

namespace sh::prt {

/// Where the rays of a vertex point to; prt/rays/directions.hpp has the sets.
enum class Sampler : std::uint32_t { kFibonacci, kStratified, kSobol, kRandom, kCosine };

/// In the order of Sampler.
inline constexpr std::array<std::string_view, 5> kSamplerNames = {"fibonacci", "stratified", "sobol", "random",
                                                                  "cosine"};

constexpr std::string_view name_of(Sampler sampler) { return word_of(sampler, kSamplerNames); }

/// The sampler with that name, if there is one.
constexpr std::optional<Sampler> sampler_called(std::string_view name) {
  return value_called<Sampler>(name, kSamplerNames);
}

/// One decision of a plan: work or numbers that a bake left out. `error` is relative to the plan's reference radiance
/// (prt/plan/plan.hpp). `basis` says how it is known: exact (no error but rounding), bound (proved, for any vertex),
/// measured (on a probe of vertices, RMS), heuristic.
struct Decision {
  std::string name;
  std::string choice;
  std::string why;
  std::int64_t bytes_saved = 0;
  std::int64_t rays_saved = 0;
  double error = 0.0;
  std::string basis = "exact";
};

/// The decisions a file was baked by; `budget` 0: only what is exact whatever the light.
struct PlanRecord {
  double budget = 0.0;
  double error = 0.0;       // the sum over the decisions
  std::string light_turns;  // that the errors hold for: none, about_z or any; empty without a budget
  std::vector<Decision> decisions;
};

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

/// The request that a limited time did not allow; see prt/bake/estimate.hpp.
struct Shortfall {
  std::uint32_t directions = 0;  // asked for; 0: there are as many
  double tolerance = 0.0;        // of the bounces, asked for; 0: reached
  [[nodiscard]] bool any() const { return directions > 0 || tolerance > 0.0; }
};

/// The transfer of every vertex of `mesh`.
struct Transfer {
  std::string scene;  // the scene's name, for people
  Mesh mesh;
  const TransferKind* kind = &kUnshadowed;
  TransferShape shape;           // of a vertex's numbers; its storage is that of a file, here they are whole
  std::uint32_t directions = 0;  // over the whole sphere; 0 where no ray was traced
  Sampler sampler = Sampler::kFibonacci;
  std::uint32_t seed = 0;           // of the sampler
  std::string instruction_set;      // bits are reproducible on this instruction set
  BounceReport bounces;             // of kinds with bounces
  std::vector<float> coefficients;  // (vertices, channels, rows, columns), row-major; columns i = l(l+1)+m
  /// (vertices), or empty where nothing shines: linear RGB exit radiance of the surfaces' own light, with its bounces.
  std::vector<Eigen::Vector3f> emitted;
  PlanRecord plan;  // what the bake left out
  Shortfall missing;

  /// Of that kind, for light of that degree, with no numbers yet.
  static Transfer of(const TransferKind& kind, int degree) {
    Transfer transfer;
    transfer.kind = &kind;
    transfer.shape = kind.shape(degree);
    return transfer;
  }
  [[nodiscard]] int degree() const { return shape.degree; }
  /// The numbers of a vertex.
  [[nodiscard]] float* row(std::size_t vertex) { return coefficients.data() + vertex * shape.length(); }
  [[nodiscard]] const float* row(std::size_t vertex) const { return coefficients.data() + vertex * shape.length(); }
};

}  // namespace sh::prt
