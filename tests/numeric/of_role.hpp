// A parameter of a made-up kernel that is named by its role.
#pragma once

#include <string>

#include "numeric/kernels/signature.hpp"

namespace sh::numeric::test {

inline Parameter of_role(const std::string& role, int count = 0, Access access = Access::kIn) {
  Parameter parameter{role, count, access};
  parameter.role = role;
  return parameter;
}

}  // namespace sh::numeric::test
