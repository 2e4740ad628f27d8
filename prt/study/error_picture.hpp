// False-color pictures of a mesh that show where exit radiance is wrong.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// Returns the bytes of a PNG file. The colors are those of false_color.hpp, interpolated over faces on the logarithmic
/// scale. Progress is labeled `what`.
std::string error_picture(const Mesh& mesh, const Tracer& tracer, const std::vector<float>& relative_errors,
                          const Camera& camera, const PictureSize& size, const std::string& title,
                          const std::string& what);

}  // namespace sh::prt
