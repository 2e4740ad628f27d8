// Transfer of glossy surfaces: the radiance that reaches a vertex, as a function of direction. The run time multiplies it
// with the material's lobe about the mirrored direction of view (prt/runtime/glossy.hpp).
#include <array>

#include "prt/bake/glossy_bounces.hpp"
#include "prt/basis.hpp"
#include "prt/kinds/kinds.hpp"

namespace sh::prt {

namespace {

// The visibility, 1 where the sky is seen from the vertex: its product with light of this degree, on the bands of the
// light, needs no more than twice the degree.
TransferShape visibility(int degree) {
  return {.degree = degree, .result_degree = degree, .meets = Meets::kOperator, .holds_cosine = false};
}

// The light itself.
TransferShape nothing(int degree) {
  return {.degree = degree, .result_degree = degree, .meets = Meets::kNothing, .holds_cosine = false};
}

// What other surfaces send, linear in the light: their albedos and lobes are in it.
TransferShape matrix(int degree) {
  TransferShape shape{
      .channels = 3, .degree = degree, .result_degree = degree, .holds_cosine = false, .holds_albedo = true};
  shape.storage.element = Element::kHalf;
  return shape;
}

constexpr std::array kSteps = {kUnshadowedStep, kShadowStep, kGlossyBounceStep};

}  // namespace

constinit const TransferKind kGlossyUnshadowed = {"GU", "glossy_unshadowed", nothing, std::span(kSteps).first(1)};
constinit const TransferKind kGlossyShadowed = {"GS",    "glossy_shadowed", visibility, std::span(kSteps).first(2),
                                                nullptr, kHighestProduct};
constinit const TransferKind kGlossyInterreflected = {
    "GI", "glossy_interreflected", visibility, kSteps, &kGlossyShadowed, kHighestProduct, matrix};

}  // namespace sh::prt
