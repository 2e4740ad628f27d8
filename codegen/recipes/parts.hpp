// Parts that all recipes share: texts, inputs and outputs, and kernels inside kernels.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::codegen::recipes {

using numeric::coefficient_count;
using numeric::coefficient_index;

/// "degree 0 to 4"
std::string degrees_to(int degree);
/// The name of value i: "z4".
std::string numbered(const std::string& letter, int i);
/// The name of a value of degree l and order m: "p_4_2".
std::string indexed(const std::string& letter, int l, int m);

/// The nodes of x, y, z.
struct Direction {
  NodeId x, y, z;
};

/// The inputs from `first` on as x, y, z.
Direction direction_inputs(Builder& build, int first = 0);
/// `count` inputs from `first` on with the names c0, c1, ... for the letter c.
std::vector<NodeId> inputs(Builder& build, int first, int count, const std::string& letter);

/// Makes (degree+1)^2 outputs for each channel and gives them labels such as "l=2 m=-1", in order of the index
/// l(l+1)+m.
void label_coefficients(Kernel& kernel, int degree, int channels = 1);
/// Makes node i output i, which exists already.
void set_outputs(Kernel& kernel, const std::vector<NodeId>& nodes);

/// Appends the nodes of `part` and returns its flattened results. inputs: the nodes of its flattened parameters.
std::vector<NodeId> splice(Builder& build, const Kernel& part, const std::vector<NodeId>& inputs);

}  // namespace sh::codegen::recipes
