// Bakes bodies that let light through, for diffuse transfer (kind DT): to the shadowed light that a surface reflects comes
// the light that goes through its body, along straight lines (prt/translucent/body_rays.hpp) or scattered below the
// surface (prt/translucent/surface_scatter.hpp), by the material of each (prt/material/translucence.hpp). Light does not
// bounce between surfaces, and emitted light does not go through bodies. Also bakes the thickness of bodies (kind TH).
#pragma once
#include <string>

#include "prt/bake/bake.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The transfer of kind DT of a scene in which at least one material is translucent. The job's scene gives degree,
/// directions, sampler, seed and plan; its kind is not used. The same bits for any number of threads. Throws like bake(),
/// and std::invalid_argument for a scene without translucent materials, a lossy plan, clusters, colored mirrors, a
/// shard, and a material that reflects and lets through more than all light.
Transfer bake_translucent(BakeJob job, BakeReport* report = nullptr, const BakeObserver& say = {});

/// The thickness of the bodies of a scene, of any material: kind TH. Only degree, directions, sampler and seed count.
Transfer bake_thickness(BakeJob job, BakeReport* report = nullptr);

/// The same into transfer files; then deletes the checkpoint.
Transfer bake_translucent_to_file(const std::string& file, BakeJob job, BakeReport* report = nullptr,
                                  const BakeObserver& say = {});

}  // namespace sh::prt
