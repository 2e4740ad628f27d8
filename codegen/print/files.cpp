#include "codegen/print/files.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "codegen/passes/passes.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen::print {
namespace {

// Every file carries this, guarded, so that each compiles alone and all compile together.
constexpr const char* kConstantTrait = R"(#ifndef SH_GENERATED_CONSTANT
#define SH_GENERATED_CONSTANT
namespace sh::detail {

// The scalar in T: T itself, or T::value_type for a lane type such as std::experimental::simd<float>.
template <class T, class = void>
struct scalar {
  using type = T;
};
template <class T>
struct scalar<T, std::void_t<typename T::value_type>> {
  using type = typename T::value_type;
};

// A constant in the scalar of T; both candidates are correctly rounded from the exact value.
template <class T>
constexpr T constant([[maybe_unused]] float in_float, [[maybe_unused]] double in_double) noexcept {
  using S = typename scalar<T>::type;
  static_assert(std::is_same<S, float>::value || std::is_same<S, double>::value,
                "sh: generated constants are correctly rounded for float and double (or lanes of them) only");
  if constexpr (std::is_same<S, float>::value) {
    return T(in_float);
  } else {
    return T(in_double);
  }
}

}  // namespace sh::detail
#endif
)";

// Square roots and selections for scalars and for lane types (std::sqrt or a sqrt and select found by their type).
constexpr const char* kMathTrait = R"(
#ifndef SH_GENERATED_MATH
#define SH_GENERATED_MATH
namespace sh::detail {

template <class T>
T square_root(const T& x) noexcept {
  using std::sqrt;
  return sqrt(x);
}

// condition ? then : otherwise, lane by lane where T has lanes.
template <class Condition, class T>
constexpr T choose(const Condition& condition, const T& then, const T& otherwise) noexcept {
  if constexpr (std::is_same<Condition, bool>::value) {
    return condition ? then : otherwise;
  } else {
    return select(condition, then, otherwise);
  }
}

}  // namespace sh::detail
#endif
)";

// The comment at the head; language: as in `shgen emit --lang`.
std::string head(const FinishedKernel& finished, const std::string& language, Scalar scalar, const Dialect& dialect) {
  return comment_block(describe(finished, language + scalar_option(scalar), dialect));
}

std::string guard(const std::string& name) {
  std::string text = "SH_";
  for (const char c : name) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text + "_H";
}

// Compilers of shaders take many times as long over a loop in which the index of an array moves on.
Kernel for_shaders(const Kernel& kernel) {
  const bool moves = std::any_of(kernel.nodes.begin(), kernel.nodes.end(), [](const Node& n) { return n.stride != 0; });
  return moves ? passes::share(passes::unroll(kernel)) : kernel;
}

}  // namespace

std::string cpp_prelude() { return std::string(kConstantTrait) + kMathTrait; }

std::string cpp_kernel(const FinishedKernel& finished, Scalar /*scalar*/) {
  const bool needs_math = finished.cost.sqrt + finished.cost.select > 0;
  return comment_block(describe(finished, "cpp", cpp_dialect())) + "#pragma once\n\n" +
         (needs_math ? "#include <cmath>\n" : "") + "#include <type_traits>\n\n" + kConstantTrait +
         (needs_math ? kMathTrait : "") + "\nnamespace sh {\n\n" + function(finished.kernel, cpp_dialect()) +
         "\n}  // namespace sh\n";
}

std::string cpp_family(const std::vector<FinishedKernel>& kernels) {
  const Kernel& last = kernels.back().kernel;
  const Dialect& dialect = cpp_dialect();
  std::string includes;
  std::string choices;
  for (const FinishedKernel& finished : kernels) {
    const Kernel& kernel = finished.kernel;
    includes += "#include \"" + kernel.name + ".hpp\"\n";
    choices += filled("  if constexpr (Degree == $degree) $return$name($arguments);\n",
                      {{"degree", std::to_string(kernel.degree)},
                       {"return", kernel.returns_scalar() ? "return " : ""},
                       {"name", kernel.name},
                       {"arguments", arguments(kernel, dialect)}});
  }
  return filled(R"(// All generated $family kernels, chosen by degree: sh::$family<$last>($arguments).
//
$stamp#pragma once

$includes
namespace sh {

// Degree: $first to $last. Domain: $domain.
// Output: $result.
template <int Degree, class T$shared>
constexpr $type $family($signature) noexcept {
  static_assert(Degree >= $first && Degree <= $last,
                "sh::$family<Degree>: Degree has to be $first to $last; `shgen emit $family --degree N` prints others");
$choices}

}  // namespace sh
)",
                {{"family", last.family},
                 {"first", std::to_string(kernels.front().kernel.degree)},
                 {"last", std::to_string(last.degree)},
                 {"arguments", arguments(last, dialect)},
                 {"stamp", kStamp},
                 {"includes", includes},
                 {"domain", last.domain},
                 {"result", last.result},
                 {"shared", takes_shared(last) ? ", class S = T" : ""},
                 {"type", return_type(last, dialect)},
                 {"signature", signature(last, dialect)},
                 {"choices", choices}});
}

std::string glsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = glsl_dialect(scalar);
  const std::string version = scalar == Scalar::kFloat
                                  ? "// GLSL 4.50 and GLSL ES 3.00; put it below your #version line.\n"
                                    "#ifdef GL_ES\nprecision highp float;\n#endif\n\n"
                                  : "// GLSL 4.50; put it below your #version line.\n\n";
  return head(finished, "glsl", scalar, d) + version + function(for_shaders(finished.kernel), d);
}

std::string glsl_es_kernel(const FinishedKernel& finished, Scalar scalar) {
  if (scalar == Scalar::kDouble)
    throw std::invalid_argument("language glsl-es: expected scalar float, got double; GLSL ES has no double");
  const Dialect d = glsl_dialect(scalar);
  return head(finished, "glsl-es", scalar, d) +
         "// GLSL ES 3.00; put it below your #version line.\nprecision highp float;\n\n" +
         function(for_shaders(finished.kernel), d);
}

std::string hlsl_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = hlsl_dialect(scalar);
  return head(finished, "hlsl", scalar, d) + "// HLSL, shader model 5.0.\n\n" +
         function(for_shaders(finished.kernel), d);
}

std::string c99_kernel(const FinishedKernel& finished, Scalar scalar) {
  const Dialect d = c99_dialect(scalar);
  Kernel kernel = finished.kernel;
  if (scalar == Scalar::kDouble) kernel.name += "_double";
  return head(finished, "c99", scalar, d) + "#ifndef " + guard(kernel.name) + "\n#define " + guard(kernel.name) +
         "\n\n" + (finished.cost.sqrt > 0 ? "#include <math.h>\n\n" : "") + function(kernel, d) + "\n#endif\n";
}

}  // namespace sh::codegen::print
