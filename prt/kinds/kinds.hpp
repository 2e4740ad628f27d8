// The kinds of transfer: names, shape of what a receiver stores, and the steps by which a bake makes it. A new kind needs a
// definition in a file of this folder, a line here and a line in a list of kinds.cpp.
#pragma once
#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

struct BakeRun;

/// A part of a bake that continues the steps before it; prt/bake/steps.hpp lists the steps.
struct BakeStep {
  void (*run)(BakeRun& run);
  bool traces_rays = false;
  bool bounces = false;  // needs the hits of the rays: the form factors
};

struct TransferKind {
  std::string_view letters;  // in files, as Sloan, Kautz and Snyder 2002 write
  std::string_view word;     // in scenes and on command lines
  /// The shape of a vertex's numbers for light of this degree, in plain storage.
  TransferShape (*shape)(int degree);
  std::span<const BakeStep> steps;                // in order
  const TransferKind* without_bounces = nullptr;  // the same kind without bounces; null if it has none
  int highest_degree = kMaxDegree;                // of the light
  /// The shape of the matrices (Transfer::indirect) that bring light over other surfaces; null: there are none.
  TransferShape (*indirect)(int degree) = nullptr;
  /// True if the receivers are the points of a grid, false if they are the vertices of a mesh.
  bool on_grid = false;
  /// True if the result may have any degree up to `highest_degree`; else shape() gives it.
  bool any_result = false;
  /// True if the receivers are inside a medium, whose density (Transfer::density) goes with their transfer.
  bool in_medium = false;
  /// True if the numbers are lengths by direction, in the unit of the scene, and meet no light.
  bool is_length = false;

  /// True if a vertex keeps the radiance that reaches it, as a function of direction, and its material decides at run
  /// time what leaves it towards the eye.
  [[nodiscard]] bool is_glossy() const { return !shape(0).holds_cosine; }
  [[nodiscard]] bool is_diffuse() const { return !is_glossy(); }
  [[nodiscard]] bool stores_numbers() const { return shape(0).length() > 0; }
  [[nodiscard]] bool stores_visibility() const { return shape(0).meets == Meets::kOperator; }
  [[nodiscard]] bool stores_matrices() const { return indirect != nullptr; }
  /// The shape of the numbers that rays give, before albedo and bounces: one channel.
  [[nodiscard]] TransferShape traced_shape(int degree) const {
    TransferShape traced = shape(degree);
    traced.channels = 1;
    traced.holds_albedo = false;
    return traced;
  }
  [[nodiscard]] bool traces_rays() const {
    return std::any_of(steps.begin(), steps.end(), [](const BakeStep& step) { return step.traces_rays; });
  }
  /// True if the bounces solve a system of form factors: those of diffuse surfaces.
  [[nodiscard]] bool has_form_factors() const { return has_bounces() && !is_glossy(); }
  [[nodiscard]] bool has_bounces() const {
    return std::any_of(steps.begin(), steps.end(), [](const BakeStep& step) { return step.bounces; });
  }
};

/// Diffuse surfaces [SloanKautzSnyder02]. Unshadowed (DU): every vertex sees its whole hemisphere. Shadowed (DS): rays
/// find the visible part. Interreflected (DI): light also bounces between the surfaces, any number of times.
extern const TransferKind kUnshadowed;
extern const TransferKind kShadowed;
extern const TransferKind kInterreflected;

/// Glossy surfaces [SloanKautzSnyder02, section 4.2]. Unshadowed (GU): the light reaches every vertex. Shadowed (GS): rays
/// find the directions from which it does. Interreflected (GI): light also bounces between the surfaces.
extern const TransferKind kGlossyUnshadowed;
extern const TransferKind kGlossyShadowed;
extern const TransferKind kGlossyInterreflected;

/// Bodies that let light through (DT): diffuse surfaces with the light that goes through what is behind them
/// (prt/translucent/bake_translucent.hpp); and the thickness of bodies by direction (TH).
extern const TransferKind kTranslucent;
extern const TransferKind kThickness;

/// The space around an object [SloanKautzSnyder02, section 8] (N): every point of a grid keeps the part of the sphere that
/// the object does not block. With reflection (NI) it also keeps matrices of what the object sends to it: color, caustics.
extern const TransferKind kNeighborhood;
extern const TransferKind kReflectingNeighborhood;

/// Inside a medium [SloanKautzSnyder02, section 7] (DV): every point of a grid keeps the light that scatters there, as
/// radiance or, where the phase function prefers a direction, as coefficients of the direction in which the point is seen.
extern const TransferKind kMedium;

using TransferKinds = std::span<const TransferKind* const>;

/// The kinds that `prt bake` makes, whose receivers are vertices; these and DT, with which light shows surfaces; all whose
/// receivers are vertices; those of volumes around objects and those of media, whose receivers are the points of a grid;
/// and all that a file may have.
TransferKinds transfer_kinds();
TransferKinds surface_kinds();
TransferKinds vertex_kinds();
TransferKinds volume_kinds();
TransferKinds medium_kinds();
TransferKinds file_kinds();

/// The name of a kind by which to find it: &TransferKind::letters or &TransferKind::word.
using KindName = std::string_view TransferKind::*;

/// The kind in `kinds` with this name; null if there is none.
const TransferKind* find_kind(KindName name, std::string_view value, TransferKinds kinds = transfer_kinds());

/// The names of all kinds, in order, for command lines and messages.
std::vector<std::string_view> kind_names(KindName name, TransferKinds kinds = transfer_kinds());

}  // namespace sh::prt
