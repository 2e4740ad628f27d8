// A way to compute something, as data: what it is, how it is run over inputs, how it is timed.
//
// Every method of a task and degree has a check (kernels/family_check.hpp): signature, inputs, exact values, unit of the
// error. Values travel flat, in the order of signature.hpp. Adding a method: make one with method_of and a code of
// code.hpp, in a function that methods.cpp lists.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/samples.hpp"

namespace sh::numeric {

// What a time counts.
enum class Mode {
  kOne,       // one call, everything in it
  kPrepared,  // one call, after what many calls share was computed once
  kBatch,     // one record of many that one call works on
};
const char* to_string(Mode mode);  // "one", "prepared", "batch"

struct MethodInfo {
  std::string task;  // of tasks.hpp
  std::string name;  // "rotate_accurate": the same in all degrees and types
  int degree = 0;
  std::string scalar;  // "float", "double"
  Mode mode = Mode::kOne;
  std::string header;      // what to include; empty: a control of this comparison
  std::string call;        // how it is called
  std::string leaves_out;  // what it assumes or does not do, in a line; empty: nothing
  std::string source;      // author, year; or the recipe
};

// T: float or double.
template <class T>
struct Code {
  // out (n, output_count): the values at every input.
  std::function<void(const Samples<T>&, T* out)> run;
  // The least of several passes, nanoseconds as Mode says. Budget: of time to spend.
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

}  // namespace sh::numeric
