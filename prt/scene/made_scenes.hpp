// The scenes `demo` and `disc`, which are made in code and need no file.
#pragma once
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// An arch, stairs, and columns with a sphere, a torus and a cone, under the CIE overcast sky and on a ground that
/// receives their shadows. It has smooth and flat shading and several albedos; every vertex sees a part of the sky.
Scene make_embedded_scene();

/// A thin disc of radius 1 that faces up, 0.6 above a ground z = 0, under the CIE overcast sky and a broad light from
/// one side. The disc is a regular polygon of the same area; it has enough corners to keep the difference below 1e-5.
Scene make_disc_scene();

}  // namespace sh::prt
