// The parts that all recipes of products share: parameters, results and texts.
#include "codegen/recipes/product/product.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

std::string degrees(int degree) { return degree == 0 ? "degree 0" : "degree 0 to " + std::to_string(degree); }

}  // namespace

Kernel product_frame(const ProductShape& shape, Factors factors) {
  Kernel kernel;
  const bool same = factors == Factors::kSame;
  const bool exact = shape.result >= shape.a + shape.b;
  kernel.title = (same ? "The square of a function on the sphere" : "The product of two functions on the sphere") +
                 std::string(exact ? ", complete, in " : ", projected on ") + degrees(shape.result);
  kernel.domain = "any coefficients";
  if (shape.a != shape.b) kernel.domain += ": a has " + degrees(shape.a) + ", b has " + degrees(shape.b);
  kernel.result = std::string("coefficients of ") + (same ? "a a" : "a b") +
                  " at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = {array(Role::kCoefficients, "a", shape.a)};
  if (!same) kernel.parameters.push_back(array(Role::kCoefficients, "b", shape.b));
  kernel.results = {array(Role::kCoefficients, "out", shape.result)};
  kernel.outputs.resize(coefficient_count(shape.result));
  return kernel;
}

void set_coefficient(Kernel& kernel, int index, NodeId node) {
  const symbolic::DegreeOrder lm = symbolic::degree_order(index);
  kernel.outputs[index] = {node, "l=" + std::to_string(lm.degree) + " m=" + std::to_string(lm.order)};
}

}  // namespace sh::codegen::recipes
