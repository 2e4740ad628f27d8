// Transfer of diffuse surfaces: the dot product of a vector and the light is exit radiance.
#include <array>

#include "prt/bake/steps.hpp"
#include "prt/kinds/kinds.hpp"

namespace sh::prt {

namespace {

// Holds the cosine and 1/pi: exit radiance = albedo * sum_i T_i L_i.
TransferShape without_albedo(int degree) { return {.degree = degree}; }

// Holds cosine, 1/pi and albedo: exit radiance of channel c = sum_i T_ci L_ci.
TransferShape with_albedo(int degree) { return {.channels = 3, .degree = degree, .holds_albedo = true}; }

// Lengths: one channel that serves all colors, of no albedo.
TransferShape of_lengths(int degree) { return {.degree = degree, .holds_albedo = true}; }

constexpr std::array kSteps = {kUnshadowedStep, kShadowStep, kBounceStep};

}  // namespace

constinit const TransferKind kUnshadowed = {"DU", "unshadowed", without_albedo, std::span(kSteps).first(1)};
constinit const TransferKind kShadowed = {"DS", "shadowed", without_albedo, std::span(kSteps).first(2)};
constinit const TransferKind kInterreflected = {"DI", "interreflected", with_albedo, kSteps, &kShadowed};
constinit const TransferKind kTranslucent = {"DT", "translucent", with_albedo, std::span(kSteps).first(2)};
constinit const TransferKind kThickness = {
    .letters = "TH", .word = "thickness", .shape = of_lengths, .steps = {}, .is_length = true};

}  // namespace sh::prt
