// Mirrors of a color: each channel is a bake of its own, among grey mirrors of that channel's reflectance.
#pragma once
#include <functional>

#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

bool has_colored_mirrors(const Mesh& mesh);

/// `bake_grey` bakes a scene whose mirrors are grey; the result takes each channel from one of three bakes. Throws
/// std::invalid_argument for shadowed transfer, whose one channel has no place for a color that is not the albedo's.
Transfer bake_by_channel(const Scene& scene, const std::function<Transfer(const Scene&)>& bake_grey);

}  // namespace sh::prt
