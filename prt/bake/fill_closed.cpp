#include "prt/bake/fill_closed.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace sh::prt {

namespace {

using Neighbors = std::map<std::uint32_t, std::set<std::uint32_t>>;  // of some vertices

Neighbors neighbors_of_sightless(const Mesh& mesh, const std::vector<Sight>& sight) {
  Neighbors neighbors;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (sight[face[k]] != Sight::kSome) neighbors[face[k]].insert({face[(k + 1) % 3], face[(k + 2) % 3]});
    }
  }
  return neighbors;
}

bool is_filled(const std::vector<Sight>& sight, std::uint32_t vertex, const std::set<std::uint32_t>& neighbors) {
  return sight[vertex] == Sight::kBuried || sight[vertex] == Sight::kCovered ||
         std::all_of(neighbors.begin(), neighbors.end(), [&](std::uint32_t n) { return sight[n] == Sight::kSome; });
}

}  // namespace

FillPlan plan_fill(const Mesh& mesh, const std::vector<Sight>& sight) {
  Neighbors unknown = neighbors_of_sightless(mesh, sight);
  std::erase_if(unknown, [&](const auto& entry) { return !is_filled(sight, entry.first, entry.second); });
  const auto is_flaw = [&](const auto& entry) { return sight[entry.first] != Sight::kCovered; };
  FillPlan plan;
  plan.closed = std::count_if(unknown.begin(), unknown.end(), is_flaw);
  std::size_t ring = 0;  // the first fill of the current ring
  do {
    ring = plan.fills.size();
    for (const auto& [vertex, neighbors] : unknown) {
      Fill fill{vertex, {}};
      std::copy_if(neighbors.begin(), neighbors.end(), std::back_inserter(fill.sources),
                   [&](std::uint32_t n) { return unknown.count(n) == 0; });
      if (!fill.sources.empty()) plan.fills.push_back(std::move(fill));
    }
    for (std::size_t i = ring; i < plan.fills.size(); ++i) {
      plan.filled += sight[plan.fills[i].vertex] != Sight::kCovered ? 1 : 0;
      unknown.erase(plan.fills[i].vertex);
    }
  } while (ring < plan.fills.size());
  return plan;
}

void fill_closed(Transfer& transfer, const FillPlan& plan) {
  const std::size_t count = transfer.shape.length();
  std::vector<float> mean(count);
  for (const auto& [vertex, sources] : plan.fills) {
    std::fill(mean.begin(), mean.end(), 0.0F);
    for (const std::uint32_t source : sources) {
      const float* value = transfer.row(source);
      std::transform(value, value + count, mean.begin(), mean.begin(), std::plus<>());
    }
    const auto known = static_cast<float>(sources.size());
    std::transform(mean.begin(), mean.end(), transfer.row(vertex), [known](float sum) { return sum / known; });
  }
}

}  // namespace sh::prt
