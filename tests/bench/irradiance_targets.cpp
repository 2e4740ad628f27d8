// Irradiance from few numbers: error against time. Degree 1 as it is, with a suggested band 2 (ZH3), Hazel's positive
// form of degree 1, and degree 2, under skies and sets of lights whose irradiance is known exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

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

}  // namespace

void irradiance(Table& table) {
  table.section("Irradiance from few numbers, float",
                "rms and largest error in the mean irradiance of all normals; time of a channel at a normal");
  const std::vector<Light> lights{{"sky", {numeric::overcast_point_lights(0.2, 0)}},
                                  {"sky, a fifth from the sun", {numeric::overcast_point_lights(0.2, 0.2)}},
                                  {"sky, half from the sun", {numeric::overcast_point_lights(0.2, 0.5)}},
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
  table.ratio("degree 1, ZH3", "ns", t[2] * ns, t[3] * ns, "degree 2", 1.5);
  table.ratio("degree 1, ZH3", "ns", t[2] * ns, t[1] * ns, "Hazel", 1.0);
  table.remark("  degree 1 takes " + std::to_string(t[0] * ns) + " ns");
}

}  // namespace sh::bench
