// Irradiance from few numbers: error against time. Degree 1 as it is, with a suggested band 2 (ZH3), Hazel's positive
// form of degree 1, and degree 2, under skies and sets of lights whose irradiance is known exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "generated/cpp/evaluate_prepare.hpp"
#include "generated/cpp/evaluate_prepared.hpp"
#include "generated/cpp/irradiance.hpp"
#include "generated/cpp/irradiance_evaluate.hpp"
#include "generated/cpp/irradiance_zh3.hpp"
#include "generated/cpp/project.hpp"
#include "numeric/sampling/point_lights.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

using numeric::PointLights;
constexpr std::size_t kNine = coefficient_count(2);

// G. Hazel, "Reconstructing Diffuse Lighting from Spherical Harmonic Data", Geomerics 2015: never negative where
// |c_1| <= sqrt(3) c_00. Its power of a real exponent has no kernel: no language bounds its error.
float hazel(const float* c, float x, float y, float z) {
  const float mean = 0.28209479F * c[0];
  const std::array<float, 3> along{c[3], c[1], c[2]};
  const float size = std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
  if (!(mean > 0) || !(size > 0)) return 3.14159265F * std::max(0.0F, mean);
  const float quotient = std::min(size / (std::sqrt(3.0F) * c[0]), 1.0F);
  const float q = 0.5F * (1 + (along[0] * x + along[1] * y + along[2] * z) / size);
  const float p = 1 + 2 * quotient;
  const float a = (1 - quotient) / (1 + quotient);
  return 3.14159265F * mean * (a + (1 - a) * (p + 1) * std::pow(q, p));
}

struct Method {
  const char* name;
  float (*irradiance)(const float* c, float x, float y, float z);
};
constexpr std::array<Method, 4> kMethods{
    {{"degree 1", [](const float* c, float x, float y, float z) { return irradiance_evaluate<1>(c, x, y, z); }},
     {"degree 1, Hazel", hazel},
     {"degree 1, ZH3", [](const float* c, float x, float y, float z) { return irradiance_zh3<1>(c, x, y, z); }},
     {"degree 2", [](const float* c, float x, float y, float z) { return irradiance_evaluate<2>(c, x, y, z); }}}};

// The kinds of light, of power 1 each.
struct Light {
  const char* name;
  std::vector<PointLights> sets;
};

std::vector<PointLights> random_lights(int count) {
  std::vector<PointLights> sets;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) sets.push_back(numeric::random_point_lights(count, seed));
  return sets;
}

std::array<float, kNine> coefficients(const PointLights& light) {
  std::array<double, kNine> c{};
  for (const auto& node : light) sh::project<2>(node.x, node.y, node.z, node.weight, c.data());
  std::array<float, kNine> rounded;
  std::transform(c.begin(), c.end(), rounded.begin(), [](double value) { return static_cast<float>(value); });
  return rounded;
}

// Of all sets and normals, in the mean of the irradiance over all normals, which is a quarter of the power.
struct Error {
  double mean_square = 0;
  double largest = 0;
  bool is_negative = false;
};

Error error_of(const Method& method, const std::vector<PointLights>& sets, const PointLights& normals) {
  Error error;
  for (const PointLights& light : sets) {
    const std::array<float, kNine> c = coefficients(light);
    for (const auto& n : normals) {
      const double exact = numeric::irradiance(light, n);
      const double ours =
          method.irradiance(c.data(), static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z));
      const double difference = 4 * std::abs(ours - exact);
      error.mean_square += difference * difference / static_cast<double>(sets.size() * normals.size());
      error.largest = std::max(error.largest, difference);
      error.is_negative = error.is_negative || ours < -1e-6;
    }
  }
  return error;
}

// Degree 2 in RGB as engines pack it, seven vectors of four numbers: four for the constant and linear part of each channel
// and two products each, with the last product (x^2 - y^2) of all channels (P.-P. Sloan, "Stupid Spherical Harmonics (SH)
// Tricks", GDC 2008, appendix A10). T: float, or lanes of it.
struct Packed {
  std::array<std::array<float, 4>, 3> linear, quadratic;
  std::array<float, 3> last;
};

Packed packed(const float* c) {  // (3, 9), of radiance
  Packed p;
  const float k0 = 0.28209479F * 3.14159265F, k1 = 0.48860251F * 2.0943951F, k2 = 1.0925485F * 0.78539816F;
  for (std::size_t channel = 0; channel < 3; ++channel, c += kNine) {
    const float square = 0.31539157F * 0.78539816F * c[6];
    p.linear[channel] = {k1 * c[3], k1 * c[1], k1 * c[2], k0 * c[0] - square};
    p.quadratic[channel] = {k2 * c[4], k2 * c[5], 3 * square, k2 * c[7]};
    p.last[channel] = 0.54627422F * 0.78539816F * c[8];
  }
  return p;
}

template <class T>
[[gnu::always_inline]] inline void evaluate_packed(const Packed& p, T x, T y, T z, T* rgb) {
  const T xy = x * y, yz = y * z, zz = z * z, zx = z * x, difference = x * x - y * y;
  for (std::size_t i = 0; i < 3; ++i) {
    const T linear = T(p.linear[i][0]) * x + T(p.linear[i][1]) * y + T(p.linear[i][2]) * z + T(p.linear[i][3]);
    const T quadratic =
        T(p.quadratic[i][0]) * xy + T(p.quadratic[i][1]) * yz + T(p.quadratic[i][2]) * zz + T(p.quadratic[i][3]) * zx;
    rgb[i] = linear + quadratic + T(p.last[i]) * difference;
  }
}

// One light in RGB at many normals, one by one and in lanes.
template <class T, class Evaluate>
std::function<void()> at_normals(const float* normals, std::size_t n, float* out, const Evaluate& evaluate) {
  return [normals, n, out, evaluate] {
    constexpr std::size_t kBytes = sizeof(T);
    constexpr std::size_t kLanes = kBytes / sizeof(float);
    for (std::size_t i = 0; i < n / kLanes; ++i) {
      const T* const d = reinterpret_cast<const T*>(normals) + 3 * i;
      evaluate(d[0], d[1], d[2], reinterpret_cast<T*>(out) + 3 * i);
    }
    keep(*out);
  };
}

void degree_two(Table& table) {
  table.section("Irradiance of degree 2 in RGB, one light at many normals, ns a normal",
                "irradiance and evaluate_prepare once; control: the packed form of engines");
  constexpr std::size_t kCount = 1024;
  const std::vector<float> normals = random_directions(kCount);
  const Buffer<float> blocks = to_blocks(normals, 3);
  const std::vector<float> c = random_vectors(3, kNine);
  const Packed form = packed(c.data());
  const Buffer<float> out = make_buffer<float>(3 * kCount);
  std::array<float, 3 * kNine> prepared;  // irradiance, and its polynomial, once a light
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::array<float, kNine> own;
    std::copy_n(&c[channel * kNine], kNine, own.begin());
    sh::irradiance<2>(own.data());
    sh::evaluate_prepare<2>(own.data(), &prepared[channel * kNine]);
  }
  const auto ours = [&prepared](auto x, auto y, auto z, auto* rgb) {
    using T = decltype(x);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::array<T, kNine> own;
      for (std::size_t i = 0; i < kNine; ++i) own[i] = T(prepared[channel * kNine + i]);
      rgb[channel] = sh::evaluate_prepared<2>(own.data(), x, y, z);
    }
  };
  const auto theirs = [&form](auto x, auto y, auto z, auto* rgb) { evaluate_packed(form, x, y, z, rgb); };
  const std::vector<double> t = least_times({at_normals<float>(normals.data(), kCount, out.get(), ours),
                                             at_normals<float>(normals.data(), kCount, out.get(), theirs),
                                             at_normals<Sixteen>(blocks.get(), kCount, out.get(), ours),
                                             at_normals<Sixteen>(blocks.get(), kCount, out.get(), theirs)});
  const double ns = 1e9 / kCount;
  table.ratio("one by one", "ns", t[0] * ns, t[1] * ns, "packed", 0.9);
  table.ratio("in 16 lanes", "ns", t[2] * ns, t[3] * ns, "packed", 0.9);
}

}  // namespace

void irradiance(Table& table) {
  table.section("Irradiance from few numbers, float",
                "rms and largest error in the mean irradiance of all normals; time of a channel at a normal");
  const std::vector<Light> lights{{"CIE overcast sky over grey ground", {numeric::overcast_point_lights(0.2, 0)}},
                                  {"the same, a fifth from the sun", {numeric::overcast_point_lights(0.2, 0.2)}},
                                  {"the same, half from the sun", {numeric::overcast_point_lights(0.2, 0.5)}},
                                  {"50 lights", random_lights(50)},
                                  {"5 lights", random_lights(5)},
                                  {"one light", random_lights(1)}};
  const PointLights normals = numeric::fibonacci_nodes(2000);
  for (const Light& light : lights) {
    std::string line = std::string("  ") + light.name + ": ";
    for (const Method& method : kMethods) {
      const Error error = error_of(method, light.sets, normals);
      std::array<char, 96> text;
      std::snprintf(text.data(), text.size(), "%s %.1f %% (%.0f %%%s)%s", method.name,
                    100 * std::sqrt(error.mean_square), 100 * error.largest, error.is_negative ? ", negative" : "",
                    &method == &kMethods.back() ? "" : "; ");
      line += text.data();
      std::snprintf(text.data(), text.size(), "%.1f %% (%.0f %%)", 100 * std::sqrt(error.mean_square),
                    100 * error.largest);
      table.cell(light.name, method.name, text.data());
    }
    table.remark(line);
  }
  constexpr std::size_t kCount = 512;
  const std::vector<float> directions = random_directions(kCount);
  std::vector<float> vectors = random_vectors(kCount, kNine);
  for (std::size_t i = 0; i < vectors.size(); i += kNine) vectors[i] = 1;
  std::vector<std::function<void()>> tasks;
  for (const Method& method : kMethods) {
    tasks.emplace_back([&] {
      float sum = 0;
      for (std::size_t i = 0; i < kCount; ++i) {
        const float* const n = &directions[3 * i];
        sum += method.irradiance(&vectors[kNine * i], n[0], n[1], n[2]);
      }
      keep(sum);
    });
  }
  const std::vector<double> t = least_times(tasks);
  const double ns = 1e9 / kCount;
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.1f", t[i] * ns);
    table.cell("ns a channel and normal, scalar", kMethods[i].name, text.data());
  }
  table.ratio("degree 1, ZH3", "ns", t[2] * ns, t[3] * ns, "degree 2", 1.5);
  table.ratio("degree 1, ZH3", "ns", t[2] * ns, t[1] * ns, "Hazel", 1.0);
  table.remark("  degree 1 takes " + std::to_string(t[0] * ns) + " ns");
  degree_two(table);
}

}  // namespace sh::bench
