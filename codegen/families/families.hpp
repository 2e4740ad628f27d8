// Every family of kernels: its recipes, its exact reference, where it is measured. One file a family.
#pragma once

#include "codegen/family.hpp"

namespace sh::codegen {

Family basis_family();

}  // namespace sh::codegen
