// The generated C++ kernels as methods: one by one, and in pairs of which the first prepares for the second.
#include "numeric/kernels/kernel_search.hpp"
#include "numeric/report/method.hpp"
#include "numeric/report/tasks.hpp"

namespace sh::numeric {
namespace {

// A family that does a task, alone or after `first`: rotate_build makes the matrix, rotate_apply takes it and the rest.
struct Row {
  const char* task;
  const char* first;
  const char* family;
  const char* arguments;
  const char* leaves_out;
  Mode mode = Mode::kOne;  ///< kPrepared: the time is that of `family` alone
};

constexpr const char* kUnit = "takes |d| = 1 for granted";
constexpr const char* kRotation = "takes r for a rotation";
constexpr Row kRows[] = {
    {"basis", nullptr, "basis", "x, y, z, out", kUnit},
    {"basis", nullptr, "basis_normalised", "x, y, z, out", ""},
    {"gradient", nullptr, "basis_gradient", "x, y, z, out, dx, dy, dz", ""},
    {"evaluate", nullptr, "evaluate", "c, x, y, z", kUnit},
    {"project", nullptr, "project", "x, y, z, weight, sum", kUnit},
    {"rotate", nullptr, "rotate", "r, c, out", kRotation},
    {"rotate", nullptr, "rotate_quaternion", "q, c, out", "takes |q| = 1 for granted; rotations as quaternions"},
    {"product", nullptr, "product", "a, b, out", ""},
    {"cap", nullptr, "cap", "one_minus_cos, zonal", ""},
    {"zonal", nullptr, "zonal", "zonal, x, y, z, out", kUnit},
    {"irradiance", nullptr, "irradiance_evaluate", "c, x, y, z", kUnit},
    {"rotate", "rotate_build", "rotate_apply", "m, c, out", kRotation},
    {"rotate", "rotate_build", "rotate_apply", "m, c, out", "rotate_build, once for many functions", Mode::kPrepared},
    {"evaluate", "evaluate_prepare", "evaluate_prepared", "polynomial, x, y, z",
     "evaluate_prepare, once for many directions", Mode::kPrepared},
    {"irradiance", "irradiance", "evaluate", "c, x, y, z", "irradiance, once for many normals", Mode::kPrepared}};

const BoundKernel* find_kernel(const std::string& family, int degree) {
  static const std::vector<BoundKernel> kKernels = bound_kernels();
  const auto found = std::find_if(kKernels.begin(), kKernels.end(),
                                  [&](const BoundKernel& k) { return k.family == family && k.degree == degree; });
  return found == kKernels.end() ? nullptr : &*found;
}

template <class T>
Code<T> code_of(const BoundKernel& kernel) {
  return {[kernel](const Samples<T>& samples, T* out) {
            FlatCall<T> call(kernel, samples.signature);
            const auto outputs = samples.signature.output_count();
            for (std::size_t i = 0; i < samples.count(); ++i) call(samples.input(i), out + i * outputs);
          },
          [kernel](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            auto calls = calls_again(kernel, samples, timed_inputs(kernel.degree));
            return least_nanoseconds(calls, budget);
          }};
}

// Two kernels in a row.
struct Pair {
  BoundKernel first;
  Signature first_signature;
  BoundKernel second;
  Signature second_signature;

  // The inputs of the second kernel: the outputs of the first, and the inputs that it did not take.
  template <class T>
  [[nodiscard]] std::vector<T> between(const Samples<T>& samples, std::size_t i) const {
    std::vector<T> in(second_signature.input_count());
    FlatCall<T>(first, first_signature)(samples.input(i), in.data());
    std::copy(samples.input(i) + first_signature.input_count(), samples.input(i) + samples.signature.input_count(),
              in.begin() + first_signature.output_count());
    return in;
  }
};

template <class T>
Code<T> code_of(const Pair& pair, Mode mode) {
  struct Call {
    FlatCall<T> first, second;
    bool with_first;
    void operator()() {
      if (with_first) first.call_again();
      second.call_again();
    }
  };
  return {[pair](const Samples<T>& samples, T* out) {
            FlatCall<T> second(pair.second, pair.second_signature);
            const auto outputs = samples.signature.output_count();
            for (std::size_t i = 0; i < samples.count(); ++i)
              second(pair.between(samples, i).data(), out + i * outputs);
          },
          [pair, mode](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            std::vector<Call> calls;
            std::vector<T> unused(std::max(pair.first_signature.output_count(), pair.second_signature.output_count()));
            const std::size_t count = std::min(timed_inputs(pair.first.degree), samples.count());
            for (std::size_t i = samples.count() - count; i < samples.count(); ++i) {
              calls.push_back(
                  {{pair.first, pair.first_signature}, {pair.second, pair.second_signature}, mode == Mode::kOne});
              calls.back().first(samples.input(i), unused.data());
              calls.back().second(pair.between(samples, i).data(), unused.data());
            }
            return least_nanoseconds(calls, budget);
          }};
}

template <class T>
void add(std::vector<Method>& all, const Row& row, const BoundKernel& kernel) {
  MethodInfo info = {.task = row.task,
                     .name = kernel.family,
                     .degree = kernel.degree,
                     .mode = row.mode,
                     .header = "generated/cpp/" + kernel.name() + ".hpp",
                     .call = "sh::" + kernel.name() + "(" + row.arguments + ")",
                     .leaves_out = row.leaves_out,
                     .source = "generated; recipe and operations in generated/MANIFEST"};
  if (row.first == nullptr) {
    all.push_back(method_of(info, task_check(row.family), code_of<T>(kernel)));
    return;
  }
  const BoundKernel* const first = find_kernel(row.first, kernel.degree);
  if (first == nullptr) return;
  const bool irradiance = info.task == "irradiance";
  if (row.mode == Mode::kOne || irradiance) info.name = first->family + " + " + kernel.family;
  if (row.mode == Mode::kOne) info.call = "sh::" + first->name() + "(r, m), " + info.call;
  const Pair pair = {*first, task_check(row.first).signature(kernel.degree), kernel,
                     task_check(row.family).signature(kernel.degree)};
  all.push_back(method_of(info, task_check(irradiance ? "irradiance_evaluate" : row.task), code_of<T>(pair, row.mode)));
}

}  // namespace

void add_kernel_methods(std::vector<Method>& all, const std::string& task, int degree) {
  for (const Row& row : kRows) {
    for (const char* variant : {"", "_accurate"}) {
      if (row.task != task || (row.first != nullptr && *variant != 0)) continue;
      const BoundKernel* const kernel = find_kernel(std::string(row.family) + variant, degree);
      if (kernel == nullptr) continue;
      add<float>(all, row, *kernel);
      add<double>(all, row, *kernel);
    }
  }
}

template <class T>
std::vector<NamedInput> found_inputs(const FamilyCheck& check, int degree) {
  std::vector<NamedInput> inputs;
  for (const char* variant : {"", "_accurate"}) {
    const BoundKernel* const kernel = find_kernel(check.family + variant, degree);
    if (kernel == nullptr) continue;
    inputs.push_back({"input found by search", search_kernel<T>(*kernel, check, {}).worst_total.values});
  }
  return inputs;
}

template std::vector<NamedInput> found_inputs<float>(const FamilyCheck&, int);
template std::vector<NamedInput> found_inputs<double>(const FamilyCheck&, int);

}  // namespace sh::numeric
