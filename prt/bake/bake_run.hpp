// The state of a running bake: the input of its steps, and the results that each step leaves for the next.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "prt/bake/checkpoint.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/bake/job.hpp"
#include "prt/bake/shadow_pass.hpp"

namespace sh::prt {

/// All arguments must outlive this object. Mirrors are gray (prt/bake/colored_mirrors.hpp handles the others).
struct BakeRun {
  BakeRun(const Scene& the_scene, const BakeSettings& the_settings, const std::vector<std::uint8_t>& open_vertices)
      : scene(the_scene),
        settings(the_settings),
        open(open_vertices),
        transfer(Transfer::of(*the_scene.bake.kind, the_scene.bake.degree)) {}
  BakeRun(const BakeRun&) = delete;
  BakeRun& operator=(const BakeRun&) = delete;

  const Scene& scene;
  const BakeSettings& settings;
  const std::vector<std::uint8_t>& open;  // as in Plan
  Transfer transfer;                      // in the shape of the last finished step
  std::optional<RaySetup> rays;
  std::optional<FormFactors> factors;  // only for kinds with bounces
  std::optional<ShadowResult> found;
  std::optional<Checkpoint> checkpoint;
};

}  // namespace sh::prt
