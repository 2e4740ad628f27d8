// The scenes behind the words `demo` and `disc`: made in code, they need no file.
#pragma once
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// A stage under the CIE overcast sky: an arch, stairs, columns with a sphere, a torus and a cone on a ground that
/// catches their shadows; smooth and flat shading, several albedos; every vertex sees some of the sky.
Scene make_embedded_scene();

/// A thin disc of radius 1, which faces up, 0.6 over a ground z = 0, under the CIE overcast sky and a broad light from
/// one side. The disc is a regular polygon of the same area with so many corners that the difference is below 1e-5.
Scene make_disc_scene();

}  // namespace sh::prt
