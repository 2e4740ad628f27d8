// The file of a plan: all decisions of a bake, made once and followed by every process that takes part in it. It is the JSON of
// plan_json() with what a bake needs beside it: the receivers, the vertices without rays, the numbers that bytes were chosen for, counts
// of clusters and lights; and with a key and a checksum, so that it serves no other mesh or light, and no edited plan.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prt/plan/plan.hpp"

namespace sh::prt {

/// Writes the plan that scene.bake follows; `mesh` is that of checksums_of(), before the plan left out receivers and lobes
/// stood in place of BRDFs. Throws
/// std::runtime_error if the file cannot be written.
void write_plan(const std::string& file, const Plan& plan, const Scene& scene, const std::string& mesh);

/// Reads a plan and lowers scene.bake and scene.mesh to follow it, whatever the scene's own options. Throws std::runtime_error, one
/// line that begins with the file, if it cannot be read, is no such file or damaged, or was made for another mesh or, with
/// an error, for other lights.
Plan read_plan(const std::string& file, Scene& scene);

/// The checksum of all other entries of such a file, in whatever order and layout they stand: 16 hexadecimal digits.
std::string plan_checksum(nlohmann::json plan);

}  // namespace sh::prt
