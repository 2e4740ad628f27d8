// The parts of `prt bake` that are about media; prt/commands/shown.hpp has those of `prt render`.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Throws std::invalid_argument if the scene is a medium; `what` is a command that takes meshes.
void require_meshes(const Scene& scene, const std::string& what);

/// Prints the estimate of the bake of a scene's medium as JSON. `bounce_memory` in bytes.
void print_medium_estimate(const Scene& scene, std::size_t bounce_memory);

/// Bakes a scene's medium into a file, with messages on standard error.
void bake_medium_to_file(const Scene& scene, std::size_t bounce_memory, const std::string& output);

/// scattered_light (prt/medium). Throws std::runtime_error, with the file's name, if it exceeds single precision.
std::vector<float> finite_scattered_light(const Transfer& transfer, const LightCoefficients& light,
                                          const std::string& file);

}  // namespace sh::prt
