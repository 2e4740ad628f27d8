// See inputs.hpp.
#include "numeric/kernels/checks/inputs.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

void append(std::vector<NamedInput>& all, const std::string& name, const std::vector<Direction>& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto& d = directions[i];
    all.push_back({name + " " + std::to_string(i), {d.x, d.y, d.z}});
  }
}

// Random components in [-1, 1) scaled to length 1; the first `zeros` of them are 0.
NamedInput unit_vector(const std::string& name, int size, int zeros, Random& random) {
  NamedInput input{name, {}};
  for (int i = 0; i < size; ++i) input.values.push_back(i < zeros ? 0 : random.next());
  const double norm = length(input.values.data(), size);
  for (double& value : input.values) value /= norm;
  return input;
}

}  // namespace

double length(const double* v, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += v[i] * v[i];
  return std::sqrt(sum);
}

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
  inputs.reserve(static_cast<std::size_t>(count));
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
  append(inputs, "axis", axis_directions());
  append(inputs, "near pole", near_pole_directions());
  append(inputs, "diagonal", diagonal_directions());
  append(inputs, "equator", equator_directions());
  append(inputs, "random", random_directions(random_count, 1));
  return inputs;
}

}  // namespace sh::numeric
