// A bake under way: what its steps read, and what each leaves for the next.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "prt/bake/checkpoint.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/bake/job.hpp"
#include "prt/bake/shadow_pass.hpp"

namespace sh::prt {

/// Everything passed in must outlive it. Mirrors are grey (prt/bake/colored_mirrors.hpp has the others).
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
  Transfer transfer;                      // its shape is that of the step before
  std::optional<RaySetup> rays;
  std::optional<FormFactors> factors;  // of kinds with bounces
  std::optional<ShadowResult> found;
  std::optional<Checkpoint> checkpoint;
};

}  // namespace sh::prt
