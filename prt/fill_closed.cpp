#include "prt/fill_closed.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace sh::prt {

namespace {

using Neighbours = std::map<std::uint32_t, std::set<std::uint32_t>>;  // of closed vertices only

Neighbours neighbours_of_closed(const Mesh& mesh, const std::vector<std::uint8_t>& closed) {
  Neighbours neighbours;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (closed[face[k]] != 0) {
        neighbours[face[k]].insert({face[(k + 1) % 3], face[(k + 2) % 3]});
      }
    }
  }
  return neighbours;
}

// The mean of the neighbours that have a value; false where none has.
bool mean_of_known(const Transfer& transfer, const std::vector<std::uint8_t>& unknown,
                   const std::set<std::uint32_t>& neighbours, std::vector<float>& mean) {
  const std::size_t count = transfer.bands_squared();
  mean.assign(count, 0.0F);
  std::size_t known = 0;
  for (const std::uint32_t n : neighbours) {
    if (unknown[n] == 0) {
      const float* value = transfer.coefficients.data() + n * count;
      std::transform(value, value + count, mean.begin(), mean.begin(), std::plus<>());
      ++known;
    }
  }
  std::for_each(mean.begin(), mean.end(),
                [&](float& value) { value /= static_cast<float>(std::max<std::size_t>(known, 1)); });
  return known > 0;
}

}  // namespace

FillCount fill_closed(Transfer& transfer, const std::vector<std::uint8_t>& closed) {
  FillCount result;
  result.closed = static_cast<std::size_t>(std::count(closed.begin(), closed.end(), std::uint8_t{1}));
  Neighbours open_tasks = result.closed > 0 ? neighbours_of_closed(transfer.mesh, closed) : Neighbours();
  std::vector<std::uint8_t> unknown = closed;
  bool progressed = true;
  while (progressed) {
    std::vector<std::pair<std::uint32_t, std::vector<float>>> ring;
    std::vector<float> mean;
    for (const auto& [vertex, neighbours] : open_tasks) {
      if (mean_of_known(transfer, unknown, neighbours, mean)) {
        ring.emplace_back(vertex, mean);
      }
    }
    for (const auto& [vertex, value] : ring) {
      std::copy(value.begin(), value.end(),
                transfer.coefficients.begin() + static_cast<std::ptrdiff_t>(vertex * value.size()));
      unknown[vertex] = 0;
      open_tasks.erase(vertex);
    }
    result.filled += ring.size();
    progressed = !ring.empty();
  }
  return result;
}

}  // namespace sh::prt
