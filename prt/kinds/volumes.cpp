// Transfer to points of space: what an object or a medium around them does to the light.
#include "prt/basis.hpp"
#include "prt/kinds/kinds.hpp"

namespace sh::prt {

namespace {

constexpr int kResultDegree = 4;

// The visibility, 1 where the object does not block the sphere: its product with light of this degree, on the bands of the
// result, needs no more than both degrees together.
TransferShape visibility(int degree) {
  return {.degree = degree, .result_degree = kResultDegree, .meets = Meets::kOperator, .holds_cosine = false};
}

// What the object sends to the point, linear in the light: its albedos and mirrors are in it.
TransferShape sent(int degree) {
  TransferShape shape{
      .channels = 3, .degree = degree, .result_degree = kResultDegree, .holds_cosine = false, .holds_albedo = true};
  shape.storage.element = Element::kHalf;
  return shape;
}

// What scatters at a point, with the albedo: radiance, or coefficients of the direction in which it is seen.
TransferShape scattered(int degree) { return {.channels = 3, .degree = degree, .holds_albedo = true}; }

}  // namespace

constinit const TransferKind kNeighborhood = {"N",     "neighborhood", visibility, {}, nullptr, kHighestProduct,
                                              nullptr, true,           true};
constinit const TransferKind kReflectingNeighborhood = {
    "NI", "reflecting_neighborhood", visibility, {}, nullptr, kHighestProduct, sent, true, true};
constinit const TransferKind kMedium = {"DV", "medium", scattered, {}, nullptr, kMaxDegree, nullptr, true, true, true};

}  // namespace sh::prt
