// Inputs by the roles of a kernel's parameters; see inputs.hpp.
#include <algorithm>
#include <string>
#include <utility>

#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

// Directions of several lengths between the least and the largest; every second one of length 1.
std::vector<NamedInput> vectors(const std::array<double, 2>& lengths) {
  constexpr int kRandom = 150;
  const std::array<double, 4> all = {lengths[0], std::sqrt(lengths[0]), std::sqrt(lengths[1]), lengths[1]};
  auto inputs = direction_inputs(kRandom);
  for (std::size_t i = 1; i < inputs.size(); i += 2) {
    const double size = all[i / 2 % all.size()];
    for (double& value : inputs[i].values) value *= size;
    inputs[i].name += " times " + std::to_string(size);
  }
  return inputs;
}

// Numbers in [0, 1], ends, tiny and nearly 1 included.
std::vector<NamedInput> fractions() {
  std::vector<NamedInput> inputs;
  for (const double g : {0.0, 1e-30, 1e-4, 0.5, 1 - 1e-6, 1.0}) inputs.push_back({"named", {g}});
  for (int i = 0; i < 150; ++i) inputs.push_back({"fraction " + std::to_string(i), {(i + 0.5) / 150}});
  return inputs;
}

class InputsByRole {
 public:
  InputsByRole(const Signature& signature, int degree, const std::array<double, 2>& lengths)
      : degree_(degree), lengths_(lengths) {
    for (const Parameter& parameter : signature.parameters) {
      if (parameter.is_read()) parameters_.push_back(parameter);
    }
    accumulates_ = has("weight") || has("color");
  }

  std::vector<NamedInput> all(const std::function<std::vector<NamedInput>(int degree)>& made) {
    std::vector<NamedInput> inputs;
    for (std::size_t i = 0; i < parameters_.size();) {
      const std::size_t together = same_role_from(i);
      const bool is_made = made && parameters_[i].is_prepared();
      auto next = is_made ? made(degree_) : of_role(parameters_[i], static_cast<int>(together));
      if (accumulates_ && parameters_[i].access == Access::kInOut) clear_every_second(next);
      inputs = inputs.empty() ? std::move(next) : combined(inputs, next);
      i += together;
    }
    return inputs;
  }

 private:
  [[nodiscard]] bool has(const std::string& role) const {
    return std::any_of(parameters_.begin(), parameters_.end(), [&](const Parameter& p) { return p.role == role; });
  }

  // Coordinates follow each other, and so do the colors of one light, and a cosine and its sine.
  [[nodiscard]] std::size_t same_role_from(std::size_t first) const {
    const std::string& role = parameters_[first].role;
    if (role == "cosine") return 2;
    if (role != "direction" && role != "vector" && role != "color") return 1;
    std::size_t end = first;
    while (end < parameters_.size() && parameters_[end].role == role) ++end;
    return end - first;
  }

  std::vector<NamedInput> of_role(const Parameter& parameter, int together) {
    constexpr int kAlone = 4096;
    constexpr int kBesideOthers = 150;
    const std::string& role = parameter.role;
    if (role == "direction") return direction_inputs(parameters_.size() == 3 ? kAlone : kBesideOthers);
    if (role == "vector") return vectors(lengths_);
    if (role == "rotation matrix") return matrix_inputs();
    if (role == "quaternion") return quaternion_inputs();
    if (role == "cosine") return turn_inputs();
    if (role == "cap size") return cap_inputs();
    if (role == "weight") return {{"weight 1", {1}}, {"weight -0.3", {-0.3}}, {"weight 17", {17}}};
    if (role == "color") return vector_inputs(together, 37, next_seed());
    if (parameter.count == 0) return fractions();
    const int bands_squared = parameter.degree < 0 ? 0 : coefficient_count(parameter.degree);
    if (parameter.count != parameter.channels * bands_squared) return vector_inputs(parameter.count, 53, next_seed());
    std::vector<NamedInput> functions = coefficients(parameter.degree);
    for (int i = 1; i < parameter.channels; ++i) functions = combined(functions, coefficients(parameter.degree));
    return functions;
  }

  // The first ones are the same for every parameter, so that factors of a product are equal; the last is tiny, to see
  // that nothing underflows where the result does not.
  std::vector<NamedInput> coefficients(int degree) {
    constexpr int kEqual = 4;
    constexpr int kVectors = 60;
    constexpr int kVectorsAlone = 200;
    const auto seed = next_seed();
    const int count = (parameters_.size() == 1 ? kVectorsAlone : kVectors) - static_cast<int>(seed - kFirstSeed);
    auto inputs = coefficient_inputs(degree, kEqual, kFirstSeed - 1);
    for (auto& input : inputs) input.name += " of all";
    for (auto& input : coefficient_inputs(degree, count, seed)) inputs.push_back(std::move(input));
    inputs.push_back(inputs.front());
    inputs.back().name += ", scaled";
    for (double& value : inputs.back().values) value *= 1e-15;
    return inputs;
  }

  // Every second sample is added to nothing, so that its own error shows.
  static void clear_every_second(std::vector<NamedInput>& inputs) {
    for (std::size_t i = 0; i < inputs.size(); i += 2) {
      inputs[i] = {"from zero", std::vector<double>(inputs[i].values.size())};
    }
  }

  std::uint64_t next_seed() { return seed_++; }

  static constexpr std::uint64_t kFirstSeed = 31;
  std::vector<Parameter> parameters_;
  int degree_;
  std::array<double, 2> lengths_;
  bool accumulates_ = false;
  std::uint64_t seed_ = kFirstSeed;
};

}  // namespace

std::vector<NamedInput> inputs_by_role(const Signature& signature, int degree, const std::array<double, 2>& lengths,
                                       const std::function<std::vector<NamedInput>(int degree)>& made) {
  return InputsByRole(signature, degree, lengths).all(made);
}

}  // namespace sh::numeric
