// The bake settings of a scene.
#pragma once
#include <chrono>
#include <cstdint>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The solver for the light that bounces; prt/bake/bounces.hpp describes the methods.
enum class BounceSolver { kAutomatic, kSeries, kKrylov };

struct BounceOptions {
  double tolerance = 1e-4;  // certified error of any number, relative to the largest number in the solution
  BounceSolver solver = BounceSolver::kAutomatic;
  int most_applications = 1000;  // of K; beyond this limit the result is marked as not certified
  /// No application begins after this time; the certified bound may then be above the tolerance.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

inline constexpr int kMaxSeed = 2147483647;

struct BakeOptions {
  int degree = 4;         // 0..kMaxDegree
  int directions = 2048;  // over the whole sphere
  Sampler sampler = Sampler::kFibonacci;
  std::uint32_t seed = 0;  // of the sampler, 0..kMaxSeed
  const TransferKind* kind = &kShadowed;
  BounceOptions bounces = {};  // interreflected only
};

}  // namespace sh::prt
