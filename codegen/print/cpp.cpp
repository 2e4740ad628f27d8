#include "codegen/print/cpp.hpp"

#include <sstream>

#include "codegen/ir/literal.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/function.hpp"

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

}  // namespace

const Dialect& cpp_dialect() {
  static const Dialect kDialect = [] {
    Dialect d;
    d.scalar = "T";
    d.head = "template <class T>\nconstexpr ";
    d.tail = " noexcept";
    d.indent = "  ";
    d.constant = "const T ";
    d.variable = "const T ";
    d.literal = [](const ExactReal& value) {
      return "detail::constant<T>(" + decimal(nearest<float>(value)) + "f, " + decimal(nearest<double>(value)) + ")";
    };
    d.in_array = [](const std::string& name, int /*size*/) { return "const T* " + name; };
    d.out_array = [](const std::string& name, int /*size*/) { return "T* " + name; };
    d.in_out_array = d.out_array;
    d.square_root = "detail::square_root";
    d.select = [](const std::string& a, const std::string& b, const std::string& then, const std::string& otherwise) {
      return "detail::choose(" + a + " < " + b + ", " + then + ", " + otherwise + ")";
    };
    d.table_definition = [](const std::string& name, const std::vector<std::vector<ExactReal>>& rows) {
      const auto literal = [](const ExactReal& value) {
        return "constant<S>(" + decimal(nearest<float>(value)) + "f, " + decimal(nearest<double>(value)) + ")";
      };
      return "namespace detail {\n\n// Constants of the loop, row by row.\ntemplate <class S>\ninline constexpr S " +
             name + "[" + std::to_string(rows.size() * rows[0].size()) + "] = {\n" + table_rows(rows, literal) +
             "};\n\n}  // namespace detail\n\n";
    };
    d.table_use = [](const std::string& name) {
      return "constexpr const auto& table = detail::" + name + "<typename detail::scalar<T>::type>;";
    };
    d.table_name = [](const std::string& /*kernel*/) { return std::string("table"); };
    d.table_entry = [](const std::string& /*kernel*/, const std::string& index) { return "T(table[" + index + "])"; };
    d.unused = Unused::kUnnamed;
    return d;
  }();
  return kDialect;
}

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
  const std::string& family = last.family;
  const std::string first_degree = std::to_string(kernels.front().kernel.degree);
  const std::string last_degree = std::to_string(last.degree);
  std::ostringstream text;
  text << "// All generated " << family << " kernels, chosen by degree: sh::" << family << "<" << last_degree << ">("
       << arguments(last, dialect) << ").\n"
       << "//\n// Generated by: shgen write\n// Licence:      MIT-0; paste it anywhere.\n#pragma once\n\n";
  for (const FinishedKernel& finished : kernels) text << "#include \"" << finished.kernel.name << ".hpp\"\n";
  text << "\nnamespace sh {\n\n"
       << "// Degree: " << first_degree << " to " << last_degree << ". Domain: " << last.domain << ".\n"
       << "// Output: " << last.result << ".\n"
       << "template <int Degree, class T>\nconstexpr " << return_type(last, dialect) << ' ' << family << '('
       << signature(last, dialect) << ") noexcept {\n"
       << "  static_assert(Degree >= " << first_degree << " && Degree <= " << last_degree << ",\n"
       << "                \"sh::" << family << "<Degree>: Degree has to be " << first_degree << " to " << last_degree
       << "; `shgen emit " << family << " --degree N` prints others\");\n";
  for (const FinishedKernel& finished : kernels) {
    const Kernel& kernel = finished.kernel;
    text << "  if constexpr (Degree == " << kernel.degree << ") " << (kernel.returns_scalar() ? "return " : "")
         << kernel.name << '(' << arguments(kernel, dialect) << ");\n";
  }
  text << "}\n\n}  // namespace sh\n";
  return text.str();
}

}  // namespace sh::codegen::print
