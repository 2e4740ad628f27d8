// What programmers usually paste into an engine, as methods: the textbook's basis, Sloan's recurrences, the classic
// rotation; and sums over a basis, which one writes with a basis at hand.
#include <cmath>
#include <numbers>

#include "numeric/methods/classic_rotation.hpp"
#include "numeric/methods/sloan_basis.hpp"
#include "numeric/methods/textbook_basis.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/gaunt.hpp"
#include "numeric/report/method.hpp"
#include "numeric/report/tasks.hpp"

namespace sh::numeric {
namespace {

constexpr int kHighest = 10;
constexpr int kHighestTable = 6;

template <class T>
using Basis = void (*)(T x, T y, T z, T* out);
template <class T>
using Rotation = void (*)(const T* r, const T* c, T* out);

template <class T, int... Degree>
Basis<T> sloan_basis(int degree, std::integer_sequence<int, Degree...> /*degrees*/) {
  static constexpr Basis<T> kFunctions[] = {&textbook::sloan_basis<Degree, T>...};
  return kFunctions[degree];
}
template <class T, int... Degree>
Rotation<T> classic_rotation(int degree, std::integer_sequence<int, Degree...> /*degrees*/) {
  static constexpr Rotation<T> kFunctions[] = {&textbook::classic_rotation<Degree, T>...};
  return kFunctions[degree];
}
using Degrees = std::make_integer_sequence<int, kHighest + 1>;

// Every non-zero integral of Y_i Y_j Y_k, i <= j.
template <class T>
struct GauntEntry {
  int i, j, k;
  T value;
};

template <class T>
std::vector<GauntEntry<T>> gaunt_entries(int degree) {
  std::vector<GauntEntry<T>> entries;
  const auto degree_of = [](int index) { return static_cast<int>(std::sqrt(index)); };
  const auto order_of = [&](int index) { return index - coefficient_index(degree_of(index), 0); };
  const int count = coefficient_count(degree);
  for (int i = 0; i < count; ++i) {
    for (int j = i; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        const Triple l = {degree_of(i), degree_of(j), degree_of(k)};
        if ((l[0] + l[1] + l[2]) % 2 != 0 || l[2] > l[0] + l[1] || l[1] > l[0] + l[2]) continue;
        const auto value = gaunt<double>(l, {order_of(i), order_of(j), order_of(k)});
        if (value != 0) entries.push_back({i, j, k, static_cast<T>(value)});
      }
    }
  }
  return entries;
}

template <class T>
FlatFunction<T> gaunt_sum(int degree) {
  const int count = coefficient_count(degree);
  return [count, entries = gaunt_entries<T>(degree)](const T* in, T* out) {
    const T* const a = in;
    const T* const b = in + count;
    std::fill_n(out, count, T(0));
    for (const auto& e : entries) {
      out[e.k] += e.value * (e.i == e.j ? a[e.i] * b[e.i] : a[e.i] * b[e.j] + a[e.j] * b[e.i]);
    }
  };
}

template <class T>
FlatFunction<T> evaluation(Basis<T> sloan, int degree) {
  return [=, values = std::vector<T>(coefficient_count(degree))](const T* in, T* out) mutable {
    const T* const d = in + values.size();
    sloan(d[0], d[1], d[2], values.data());
    *out = 0;
    for (std::size_t i = 0; i < values.size(); ++i) *out += in[i] * values[i];
  };
}

template <class T>
FlatFunction<T> projection(Basis<T> sloan, int degree) {
  return [=, values = std::vector<T>(coefficient_count(degree))](const T* in, T* out) mutable {
    sloan(in[0], in[1], in[2], values.data());
    for (std::size_t i = 0; i < values.size(); ++i) out[i] = in[4 + i] + in[3] * values[i];
  };
}

template <class T>
FlatFunction<T> turned_zonal(Basis<T> sloan, int degree) {
  return [=](const T* in, T* out) {
    sloan(in[degree + 1], in[degree + 2], in[degree + 3], out);
    for (int l = 0; l <= degree; ++l) {
      const auto factor = in[l] * std::sqrt(4 * std::numbers::pi_v<T> / static_cast<T>(2 * l + 1));
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
    }
  };
}

template <class T>
void add_textbook(std::vector<Method>& all, const std::string& task, int degree) {
  constexpr const char* kSloan = "Sloan 2013, Efficient Spherical Harmonic Evaluation";
  constexpr const char* kUnit = "takes |d| = 1 for granted";
  const Basis<T> sloan = sloan_basis<T>(degree, Degrees{});
  const auto add = [&](const char* name, const char* header, const char* call, const char* leaves_out,
                       const char* source, const FlatFunction<T>& function) {
    const MethodInfo info = {.task = task,
                             .name = name,
                             .degree = degree,
                             .header = std::string("numeric/") + header,
                             .call = call,
                             .leaves_out = leaves_out,
                             .source = source};
    all.push_back(method_of(info, task_check(task), code_of<T>(function, degree)));
  };
  const auto add_sum = [&](const char* call, const FlatFunction<T>& function) {
    add("Sloan's basis, summed", "methods/sloan_basis.hpp", call, kUnit, kSloan, function);
  };
  if (task == "basis") {
    add("Sloan's recurrence", "methods/sloan_basis.hpp", "sh::textbook::sloan_basis<L>(x, y, z, out)", kUnit, kSloan,
        [sloan](const T* in, T* out) { sloan(in[0], in[1], in[2], out); });
    add("textbook", "methods/textbook_basis.hpp", "sh::textbook::textbook_basis(L, x, y, z, out)",
        "double inside, angles, factorials", "Green 2003, Spherical Harmonic Lighting: The Gritty Details",
        [degree](const T* in, T* out) { textbook::textbook_basis(degree, in[0], in[1], in[2], out); });
  } else if (task == "rotate") {
    add("classic z-x90-z", "methods/classic_rotation.hpp", "sh::textbook::classic_rotation<L>(r, c, out)",
        "takes r for a rotation; loses digits at small tilts", "Kautz, Snyder and Sloan 2002; Green 2003",
        [rotate = classic_rotation<T>(degree, Degrees{})](const T* in, T* out) { rotate(in, in + 9, out); });
  } else if (task == "product" && degree <= kHighestTable) {
    add("table of Gaunt coefficients", "oracle/gaunt.hpp",
        "sum of sh::numeric::gaunt(i, j, k) a[i] b[j] over what is not zero", "", "the definition",
        gaunt_sum<T>(degree));
  } else if (task == "evaluate") {
    add_sum("sum of c[i] * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)", evaluation(sloan, degree));
  } else if (task == "project") {
    add_sum("sum[i] += weight * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)", projection(sloan, degree));
  } else if (task == "zonal") {
    add_sum("zonal[l] * sqrt(4 pi / (2l+1)) * out[i] of sh::textbook::sloan_basis<L>(x, y, z, out)",
            turned_zonal(sloan, degree));
  }
}

}  // namespace

void add_textbook_methods(std::vector<Method>& all, const std::string& task, int degree) {
  if (degree > kHighest) return;
  add_textbook<float>(all, task, degree);
  add_textbook<double>(all, task, degree);
}

}  // namespace sh::numeric
