// A method to do a task, as data: its description, a function that runs it over inputs, a function that measures its time.
//
// Every method of a task and degree has a check (kernels/family_check.hpp): signature, inputs, exact values, unit of the
// error. Values travel flat, in the order of signature.hpp. To add a method, make it with method_of in a function that
// methods_of calls.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/samples.hpp"
#include "numeric/kernels/timing.hpp"

namespace sh::numeric {

/// The meaning of a time.
enum class Mode {
  kOne,       ///< of one call, everything in it
  kPrepared,  ///< of one call, after the part that many calls share
  kBatch,     ///< of one record of many that one call works on
};
inline constexpr std::array<Mode, 3> kModes = {Mode::kOne, Mode::kPrepared, Mode::kBatch};
/// "one", "prepared", "batch".
inline const char* to_string(Mode mode) {
  return mode == Mode::kOne ? "one" : mode == Mode::kPrepared ? "prepared" : "batch";
}

struct MethodInfo {
  std::string task;  ///< of tasks.hpp
  std::string name;  ///< "rotate_accurate": the same in all degrees and types
  int degree = 0;
  std::string scalar = {};  ///< "float", "double"
  Mode mode = Mode::kOne;
  std::string header = {};      ///< the header to include
  std::string call = {};        ///< the call
  std::string leaves_out = {};  ///< in a line: what the method assumes or does not do; empty: nothing
  std::string source = {};      ///< author, year; or the recipe
};

/// T: float or double.
template <class T>
struct Code {
  /// out (n, output_count): the values at every input.
  std::function<void(const Samples<T>&, T* out)> run;
  /// The least of several passes, in nanoseconds, as Mode says; `budget` is the time to spend.
  std::function<double(const Samples<T>&, std::chrono::nanoseconds budget)> time;
};

struct Method {
  MethodInfo info;
  FamilyCheck check;
  std::variant<Code<float>, Code<double>> code;
};

template <class T>
Method method_of(MethodInfo info, FamilyCheck check, Code<T> code) {
  info.scalar = std::is_same_v<T, float> ? "float" : "double";
  return {std::move(info), std::move(check), std::move(code)};
}

/// The number of inputs that a timed pass goes through: few where one call takes long.
inline std::size_t timed_inputs(int degree) { return degree > 10 ? 2 : 16; }

/// function(in, out), flat.
template <class T>
using FlatFunction = std::function<void(const T*, T*)>;

template <class T>
std::function<void(const Samples<T>&, T*)> runner_of(FlatFunction<T> function) {
  return [function](const Samples<T>& samples, T* out) {
    for (std::size_t i = 0; i < samples.count(); ++i) {
      function(samples.input(i), out);
      out += samples.signature.output_count();
    }
  };
}

template <class T>
Code<T> code_of(FlatFunction<T> function, int degree) {
  return {runner_of(function), [function, degree](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            std::vector<T> out(samples.signature.output_count());
            std::vector<std::function<void()>> calls;
            const std::size_t count = std::min(timed_inputs(degree), samples.count());
            for (std::size_t i = samples.count() - count; i < samples.count(); ++i) {
              calls.emplace_back([&, i] { function(samples.input(i), out.data()); });
            }
            return least_nanoseconds(calls, budget);
          }};
}

/// Every method of a task: generated kernels, batches, and the methods of others, in the order of legends. `degree` is
/// in the range of the task.
std::vector<Method> methods_of(const std::string& task, int degree);

/// methods_of joins these, one from each file.
void add_kernel_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_batch_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_table_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_textbook_methods(std::vector<Method>& all, const std::string& task, int degree);

/// The worst inputs that a search finds for the generated kernels of the check's family (kernel_search.hpp), T float or
/// double; none where there is no kernel.
template <class T>
std::vector<NamedInput> found_inputs(const FamilyCheck& check, int degree);

}  // namespace sh::numeric
