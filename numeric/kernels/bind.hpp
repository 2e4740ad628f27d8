// The generated C++ kernels as data: by name a function to call on float, double and Wide, and its arguments.
//
// The list is made by kernel_bindings.cmake from the files in generated/cpp: one row a kernel, two source files a
// group of families. Only shcheck and the tests include this: numeric's library knows nothing of the generated code.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "numeric/kernels/wide.hpp"

namespace sh::numeric {

enum class ArgumentKind { kValue, kReadArray, kWriteArray };

/// arguments[i] points to the values of parameter i; the returned value goes to arguments[number of parameters].
template <class T>
using PointerCall = void (*)(T* const* arguments);

struct BoundKernel {
  std::string family;  // "basis", "basis_accurate"
  int degree = 0;
  std::vector<ArgumentKind> arguments;
  bool returns_value = false;
  PointerCall<float> in_float = nullptr;
  PointerCall<double> in_double = nullptr;
  PointerCall<Wide> in_wide = nullptr;

  [[nodiscard]] std::string name() const { return family + "_l" + std::to_string(degree); }
  template <class T>
  [[nodiscard]] PointerCall<T> call() const {
    if constexpr (std::is_same_v<T, float>) {
      return in_float;
    } else if constexpr (std::is_same_v<T, double>) {
      return in_double;
    } else {
      return in_wide;
    }
  }
};

/// Every generated kernel, by family and degree.
std::vector<BoundKernel> bound_kernels();

namespace detail {

template <class P, class T>
P pass(T* argument) {
  if constexpr (std::is_pointer_v<P>) {
    return argument;
  } else {
    return *argument;
  }
}

template <class P>
constexpr ArgumentKind argument_kind() {
  if (!std::is_pointer_v<P>) return ArgumentKind::kValue;
  return std::is_const_v<std::remove_pointer_t<P>> ? ArgumentKind::kReadArray : ArgumentKind::kWriteArray;
}

// The function sh::NAME<T> behind a PointerCall<T>.
template <class T, auto kFunction>
struct Binding;

template <class T, class Result, class... P, Result (*kFunction)(P...) noexcept>
struct Binding<T, kFunction> {
  static constexpr bool kReturns = !std::is_void_v<Result>;
  static std::vector<ArgumentKind> arguments() { return {argument_kind<P>()...}; }
  static void call(T* const* arguments) { call_with(arguments, std::index_sequence_for<P...>()); }

 private:
  template <std::size_t... kIndex>
  static void call_with(T* const* arguments, std::index_sequence<kIndex...> /*indices*/) {
    if constexpr (kReturns) {
      *arguments[sizeof...(P)] = kFunction(pass<P>(arguments[kIndex])...);
    } else {
      kFunction(pass<P>(arguments[kIndex])...);
    }
  }
};

}  // namespace detail

/// One row of the list: bind<&basis_l4<float>, &basis_l4<double>>("basis", 4). Wide comes from another source file.
template <auto kInFloat, auto kInDouble>
BoundKernel bind(const char* family, int degree) {
  using Float = detail::Binding<float, kInFloat>;
  return {.family = family,
          .degree = degree,
          .arguments = Float::arguments(),
          .returns_value = Float::kReturns,
          .in_float = Float::call,
          .in_double = detail::Binding<double, kInDouble>::call};
}

/// The kernels of a family, in_wide[i] for family[i].
inline void append(std::vector<BoundKernel>& all, std::vector<BoundKernel> family,
                   const std::vector<PointerCall<Wide>>& in_wide) {
  for (std::size_t i = 0; i < family.size(); ++i) {
    family[i].in_wide = in_wide[i];
    all.push_back(std::move(family[i]));
  }
}

}  // namespace sh::numeric
