// What a medium leaves of the light in the space around it and inside it: the shadow of a cloud on surfaces that its bake
// did not know [SloanKautzSnyder02, sections 7 and 8]. A point keeps its transmittance as the visibility of a volume around
// an object (kind N): objects of a stage then take it as any other volume.
#pragma once
#include "prt/bake/bake_volume.hpp"

namespace sh::prt {

/// The volume of a scene's medium. The whole sphere, to the bit, where no ray meets the medium. Light that the medium
/// scatters is not in it. The same bits for any number of threads. Shows progress. Throws like empty_volume,
/// std::invalid_argument for options.reflects, and output::Interrupted.
Transfer bake_medium_volume(const Scene& scene, const VolumeOptions& options, const BakeObserver& say = {});

}  // namespace sh::prt
