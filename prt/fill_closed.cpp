#include "prt/fill_closed.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace sh::prt {

namespace {

using Neighbours = std::map<std::uint32_t, std::set<std::uint32_t>>;  // of some vertices

Neighbours neighbours_of_sightless(const Mesh& mesh, const std::vector<Sight>& sight) {
  Neighbours neighbours;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (sight[face[k]] != Sight::kSome) {
        neighbours[face[k]].insert({face[(k + 1) % 3], face[(k + 2) % 3]});
      }
    }
  }
  return neighbours;
}

bool is_filled(const std::vector<Sight>& sight, std::uint32_t vertex, const std::set<std::uint32_t>& neighbours) {
  return sight[vertex] == Sight::kBuried || sight[vertex] == Sight::kCovered ||
         std::all_of(neighbours.begin(), neighbours.end(), [&](std::uint32_t n) { return sight[n] == Sight::kSome; });
}

// The mean of the neighbours that are not left to fill; empty where all are.
std::vector<float> mean_of_known(const Transfer& transfer, const Neighbours& unknown,
                                 const std::set<std::uint32_t>& neighbours) {
  const std::size_t count = transfer.bands_squared();
  std::vector<float> mean;
  float known = 0.0F;
  for (const std::uint32_t n : neighbours) {
    if (unknown.count(n) == 0) {
      mean.resize(count, 0.0F);
      const float* value = transfer.coefficients.data() + n * count;
      std::transform(value, value + count, mean.begin(), mean.begin(), std::plus<>());
      known += 1.0F;
    }
  }
  for (float& value : mean) {
    value /= known;
  }
  return mean;
}

}  // namespace

FillCount fill_closed(Transfer& transfer, const std::vector<Sight>& sight) {
  Neighbours unknown = neighbours_of_sightless(transfer.mesh, sight);
  std::erase_if(unknown, [&](const auto& entry) { return !is_filled(sight, entry.first, entry.second); });
  const auto is_flaw = [&](const auto& entry) { return sight[entry.first] != Sight::kCovered; };
  FillCount result;
  result.closed = static_cast<std::size_t>(std::count_if(unknown.begin(), unknown.end(), is_flaw));
  std::vector<std::pair<std::uint32_t, std::vector<float>>> ring;
  do {
    ring.clear();
    for (const auto& [vertex, neighbours] : unknown) {
      std::vector<float> mean = mean_of_known(transfer, unknown, neighbours);
      if (!mean.empty()) {
        ring.emplace_back(vertex, std::move(mean));
      }
    }
    for (const auto& [vertex, value] : ring) {
      std::copy(value.begin(), value.end(), transfer.coefficients.data() + vertex * value.size());
      result.filled += sight[vertex] != Sight::kCovered ? 1 : 0;
      unknown.erase(vertex);
    }
  } while (!ring.empty());
  return result;
}

}  // namespace sh::prt
