// The tables of numeric/methods as methods of the report: algorithms of others and of the oracle, in float and double.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <span>

#include "numeric/kernels/inputs.hpp"
#include "numeric/methods/methods.hpp"
#include "numeric/oracle/legendre_rings.hpp"
#include "numeric/report/method.hpp"
#include "numeric/report/tasks.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {
namespace {

// z = cos and sine of colatitudes to all P_lm, 0 <= m <= l <= degree.
std::vector<NamedInput> colatitudes() {
  std::vector<NamedInput> all = {{"pole", {1, 0}}, {"equator", {0, 1}}, {"other pole", {-1, 0}}};
  for (const double sine : {1e-300, 1e-20, 1e-8, 1e-4, 0.01}) {
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    all.push_back({"beside the pole", {cosine, sine}});
    all.push_back({"beside the equator", {sine, cosine}});
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

// Every method of a table; call(run, in, out) passes flat inputs on.
template <class T, class Row, class Call>
void add_table(std::vector<Method>& all, const MethodInfo& shared, const std::string& table,
               const std::string& arguments, const FamilyCheck& check, std::span<const Row> rows, Call call) {
  for (const Row& row : rows) {
    MethodInfo info = shared;
    info.name = row.name;
    info.source = row.source;
    info.header = "numeric/methods/methods.hpp";
    info.call = fmt::format("sh::numeric::{}_methods<T>(), {}: run({}, {})", table, row.name, info.degree, arguments);
    all.push_back(method_of(
        info, check, code_of<T>([run = row.run, call](const T* in, T* out) { call(run, in, out); }, info.degree)));
  }
}

template <class T>
void add_tables(std::vector<Method>& all, const std::string& task, int degree) {
  MethodInfo info = {.task = task, .name = {}, .degree = degree};
  if (task == "legendre") {
    add_table<T>(all, info, task, "z, sine, out", legendre_check(), legendre_methods<T>(),
                 [degree](auto run, const T* in, T* out) { run(degree, in[0], in[1], out); });
  } else if (task == "rotate") {
    info.leaves_out = "takes r for a rotation";
    add_table<T>(all, info, "rotation", "r, c, out", task_check(task), rotation_methods<T>(),
                 [degree](auto run, const T* in, T* out) { run(degree, in, in + 9, out); });
  } else if (task == "cap") {
    add_table<T>(all, info, "zonal", "one_minus_cos, out", task_check(task), zonal_methods<T>(),
                 [degree](auto run, const T* in, T* out) { run(degree, in[0], out); });
  }
}

// The Legendre functions of rings, from sums in which one coefficient is 1: two degrees a transform.
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
    for (int k = 0; k < count; k += 2) {
      const bool both = k + 1 < count;
      std::vector<double> coefficients(2 * count);
      coefficients[2 * k] = 1;
      if (both) coefficients[2 * k + 3] = 1;
      rings.synthesis(degree, m, coefficients, values);
      for (std::size_t i = 0; i < z.size(); ++i) {
        double* const P = out + i * legendre_count(degree);
        P[legendre_index(m + k, m)] = values[2 * i];
        if (both) P[legendre_index(m + k + 1, m)] = values[2 * i + 1];
      }
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
  const std::vector<double> coefficients(2 * (degree + 1), 1.0);
  std::vector<double> values(2 * z.size());
  std::vector<std::function<void()>> calls = {[&] {
    for (int m = 0; m <= degree; ++m) {
      rings.synthesis(degree, m, std::span(coefficients).first(2 * (degree - m + 1)), values);
    }
  }};
  return least_nanoseconds(calls, budget) / kRings;
}

Method rings_method(int degree) {
  const MethodInfo info = {
      .task = "legendre",
      .name = "rings (SIMD)",
      .degree = degree,
      .mode = Mode::kBatch,
      .header = "numeric/oracle/legendre_rings.hpp",
      .call = fmt::format("sh::numeric::LegendreRings({}, z, sine).synthesis(l, m, coefficients, values)", degree),
      .leaves_out = "sums over l instead of storing the values; a time a ring of 256, all orders",
      .source = "Ishioka 2018, lanes across rings"};
  const Code<double> code = {
      [degree](const Samples<double>& samples, double* out) { run_rings(degree, samples, out); },
      [degree](const auto& /*samples*/, std::chrono::nanoseconds budget) { return time_rings(degree, budget); }};
  return method_of(info, legendre_check(), code);
}

}  // namespace

void add_table_methods(std::vector<Method>& all, const std::string& task, int degree) {
  add_tables<float>(all, task, degree);
  add_tables<double>(all, task, degree);
  if (task == "legendre") all.push_back(rings_method(degree));
}

}  // namespace sh::numeric
