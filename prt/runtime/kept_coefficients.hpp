// Files that keep only the coefficients their declared lights need must not be lit by others.
#pragma once
#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Throws std::invalid_argument where a coefficient of the light, of the transfer's degree, is more than a rounding of
/// its largest (1e-6) and the transfer was stored without what it multiplies.
void require_kept(const Transfer& transfer, const LightCoefficients& light);

}  // namespace sh::prt
