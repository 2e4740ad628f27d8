// The tables of numeric/methods as methods: what others use, and the oracle's own algorithms, in float and double.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "numeric/kernels/inputs.hpp"
#include "numeric/methods/legendre_methods.hpp"
#include "numeric/methods/rotation_methods.hpp"
#include "numeric/methods/zonal_methods.hpp"
#include "numeric/oracle/legendre_rings.hpp"
#include "numeric/report/code.hpp"
#include "numeric/report/methods.hpp"
#include "numeric/report/task_checks.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {
namespace {

// z = cos and sine of colatitudes to all P_lm, 0 <= m <= l <= degree.
std::vector<NamedInput> colatitudes() {
  std::vector<NamedInput> all = {{"pole", {1, 0}}, {"equator", {0, 1}}, {"other pole", {-1, 0}}};
  for (const double sine : {1e-300, 1e-20, 1e-8, 1e-4, 0.01}) {
    all.push_back({"beside the pole", {std::sqrt((1 - sine) * (1 + sine)), sine}});
    all.push_back({"beside the equator", {sine, std::sqrt((1 - sine) * (1 + sine))}});
  }
  constexpr int kEven = 8;
  for (int i = 1; i < 2 * kEven; i += 2) {
    const double angle = std::numbers::pi * i / (2 * kEven);
    all.push_back({"colatitude " + std::to_string(180. * i / (2 * kEven)).substr(0, 5) + " degrees",
                   {std::cos(angle), std::sin(angle)}});
  }
  return all;
}

int degree_of_legendre(std::size_t index) {
  return static_cast<int>((std::sqrt(8 * static_cast<double>(index) + 1) - 1) / 2);
}

FamilyCheck legendre_check() {
  return {
      .family = "legendre",
      .signature =
          [](int degree) {
            return Signature{{scalar("z"), scalar("sine"), out_array("P", static_cast<int>(legendre_count(degree)))}};
          },
      .inputs = [](int /*degree*/) { return colatitudes(); },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            using Real = std::remove_cvref_t<decltype(*in)>;
            std::vector<Mpfr50> exact(legendre_count(degree));
            legendre_methods<Mpfr50>().back().run(degree, Mpfr50(in[0]), Mpfr50(in[1]), exact.data());
            for (std::size_t i = 0; i < exact.size(); ++i) out[i] = static_cast<Real>(exact[i]);
          },
      .nearest = [](int /*degree*/, const auto* in, auto* out) { scale_to_unit(2, in, out); },
      .size = [](int /*degree*/, const double* /*in*/,
                 std::size_t output) { return band_maximum(degree_of_legendre(output)); },
      .unit = "sqrt((2l+1)/4pi)"};
}

// A method of a table by its name, but "oracle" for the one that the oracle uses.
MethodInfo info_of(const std::string& task, const char* name, const char* source, int degree,
                   const std::string& arguments) {
  const std::string table = task == "cap" ? "zonal" : (task == "rotate" ? "rotation" : task);
  return {.task = task,
          .name = name,
          .degree = degree,
          .scalar = {},
          .mode = Mode::kOne,
          .header = "numeric/methods/" + table + "_methods.hpp",
          .call = "sh::numeric::" + table + "_methods<T>(), " + name + ": run(" + std::to_string(degree) + ", " +
                  arguments + ")",
          .leaves_out = task == "rotate" ? "takes r for a rotation" : "",
          .source = source};
}

template <class T>
void add_tables(std::vector<Method>& all, const std::string& task, int degree) {
  if (task == "legendre") {
    for (const auto& method : legendre_methods<T>()) {
      all.push_back(method_of(
          info_of(task, method.name, method.source, degree, "z, sine, out"), legendre_check(),
          code_of<T>([degree, run = method.run](const T* in, T* out) { run(degree, in[0], in[1], out); }, degree)));
    }
  } else if (task == "rotate") {
    for (const auto& method : rotation_methods<T>()) {
      all.push_back(method_of(
          info_of(task, method.name, method.source, degree, "r, c, out"), task_check("rotate"),
          code_of<T>([degree, run = method.run](const T* in, T* out) { run(degree, in, in + 9, out); }, degree)));
    }
  } else if (task == "cap") {
    for (const auto& method : zonal_methods<T>()) {
      all.push_back(
          method_of(info_of(task, method.name, method.source, degree, "one_minus_cos, out"), task_check("cap"),
                    code_of<T>([degree, run = method.run](const T* in, T* out) { run(degree, in[0], out); }, degree)));
    }
  }
}

// The Legendre functions of rings, from sums of which one coefficient is 1: two degrees a transform.
void run_rings(int degree, const Samples<double>& samples, double* out) {
  std::vector<double> z;
  std::vector<double> sine;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    z.push_back(samples.input(i)[0]);
    sine.push_back(samples.input(i)[1]);
  }
  const LegendreRings rings(degree, z, sine);
  std::vector<double> values(2 * z.size());
  for (int m = 0; m <= degree; ++m) {
    const int count = degree - m + 1;
    std::vector<double> coefficients(2 * static_cast<std::size_t>(count));
    for (int k = 0; k < count; k += 2) {
      const auto at = 2 * static_cast<std::size_t>(k);
      coefficients[at] = 1;
      if (k + 1 < count) coefficients[at + 3] = 1;
      rings.synthesis(degree, m, coefficients, values);
      for (std::size_t i = 0; i < z.size(); ++i) {
        double* const P = out + i * legendre_count(degree);
        P[legendre_index(m + k, m)] = values[2 * i];
        if (k + 1 < count) P[legendre_index(m + k + 1, m)] = values[2 * i + 1];
      }
      std::fill_n(coefficients.begin() + static_cast<std::ptrdiff_t>(at),
                  std::min<std::size_t>(4, coefficients.size() - at), 0.0);
    }
  }
}

// Nanoseconds a ring of sums at every order.
double time_rings(int degree, std::chrono::nanoseconds budget) {
  constexpr int kRings = 256;
  std::vector<double> z;
  std::vector<double> sine;
  for (int i = 0; i < kRings; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / kRings;
    z.push_back(std::cos(angle));
    sine.push_back(std::sin(angle));
  }
  const LegendreRings rings(degree, z, sine);
  const std::vector<double> coefficients(2 * (static_cast<std::size_t>(degree) + 1), 1.0);
  std::vector<double> values(2 * z.size());
  std::vector<std::function<void()>> calls = {[&] {
    for (int m = 0; m <= degree; ++m) {
      rings.synthesis(degree, m, std::span(coefficients).first(2 * static_cast<std::size_t>(degree - m + 1)), values);
    }
  }};
  return least_nanoseconds(calls, budget) / kRings;
}

void add_rings(std::vector<Method>& all, int degree) {
  const MethodInfo info = {.task = "legendre",
                           .name = "rings (SIMD)",
                           .degree = degree,
                           .scalar = {},
                           .mode = Mode::kBatch,
                           .header = "numeric/oracle/legendre_rings.hpp",
                           .call = "sh::numeric::LegendreRings(" + std::to_string(degree) +
                                   ", z, sine).synthesis(l, m, coefficients, values)",
                           .leaves_out = "sums over l instead of storing the values; a time a ring of 256, all orders",
                           .source = "Ishioka 2018, lanes across rings"};
  all.push_back(
      method_of(info, legendre_check(),
                Code<double>{[degree](const Samples<double>& samples, double* out) { run_rings(degree, samples, out); },
                             [degree](const Samples<double>& /*samples*/, std::chrono::nanoseconds budget) {
                               return time_rings(degree, budget);
                             }}));
}

}  // namespace

void add_table_methods(std::vector<Method>& all, const std::string& task, int degree) {
  add_tables<float>(all, task, degree);
  add_tables<double>(all, task, degree);
  if (task == "legendre") add_rings(all, degree);
}

}  // namespace sh::numeric
