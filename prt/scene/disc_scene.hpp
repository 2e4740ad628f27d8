// The scene behind the word `disc`: a disc over a ground, whose transfer vectors are known in closed form.
#pragma once
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// A thin disc of radius 1, which faces up, 0.6 over a ground z = 0, under the CIE overcast sky and a broad light from
/// one side. The disc is a regular polygon of the same area with so many corners that the difference is below 1e-5.
Scene make_disc_scene();

}  // namespace sh::prt
