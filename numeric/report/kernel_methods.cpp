// The generated C++ kernels as methods: one by one, and in pairs of which the first prepares for the second.
#include <algorithm>
#include <array>
#include <optional>

#include "numeric/kernels/kernel_search.hpp"
#include "numeric/report/code.hpp"
#include "numeric/report/methods.hpp"
#include "numeric/report/task_checks.hpp"

namespace sh::numeric {
namespace {

// A family that does a task in one call.
struct Single {
  const char* task;
  const char* family;
  const char* arguments;
  const char* leaves_out;
};

constexpr const char* kUnit = "takes |d| = 1 for granted";
constexpr const char* kRotation = "takes r for a rotation";
constexpr std::array<Single, 11> kSingles = {
    {{"basis", "basis", "x, y, z, out", kUnit},
     {"basis", "basis_normalised", "x, y, z, out", ""},
     {"gradient", "basis_gradient", "x, y, z, out, dx, dy, dz", ""},
     {"evaluate", "evaluate", "c, x, y, z", kUnit},
     {"project", "project", "x, y, z, weight, sum", kUnit},
     {"rotate", "rotate", "r, c, out", kRotation},
     {"rotate", "rotate_quaternion", "q, c, out", "takes |q| = 1 for granted; rotations as quaternions"},
     {"product", "product", "a, b, out", ""},
     {"cap", "cap", "one_minus_cos, zonal", ""},
     {"zonal", "zonal", "zonal, x, y, z, out", kUnit},
     {"irradiance", "irradiance_evaluate", "c, x, y, z", kUnit}}};

// Two families in a row that do a task.
struct Double {
  const char* task;
  const char* first;
  const char* second;
  const char* arguments;
  Mode mode;
  const char* leaves_out;
};

constexpr std::array<Double, 4> kDoubles = {
    {{"rotate", "rotate_build", "rotate_apply", "m, c, out", Mode::kOne, kRotation},
     {"rotate", "rotate_build", "rotate_apply", "m, c, out", Mode::kPrepared, "rotate_build, once for many functions"},
     {"evaluate", "evaluate_prepare", "evaluate_prepared", "polynomial, x, y, z", Mode::kPrepared,
      "evaluate_prepare, once for many directions"},
     {"irradiance", "irradiance", "evaluate", "c, x, y, z", Mode::kPrepared, "irradiance, once for many normals"}}};

const std::vector<BoundKernel>& kernels() {
  static const std::vector<BoundKernel> all = bound_kernels();
  return all;
}

const BoundKernel* find_kernel(const std::string& family, int degree) {
  const auto found = std::find_if(kernels().begin(), kernels().end(),
                                  [&](const BoundKernel& k) { return k.family == family && k.degree == degree; });
  return found == kernels().end() ? nullptr : &*found;
}

MethodInfo info_of(const char* task, const std::string& family, int degree, const char* arguments) {
  const std::string kernel = family + "_l" + std::to_string(degree);
  return {.task = task,
          .name = family,
          .degree = degree,
          .scalar = {},
          .mode = Mode::kOne,
          .header = "generated/cpp/" + kernel + ".hpp",
          .call = "sh::" + kernel + "(" + arguments + ")",
          .leaves_out = {},
          .source = "generated; recipe and operations in generated/MANIFEST"};
}

template <class T>
void add_single(std::vector<Method>& all, const Single& row, const BoundKernel& kernel) {
  auto info = info_of(row.task, kernel.family, kernel.degree, row.arguments);
  info.leaves_out = row.leaves_out;
  all.push_back(method_of(info, task_check(row.family), code_of<T>(kernel)));
}

template <class T>
void add_double(std::vector<Method>& all, const Double& row, const std::string& task_family, const BoundKernel& first,
                const BoundKernel& second) {
  const int degree = first.degree;
  const Pair pair = {first, task_check(row.first).signature(degree), second, task_check(row.second).signature(degree)};
  auto info = info_of(row.task, row.second, degree, row.arguments);
  info.mode = row.mode;
  info.leaves_out = row.leaves_out;
  if (row.mode == Mode::kOne || info.task == "irradiance") info.name = std::string(row.first) + " + " + row.second;
  if (row.mode == Mode::kOne) info.call = "sh::" + first.name() + "(r, m), " + info.call;
  all.push_back(method_of(info, task_check(task_family), code_of<T>(pair, row.mode)));
}

}  // namespace

void add_kernel_methods(std::vector<Method>& all, const std::string& task, int degree) {
  for (const auto& row : kSingles) {
    for (const char* variant : {"", "_accurate"}) {
      const auto* const kernel = row.task != task ? nullptr : find_kernel(std::string(row.family) + variant, degree);
      if (kernel == nullptr) continue;
      add_single<float>(all, row, *kernel);
      add_single<double>(all, row, *kernel);
    }
  }
  for (const auto& row : kDoubles) {
    const auto* const first = row.task != task ? nullptr : find_kernel(row.first, degree);
    const auto* const second = find_kernel(row.second, degree);
    if (first == nullptr || second == nullptr) continue;
    const std::string family = task == "irradiance" ? "irradiance_evaluate" : task;
    add_double<float>(all, row, family, *first, *second);
    add_double<double>(all, row, family, *first, *second);
  }
}

template <class T>
std::vector<NamedInput> found_inputs(const FamilyCheck& check, int degree) {
  std::vector<NamedInput> inputs;
  for (const char* variant : {"", "_accurate"}) {
    const auto* const kernel = find_kernel(check.family + variant, degree);
    if (kernel == nullptr) continue;
    const auto result = search_kernel<T>(*kernel, check, {});
    inputs.push_back({"input found by search", result.worst_total.values});
  }
  return inputs;
}

template std::vector<NamedInput> found_inputs<float>(const FamilyCheck&, int);
template std::vector<NamedInput> found_inputs<double>(const FamilyCheck&, int);

}  // namespace sh::numeric
