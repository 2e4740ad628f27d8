#include "numeric/report/tasks.hpp"

#include <algorithm>
#include <stdexcept>

#include "numeric/kernels/inputs.hpp"

namespace sh::numeric {

const std::vector<Task>& all_tasks() {
  static const std::vector<int> kQuick = {2, 4, 6, 9};
  static const std::vector<int> kFull = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  static const std::vector<Task> kTasks = {
      {"basis", "Basis", "A direction to the values of every function.", "a value", kQuick, kFull,
       "`shgen emit basis` prints kernels to degree 20; sh::numeric::basis (numeric/oracle/basis.hpp) takes any "
       "degree"},
      {"gradient", "Values and gradients",
       "A direction to the values of the solid harmonics and their derivatives by x, y and z.",
       "a value or derivative, at |d| = 1", kQuick, kFull,
       "`shgen emit basis_gradient` prints kernels to degree 20; sh::numeric::basis_gradient "
       "(numeric/oracle/basis.hpp) takes any degree"},
      {"evaluate", "Evaluation", "Coefficients and a direction to the value of the function.",
       "the value, for coefficients of length 1", kQuick, kFull,
       "`shgen emit evaluate` prints kernels to degree 20; beyond it, sum over sh::numeric::basis, and over whole "
       "rings with numeric/oracle/legendre_rings.hpp"},
      {"project", "Projection of a sample", "A direction and a weight, added to coefficients.",
       "a coefficient, for weights of 1 and sums up to 1", kQuick, kFull,
       "`shgen emit project` prints kernels to degree 20; beyond it, numeric/sampling/projection.hpp projects at the "
       "nodes of a rule"},
      {"rotate", "Rotation", "A rotation and coefficients to the coefficients of the rotated function.",
       "a coefficient, for coefficients of length 1", std::vector{2, 4, 6, 9, 30},
       std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 50, 100},
       "sh::numeric::rotate_zxz_rows (numeric/methods/zxz_rows.hpp) takes degrees to 1936"},
      {"product", "Product", "Two functions to their product, projected on the same bands.",
       "a coefficient, for factors of length 1", kQuick, kFull,
       "`shgen emit product` prints kernels to degree 12; beyond it, evaluate both at the nodes of "
       "sh::numeric::sphere_rule (numeric/oracle/quadrature.hpp), multiply and project"},
      {"cap", "Zonal coefficients of a cap",
       "The size of a disc of light, 1 - cos of its half-angle, to its zonal coefficients.",
       "a coefficient, relative to the largest that its band has for a cap of this size: tiny caps count as much as "
       "large ones",
       kQuick, kFull,
       "`shgen emit cap` prints kernels to degree 20; sh::numeric::cap_zonal (numeric/oracle/zonal.hpp) takes any "
       "degree",
       true},
      {"zonal", "Turning a zonal function", "Zonal coefficients and a direction to coefficients.",
       "a coefficient, for zonal coefficients of length 1", kQuick, kFull,
       "`shgen emit zonal` prints kernels to degree 20; beyond it, scale sh::numeric::basis of the direction by sqrt(4 "
       "pi / (2l+1)) zonal[l]"},
      {"irradiance", "Irradiance", "Coefficients of the light and a normal to the irradiance there.",
       "the irradiance, for coefficients of length 1", std::vector{2, 4}, std::vector{1, 2, 3, 4, 6, 8, 10},
       "`shgen emit irradiance_evaluate` prints kernels to degree 20; sh::numeric::clamped_cosine_factor "
       "(numeric/oracle/zonal.hpp) has A_l of any degree"},
      {"legendre", "Legendre functions of high degree",
       "A colatitude to all normalized P_lm, 0 \u2264 m \u2264 l \u2264 degree.",
       "a value; the largest of all is about sqrt(degree / 6)", std::vector{10, 100, 300},
       std::vector{10, 30, 100, 300, 1000}, "numeric/oracle/legendre_values.hpp takes higher degrees"},
  };
  return kTasks;
}

const Task& find_task(const std::string& option, const std::string& id) {
  std::string names;
  for (const Task& task : all_tasks()) {
    if (task.id == id) return task;
    names += (names.empty() ? "" : ", ") + task.id;
  }
  throw std::invalid_argument(option + ": expected one of " + names + ", got '" + id + "'");
}

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
