// See inputs.hpp. Angles are given by the tangents of their halves, since the last bits of library functions
// differ from machine to machine.
#include "numeric/kernels/inputs.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

// Random components in [-1, 1) scaled to length 1; the first `zeros` of them are 0.
NamedInput unit_vector(const std::string& name, int size, int zeros, Random& random) {
  NamedInput input{name, {}};
  for (int i = 0; i < size; ++i) input.values.push_back(i < zeros ? 0 : random.next());
  scale_to_unit(size, input.values.data(), input.values.data());
  return input;
}

constexpr std::array kTiny = {1e-300, 1e-100, 1e-40, 1e-37, 1e-30, 1e-20, 1e-16, 1e-15, 1e-14, 1e-12,
                              1e-10,  1e-9,   1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1};

std::string printed(double value) { return output::formatted("%.3g", value); }

struct CirclePoint {
  double cosine, sine;
};

CirclePoint random_circle_point(Random& random) {
  for (;;) {
    const double x = random.next();
    const double y = random.next();
    const double square = x * x + y * y;
    if (square > 1 || square < 0.01) continue;
    return {x / std::sqrt(square), y / std::sqrt(square)};
  }
}

NamedInput unit_quaternion(const std::string& name, double w, double x, double y, double z) {
  NamedInput input{name, {w, x, y, z}};
  scale_to_unit(4, input.values.data(), input.values.data());
  return input;
}

// A turn about z, a tilt whose half has the tangent `sine / cosine`, a turn about z.
NamedInput tilt(const std::string& name, double cosine, double sine, Random& random) {
  const auto sum = random_circle_point(random);  // half the sum of the two turns
  const auto difference = random_circle_point(random);
  return unit_quaternion(name, cosine * sum.cosine, sine * difference.sine, sine * difference.cosine,
                         cosine * sum.sine);
}

void add_named_turns(std::vector<NamedInput>& all) {
  all.push_back({"identity", {1, 0, 0, 0}});
  constexpr std::array<std::array<double, 3>, 3> kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const auto& [x, y, z] : kAxes) {
    const std::string axis = x == 1 ? "x" : (y == 1 ? "y" : "z");
    all.push_back(unit_quaternion("quarter turn about " + axis, 1, x, y, z));
    all.push_back(unit_quaternion("quarter turn back about " + axis, 1, -x, -y, -z));
    all.push_back(unit_quaternion("half turn about " + axis, 0, x, y, z));
    all.push_back(unit_quaternion("sixth turn about " + axis, std::numbers::sqrt3, x, y, z));
  }
  all.push_back({"third turn about (1,1,1)", {0.5, 0.5, 0.5, 0.5}});
  Random random(21);
  for (int i = 0; i < 6; ++i) {
    const auto axis = random_circle_point(random);
    all.push_back(unit_quaternion("half turn about a horizontal axis", 0, axis.cosine, axis.sine, 0));
  }
}

void add_small_turns(std::vector<NamedInput>& all) {
  const auto axes = random_directions(static_cast<int>(kTiny.size()), 22);
  for (std::size_t i = 0; i < kTiny.size(); ++i) {
    const auto& [x, y, z] = axes[i];
    const double t = kTiny[i] / 2;
    all.push_back(unit_quaternion("turn by " + printed(kTiny[i]), 1, t * x, t * y, t * z));
    all.push_back(unit_quaternion("turn by pi - " + printed(kTiny[i]), t, x, y, z));
  }
}

void add_tilts(std::vector<NamedInput>& all) {
  constexpr int kEach = 2;
  constexpr int kEven = 24;
  Random random(23);
  for (int i = 0; i < kEach; ++i) {
    for (const double angle : kTiny) {
      all.push_back(tilt("tilt by " + printed(angle), 1, angle / 2, random));
      all.push_back(tilt("tilt by pi - " + printed(angle), angle / 2, 1, random));
    }
    for (int k = 1; k < kEven; ++k) {
      const double t = static_cast<double>(k) / kEven;
      all.push_back(tilt("tilt " + std::to_string(k), 1 - t, t, random));
    }
  }
}

}  // namespace

std::vector<NamedInput> coefficient_inputs(int degree, int count, std::uint64_t seed) {
  std::vector<NamedInput> inputs;
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const bool band_only = i % 2 == 1;
    const std::string name = (band_only ? "band " : "vector ") + std::to_string(i);
    inputs.push_back(unit_vector(name, coefficient_count(degree), band_only ? degree * degree : 0, random));
  }
  return inputs;
}

std::vector<NamedInput> vector_inputs(int size, int count, std::uint64_t seed) {
  std::vector<NamedInput> inputs;
  inputs.reserve(count);
  Random random(seed);
  for (int i = 0; i < count; ++i) inputs.push_back(unit_vector("vector " + std::to_string(i), size, 0, random));
  return inputs;
}

std::vector<NamedInput> cap_inputs() {
  std::vector<NamedInput> inputs = {{"no cap", {0}}, {"hemisphere", {1}}, {"sphere", {2}}};
  for (const double u : {1e-300, 1e-100, 1e-40, 1e-36, 1e-30, 1e-20, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.1}) {
    inputs.push_back({"small cap", {u}});
    if (u > 1e-10) inputs.push_back({"all but a cap", {2 - u}});
  }
  Random random(11);
  constexpr int kRandomCaps = 100;
  for (int i = 0; i < kRandomCaps; ++i) inputs.push_back({"cap " + std::to_string(i), {1 + random.next()}});
  return inputs;
}

std::vector<NamedInput> combined(const std::vector<NamedInput>& first, const std::vector<NamedInput>& second) {
  std::vector<NamedInput> inputs;
  for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
    inputs.push_back(first[i % first.size()]);
    const auto& more = second[i % second.size()];
    inputs.back().name += ", " + more.name;
    inputs.back().values.insert(inputs.back().values.end(), more.values.begin(), more.values.end());
  }
  return inputs;
}

std::vector<NamedInput> direction_inputs(int random_count) {
  std::vector<NamedInput> inputs;
  for (const auto& [name, directions] : {std::pair{"axis ", axis_directions()},
                                         {"near pole ", near_pole_directions()},
                                         {"diagonal ", diagonal_directions()},
                                         {"equator ", equator_directions()},
                                         {"random ", random_directions(random_count, 1)}}) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto& [x, y, z] = directions[i];
      inputs.push_back({name + std::to_string(i), {x, y, z}});
    }
  }
  return inputs;
}

std::vector<NamedInput> quaternion_inputs() {
  constexpr int kRandom = 60;
  std::vector<NamedInput> all;
  add_named_turns(all);
  add_small_turns(all);
  add_tilts(all);
  for (auto& input : vector_inputs(4, kRandom, 24)) {
    input.name = "random " + input.name;
    all.push_back(std::move(input));
  }
  return all;
}

std::vector<NamedInput> matrix_inputs() {
  std::vector<NamedInput> all = quaternion_inputs();
  for (auto& input : all) {
    std::vector<double> matrix(9);
    matrix_of_quaternion(input.values.data(), matrix.data());
    input.values = matrix;
  }
  return all;
}

std::vector<NamedInput> turn_inputs() {
  constexpr int kRandom = 120;
  std::vector<NamedInput> all = {
      {"no turn", {1, 0}}, {"quarter turn", {0, 1}}, {"half turn", {-1, 0}}, {"quarter turn back", {0, -1}}};
  for (const double angle : kTiny) {
    all.push_back({"turn by " + printed(angle), {std::sqrt((1 - angle) * (1 + angle)), angle}});
    all.push_back({"turn by pi - " + printed(angle), {-std::sqrt((1 - angle) * (1 + angle)), angle}});
    all.push_back({"nearly a quarter turn", {angle, -std::sqrt((1 - angle) * (1 + angle))}});
  }
  Random random(25);
  for (int i = 0; i < kRandom; ++i) {
    const auto point = random_circle_point(random);
    all.push_back({"random " + std::to_string(i), {point.cosine, point.sine}});
  }
  return all;
}

}  // namespace sh::numeric
