// Recipe: exit radiance of diffuse vertices, the scalar product of their transfer with the light.
//
// The terms are added in the order of their index, so that plain loops in any language give the same bits.
#include "codegen/recipes/product/product.hpp"

namespace sh::codegen::recipes {

Kernel relight(int degree, int transfer_channels, int light_channels) {
  const int count = coefficient_count(degree);
  Kernel kernel;
  kernel.citation = "P.-P. Sloan, J. Kautz, J. Snyder, \"Precomputed Radiance Transfer\", SIGGRAPH 2002, section 4.1";
  kernel.title = "Exit radiance of a diffuse vertex: transfer of " + degrees_to(degree) + " under a light";
  kernel.domain = "any coefficients; orthonormal on the unit sphere, no Condon-Shortley phase, at index l(l+1)+m";
  kernel.parameters = {array(Role::kCoefficients, "transfer", degree, transfer_channels),
                       array(Role::kLight, "light", degree, light_channels)};
  const std::string sum = "the sum of transfer_lm light_lm, the integral of both functions' product";
  if (light_channels == 1) {
    kernel.result = "returns " + sum;
    kernel.results = {parameter(Role::kValue, "value")};
    kernel.outputs = {{-1, ""}};
  } else {
    kernel.result = "red, green, blue: " + sum + (transfer_channels == 1 ? "" : ", channel by channel");
    kernel.results = {{"rgb", {3}, Role::kValue}};
    kernel.outputs = {{-1, "red"}, {-1, "green"}, {-1, "blue"}};
  }
  Builder build(kernel);
  const std::vector<NodeId> transfer = inputs(build, 0, transfer_channels * count, "t");
  const std::vector<NodeId> light = inputs(build, transfer_channels * count, light_channels * count, "l");
  std::vector<NodeId> sums;
  for (int channel = 0; channel < light_channels; ++channel) {
    const int first = transfer_channels == 1 ? 0 : channel * count;
    NodeId total = build.mul(transfer[first], light[channel * count]);
    for (int i = 1; i < count; ++i) {
      const NodeId term = build.mul(transfer[first + i], light[channel * count + i]);
      total = build.add(total, term);
    }
    sums.push_back(total);
  }
  set_outputs(kernel, sums);
  return kernel;
}

}  // namespace sh::codegen::recipes
