// The steps of a bake. Each kind of transfer lists the steps that it needs (prt/kinds/diffuse.cpp)
// [SloanKautzSnyder02].
//   unshadowed  closed form (prt/transfer/unshadowed.hpp)
//   shadow      sums over shared directions s_j, weights w_j = 4/N max(0, n.s_j), or 4 pi/N above the horizon for
//               transfer that holds no cosine: with S over the visible ones, S_all
//               over all of them and f = (sum of visible w) / (sum of w), T = S + f (T_unshadowed - S_all): a control
//               variate, exact if nothing is blocked, zero if everything is, continuous in between. Rays that
//               meet mirrors continue from there (prt/bake/row_tracer.hpp)
//   bounce      adds the light that bounces (prt/bake/bounces.hpp): the blocked rays are traced
//               again to find their closest hits
// The light that surfaces emit is kept separately (Transfer::emitted), including its bounces if the kind has bounces.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/checkpoint.hpp"
#include "prt/bake/row_tracer.hpp"

namespace sh::prt {

/// The state of a running bake: the input of its steps, and the results that each step leaves for the next. All
/// arguments must outlive this object. Mirrors are gray (prt/bake/bake.cpp handles the others).
struct BakeRun {
  BakeRun(const Scene& the_scene, const Scene& the_whole, const BakeSettings& the_settings,
          const std::vector<std::uint8_t>& open_vertices, std::shared_ptr<Tracer> the_tracer)
      : scene(the_scene),
        whole(the_whole),
        settings(the_settings),
        open(open_vertices),
        tracer(std::move(the_tracer)),
        transfer(Transfer::of(*the_scene.bake.kind, the_scene.bake.degree)) {}
  BakeRun(const BakeRun&) = delete;
  BakeRun& operator=(const BakeRun&) = delete;

  const Scene& scene;
  const Scene& whole;  // the scene, or the one whose channel it is: the checkpoint is that of all channels
  const BakeSettings& settings;
  const std::vector<std::uint8_t>& open;  // as in Plan
  std::shared_ptr<Tracer> tracer;         // of the mesh, if there is one
  Transfer transfer;                      // in the shape of the last finished step, without the mesh
  std::optional<RaySetup> rays;           // unless all are traced
  std::optional<FormFactors> factors;     // only for kinds with bounces
  std::optional<ShadowResult> found;
  std::optional<Checkpoint> checkpoint;
};

/// In: nothing. Out: the unshadowed numbers of a vertex, one channel, without the albedo.
void take_unshadowed(BakeRun& run);
/// In: unshadowed numbers. Out: the same numbers with shadows, and the Sight of every vertex.
void trace_shadows(BakeRun& run);
/// In: shadowed vectors and the form factors. Out: vectors of three channels that hold the albedo. Bounces that do not
/// converge are reported as a flaw.
void add_bounces(BakeRun& run);

/// Whether the bake traces rays: not where parts hold what all of them found, and no bounces follow.
bool traces_here(const Scene& scene, const BakeSettings& settings);

/// Where the iterates of bounces are kept; empty: nowhere.
inline std::string bounces_file(const CheckpointSettings& settings) {
  return settings.path.empty() || !settings.bounces.empty() ? settings.bounces : bounces_beside(settings.path);
}

/// The light that leaves every vertex without bounces, a panel of this layout: albedo * T, and the emission. `transfer`
/// holds shadowed vectors of one channel.
Panel direct_light(const Mesh& mesh, const Transfer& transfer, const BounceLayout& layout);
/// Takes the solution of the bounces into the numbers of the kind of `transfer`.
void take_solution(const Panel& x, const BounceLayout& layout, Transfer& transfer);

inline constexpr BakeStep kUnshadowedStep = {take_unshadowed};
inline constexpr BakeStep kShadowStep = {trace_shadows, true};
inline constexpr BakeStep kBounceStep = {add_bounces, true, true};

}  // namespace sh::prt
