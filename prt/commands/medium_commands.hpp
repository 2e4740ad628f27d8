// The parts of `prt bake` that are about media; prt/commands/shown.hpp has those of `prt render`.
#pragma once
#include <cstddef>
#include <string>

#include "prt/scene/scene.hpp"

namespace sh::prt {

/// Throws std::invalid_argument if the scene is a medium; `what` is a command that takes meshes.
void require_meshes(const Scene& scene, const std::string& what);

/// Prints the estimate of the bake of a scene's medium as JSON. `bounce_memory` in bytes.
void print_medium_estimate(const Scene& scene, std::size_t bounce_memory);

/// Bakes a scene's medium into a file, with messages on standard error.
void bake_medium_to_file(const Scene& scene, std::size_t bounce_memory, const std::string& output);

}  // namespace sh::prt
