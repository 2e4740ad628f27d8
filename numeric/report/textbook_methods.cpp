// What is usually pasted into an engine, as methods: the textbook's basis, Sloan's recurrences, the classic rotation,
// and what one writes with a basis at hand: sums over it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "numeric/methods/classic_rotation.hpp"
#include "numeric/methods/sloan_basis.hpp"
#include "numeric/methods/textbook_basis.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/gaunt.hpp"
#include "numeric/report/code.hpp"
#include "numeric/report/methods.hpp"
#include "numeric/report/task_checks.hpp"

namespace sh::numeric {
namespace {

constexpr int kHighest = 10;

template <class T>
using Basis = void (*)(T x, T y, T z, T* out);
template <class T>
using Rotation = void (*)(const T* r, const T* c, T* out);

template <class T, int... Degree>
std::array<Basis<T>, sizeof...(Degree)> sloan_by_degree(std::integer_sequence<int, Degree...> /*degrees*/) {
  return {&textbook::sloan_basis<Degree, T>...};
}
template <class T, int... Degree>
std::array<Rotation<T>, sizeof...(Degree)> classic_by_degree(std::integer_sequence<int, Degree...> /*degrees*/) {
  return {&textbook::classic_rotation<Degree, T>...};
}
using Degrees = std::make_integer_sequence<int, kHighest + 1>;

MethodInfo info_of(const std::string& task, const char* name, int degree, const char* header, const char* call,
                   const char* leaves_out, const char* source) {
  return {.task = task,
          .name = name,
          .degree = degree,
          .scalar = {},
          .mode = Mode::kOne,
          .header = std::string("numeric/") + header,
          .call = call,
          .leaves_out = leaves_out,
          .source = source};
}

template <class T>
void add_sums_over_basis(std::vector<Method>& all, const std::string& task, int degree, Basis<T> sloan) {
  constexpr const char* kSloan = "Sloan 2013, Efficient Spherical Harmonic Evaluation";
  const int count = coefficient_count(degree);
  const auto add = [&](const char* call, FlatFunction<T> function) {
    all.push_back(method_of(info_of(task, "Sloan's basis, summed", degree, "methods/sloan_basis.hpp", call,
                                    "takes |d| = 1 for granted", kSloan),
                            task_check(task), code_of<T>(std::move(function), degree)));
  };
  std::vector<T> values(count);
  if (task == "evaluate") {
    add("sum of c[i] * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)",
        [sloan, count, values](const T* in, T* out) mutable {
          sloan(in[count], in[count + 1], in[count + 2], values.data());
          *out = 0;
          for (int i = 0; i < count; ++i) *out += in[i] * values[i];
        });
  } else if (task == "project") {
    add("sum[i] += weight * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)",
        [sloan, count, values](const T* in, T* out) mutable {
          sloan(in[0], in[1], in[2], values.data());
          for (int i = 0; i < count; ++i) out[i] = in[4 + i] + in[3] * values[i];
        });
  } else if (task == "zonal") {
    add("zonal[l] * sqrt(4 pi / (2l+1)) * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)",
        [sloan, degree](const T* in, T* out) {
          sloan(in[degree + 1], in[degree + 2], in[degree + 3], out);
          for (int l = 0; l <= degree; ++l) {
            const auto factor = in[l] * std::sqrt(4 * std::numbers::pi_v<T> / static_cast<T>(2 * l + 1));
            for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
          }
        });
  }
}

// Every non-zero integral of Y_i Y_j Y_k, i <= j.
template <class T>
struct GauntEntry {
  std::size_t i, j, k;
  T value;
};

std::array<int, 2> degree_and_order(std::size_t index) {
  const auto l = static_cast<int>(std::sqrt(static_cast<double>(index)));
  return {l, static_cast<int>(index) - l * (l + 1)};
}

template <class T>
std::vector<GauntEntry<T>> gaunt_entries(int degree) {
  std::vector<GauntEntry<T>> entries;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      for (std::size_t k = 0; k < count; ++k) {
        const auto [l1, m1] = degree_and_order(i);
        const auto [l2, m2] = degree_and_order(j);
        const auto [l3, m3] = degree_and_order(k);
        if ((l1 + l2 + l3) % 2 != 0 || l3 > l1 + l2 || l2 > l1 + l3) continue;
        const double value = gaunt<double>({l1, l2, l3}, {m1, m2, m3});
        if (value != 0) entries.push_back({i, j, k, static_cast<T>(value)});
      }
    }
  }
  return entries;
}

template <class T>
void add_gaunt_sum(std::vector<Method>& all, int degree) {
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  const auto run = [count, entries = gaunt_entries<T>(degree)](const T* in, T* out) {
    const T* const a = in;
    const T* const b = in + count;
    std::fill_n(out, count, T(0));
    for (const auto& e : entries)
      out[e.k] += e.value * (e.i == e.j ? a[e.i] * b[e.i] : a[e.i] * b[e.j] + a[e.j] * b[e.i]);
  };
  all.push_back(
      method_of(info_of("product", "table of Gaunt coefficients", degree, "oracle/gaunt.hpp",
                        "sum of sh::numeric::gaunt(i, j, k) a[i] b[j] over what is not zero", "", "the definition"),
                task_check("product"), code_of<T>(run, degree)));
}

template <class T>
void add_textbook(std::vector<Method>& all, const std::string& task, int degree) {
  static const auto kSloan = sloan_by_degree<T>(Degrees{});
  static const auto kClassic = classic_by_degree<T>(Degrees{});
  const Basis<T> sloan = kSloan[degree];
  const Rotation<T> classic = kClassic[degree];
  if (task == "basis") {
    all.push_back(method_of(info_of(task, "Sloan's recurrence", degree, "methods/sloan_basis.hpp",
                                    "sh::textbook::sloan_basis<L>(x, y, z, out)", "takes |d| = 1 for granted",
                                    "Sloan 2013, Efficient Spherical Harmonic Evaluation"),
                            task_check(task),
                            code_of<T>([sloan](const T* in, T* out) { sloan(in[0], in[1], in[2], out); }, degree)));
    all.push_back(method_of(
        info_of(task, "textbook", degree, "methods/textbook_basis.hpp", "sh::textbook::textbook_basis(L, x, y, z, out)",
                "double inside, angles, factorials", "Green 2003, Spherical Harmonic Lighting: The Gritty Details"),
        task_check(task),
        code_of<T>([degree](const T* in, T* out) { textbook::textbook_basis(degree, in[0], in[1], in[2], out); },
                   degree)));
  } else if (task == "rotate") {
    all.push_back(method_of(
        info_of(task, "classic z-x90-z", degree, "methods/classic_rotation.hpp",
                "sh::textbook::classic_rotation<L>(r, c, out)", "takes r for a rotation; loses digits at small tilts",
                "Kautz, Snyder and Sloan 2002; Green 2003"),
        task_check(task), code_of<T>([classic](const T* in, T* out) { classic(in, in + 9, out); }, degree)));
  }
  constexpr int kHighestTable = 6;
  if (task == "product" && degree <= kHighestTable) add_gaunt_sum<T>(all, degree);
  add_sums_over_basis<T>(all, task, degree, sloan);
}

}  // namespace

void add_textbook_methods(std::vector<Method>& all, const std::string& task, int degree) {
  if (degree > kHighest) return;
  add_textbook<float>(all, task, degree);
  add_textbook<double>(all, task, degree);
}

}  // namespace sh::numeric
