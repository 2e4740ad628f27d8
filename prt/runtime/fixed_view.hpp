// Glossy transfer seen from one point at rest [SloanKautzSnyder02, section 4.2, fixed view]: exit radiance towards it is
// linear in the light, so that a vertex needs one row a channel, and a frame one dot product, whatever the lobes.
#pragma once
#include <Eigen/Core>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The transfer that gives under any light the exit radiance of `glossy` towards a point `eye` of the world: of the kind
/// with bounces, because it holds albedo and lobes. Its rows are those of `glossy` under the functions of the basis, to
/// rounding. Throws std::invalid_argument for transfer that is not glossy.
Transfer seen_from(const Transfer& glossy, const Eigen::Vector3d& eye);

/// The transfer vectors of diffuse surfaces in `glossy`, of the kind with bounces: what leaves by the albedo alone, or by that
/// of the fit in place of a BRDF (prt/material/lobe_fit.hpp), to every eye. The light has met lobes on its way there. Throws
/// as seen_from.
Transfer diffuse_vectors(const Transfer& glossy);

}  // namespace sh::prt
