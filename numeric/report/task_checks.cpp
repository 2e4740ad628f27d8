// See task_checks.hpp.
#include "numeric/report/task_checks.hpp"

#include "numeric/kernels/inputs.hpp"

namespace sh::numeric {

FamilyCheck task_check(const std::string& family) {
  FamilyCheck check = check_of(family);
  if (family == "basis_gradient") {
    constexpr int kRandomDirections = 400;
    check.inputs = [](int /*degree*/) { return direction_inputs(kRandomDirections); };
  }
  if (family == "project") {
    check.inputs = [inputs = check.inputs](int degree) {
      auto all = inputs(degree);
      std::erase_if(all, [](const NamedInput& input) { return input.values[3] != 1; });
      return all;
    };
  }
  return check;
}

}  // namespace sh::numeric
