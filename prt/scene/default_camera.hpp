// A camera for a mesh without a scene.
#pragma once
#include "prt/mesh/mesh.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// Looks at the middle of the mesh from the front (-y), right and above, from where its bounding sphere fits the
/// picture.
Camera default_camera(const Mesh& mesh, const PictureSize& size);

}  // namespace sh::prt
