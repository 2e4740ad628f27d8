// Colored mirrors: each channel is a separate bake, with gray mirrors of that channel's reflectance.
#pragma once
#include <functional>

#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

bool has_colored_mirrors(const Mesh& mesh);

/// `bake_grey` bakes a scene whose mirrors are gray; the result takes each channel from one of three bakes. Throws
/// std::invalid_argument for shadowed transfer: its single channel cannot hold the color of the mirrors.
Transfer bake_by_channel(const Scene& scene, const std::function<Transfer(const Scene&)>& bake_grey);

}  // namespace sh::prt
