// See inputs.hpp.
#include "numeric/checks/inputs.hpp"

#include "numeric/directions.hpp"

namespace sh::numeric {
namespace {

void append(std::vector<NamedInput>& all, const std::string& name, const std::vector<Direction>& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto& d = directions[i];
    all.push_back({name + " " + std::to_string(i), {d.x, d.y, d.z}});
  }
}

}  // namespace

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
