// A bake that has to fit into a given time: fewer directions, and bounces for as long as there is time. The file is
// valid for every vertex and says what was left out.
#pragma once
#include <chrono>

#include "prt/bake/estimate.hpp"
#include "prt/scene/bake_options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

inline constexpr int kLeastDirections = 64;  // coarser than this is of no use

/// The options with as many directions as fit into `seconds` by the estimate, which is of a bake with `wanted`: never
/// more than wanted, no fewer than kLeastDirections unless fewer are wanted. A sixth is kept in reserve; bounces may
/// take half. Throws std::runtime_error, which says what would do, where the least takes longer.
BakeOptions within_budget(const BakeOptions& wanted, const BakeEstimate& estimate, double seconds);

/// What `transfer` lacks of what was wanted.
Shortfall shortfall(const BakeOptions& wanted, const Transfer& transfer);

}  // namespace sh::prt
