// The scene behind the word `demo`: made in code, needs no file.
#pragma once
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// A stage under the CIE overcast sky: an arch, stairs, columns with a sphere, a torus and a cone on a ground that
/// catches their shadows; smooth and flat shading, several albedos; every vertex sees some of the sky.
Scene make_embedded_scene();

}  // namespace sh::prt
