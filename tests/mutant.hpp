// Operators of which the program flips one while it runs, the one whose number the environment variable MUTANT names.
// tests/mutate_source.py puts them into a copy of a file, so that one compilation serves all flips: `a < b` becomes
// `a < mutant::Less{7} < b`, which keeps precedence and grouping.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace mutant {

inline const int active = std::getenv("MUTANT") == nullptr ? -1 : std::atoi(std::getenv("MUTANT"));

constexpr bool is(int number) { return !std::is_constant_evaluated() && active == number; }

/// Exit codes of tests: the flip does not compile, or only a compilation of its own can tell.
inline constexpr int kDoesNotCompile = 1;
inline constexpr int kUnknown = 77;

/// `kept` is a type, `flipped` an expression: flips where the types allow it.
#define SHFORGE_FLIP_TO(kept, flipped, number)                           \
  if constexpr (!requires { flipped; }) {                                \
    if (is(number)) std::_Exit(kDoesNotCompile);                         \
  } else if constexpr (std::is_convertible_v<decltype(flipped), kept>) { \
    if (is(number)) return static_cast<kept>(flipped);                   \
  } else {                                                               \
    if (is(number)) std::_Exit(kUnknown);                                \
  }

#define SHFORGE_BINARY(Name, op, other)                                               \
  struct Name {                                                                       \
    int number;                                                                       \
  };                                                                                  \
  template <class L>                                                                  \
  struct Name##Left {                                                                 \
    L&& left;                                                                         \
    int number;                                                                       \
  };                                                                                  \
  template <class L>                                                                  \
  constexpr Name##Left<L> operator op(L&& left, Name at) {                            \
    return {std::forward<L>(left), at.number};                                        \
  }                                                                                   \
  template <class L, class R>                                                         \
  constexpr decltype(auto) operator op(Name##Left<L> l, R&& r) {                      \
    using Kept = decltype(std::forward<L>(l.left) op std::forward<R>(r));             \
    SHFORGE_FLIP_TO(Kept, std::forward<L>(l.left) other std::forward<R>(r), l.number) \
    return std::forward<L>(l.left) op std::forward<R>(r);                             \
  }

#define SHFORGE_ASSIGNMENT(Name, op, other)                           \
  struct Name {                                                       \
    int number;                                                       \
  };                                                                  \
  template <class R>                                                  \
  struct Name##Right {                                                \
    R&& right;                                                        \
    int number;                                                       \
  };                                                                  \
  template <class R>                                                  \
  constexpr Name##Right<R> operator op(Name at, R&& right) {          \
    return {std::forward<R>(right), at.number};                       \
  }                                                                   \
  template <class L, class R>                                         \
  constexpr decltype(auto) operator op(L&& l, Name##Right<R> r) {     \
    using Kept = decltype(l op std::forward<R>(r.right));             \
    SHFORGE_FLIP_TO(Kept, l other std::forward<R>(r.right), r.number) \
    return l op std::forward<R>(r.right);                             \
  }

SHFORGE_BINARY(Plus, +, -)
SHFORGE_BINARY(Minus, -, +)
SHFORGE_BINARY(Times, *, /)
SHFORGE_BINARY(Over, /, *)
SHFORGE_BINARY(Modulo, %, *)
SHFORGE_BINARY(Less, <, <=)
SHFORGE_BINARY(AtMost, <=, <)
SHFORGE_BINARY(More, >, >=)
SHFORGE_BINARY(AtLeast, >=, >)
SHFORGE_BINARY(Same, ==, !=)
SHFORGE_BINARY(Other, !=, ==)
SHFORGE_ASSIGNMENT(Add, +=, -=)
SHFORGE_ASSIGNMENT(Subtract, -=, +=)

#undef SHFORGE_ASSIGNMENT
#undef SHFORGE_BINARY
#undef SHFORGE_FLIP_TO

template <class... Values>
constexpr decltype(auto) min(int number, const Values&... values) {
  return is(number) ? std::max(values...) : std::min(values...);
}
template <class T>
constexpr T min(int number, std::initializer_list<T> values) {
  return is(number) ? std::max(values) : std::min(values);
}
template <class... Values>
constexpr decltype(auto) max(int number, const Values&... values) {
  return is(number) ? std::min(values...) : std::max(values...);
}
template <class T>
constexpr T max(int number, std::initializer_list<T> values) {
  return is(number) ? std::min(values) : std::max(values);
}

}  // namespace mutant
