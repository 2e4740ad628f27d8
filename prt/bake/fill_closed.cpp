#include "prt/bake/fill_closed.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "prt/arrays.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr double kMostClosed = 1.0 - 1e-4;
constexpr float kMoreThanHalf = 0.5F;
constexpr std::size_t kColumnsAPart = 8;  // that one task solves; the same for any number of threads

}  // namespace

std::vector<ClosedVertex> closed_vertices(const Mesh& mesh, const std::vector<Sight>& sight) {
  std::map<std::uint32_t, std::set<std::uint32_t>> neighbors;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (sight[face[k]].closed() > 0.0F) neighbors[face[k]].insert({face[(k + 1) % 3], face[(k + 2) % 3]});
    }
  }
  for (const auto& [a, b] : neighboring_texels(mesh)) {
    if (sight[a].closed() > 0.0F) neighbors[a].insert(b);
    if (sight[b].closed() > 0.0F) neighbors[b].insert(a);
  }
  std::vector<ClosedVertex> closed;
  for (const auto& [vertex, around] : neighbors) {
    closed.push_back({vertex, sight[vertex].closed(), {around.begin(), around.end()}});
  }
  return closed;
}

// With n_v neighbors, the equation of v times n_v / c_v is symmetric:
//   n_v/c_v x_v - sum of closed neighbors x_u = n_v (1/c_v - 1) own_v + sum of sound neighbors own_u.
struct Fill::System {
  std::vector<ClosedVertex> closed;
  std::unordered_map<std::uint32_t, std::size_t> place;  // of a closed vertex
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;

  [[nodiscard]] double scale(const ClosedVertex& v) const {
    return static_cast<double>(v.neighbors.size()) / std::min(static_cast<double>(v.closed), kMostClosed);
  }

  template <class Number>
  void solve(Number* values, std::size_t stride, std::size_t first, std::size_t columns) const {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(Eigen::Index(closed.size()), Eigen::Index(columns));
    for (std::size_t i = 0; i < closed.size(); ++i) {
      const auto add = [&](std::uint32_t vertex, double weight) {
        const auto own = as_array(values + vertex * stride + first, columns);
        sums.row(Eigen::Index(i)) += weight * own.template cast<double>().matrix().transpose();
      };
      add(closed[i].vertex, scale(closed[i]) - static_cast<double>(closed[i].neighbors.size()));
      for (const std::uint32_t u : closed[i].neighbors) {
        if (place.count(u) == 0) add(u, 1.0);
      }
    }
    sums = solver.solve(sums).eval();
    for (std::size_t i = 0; i < closed.size(); ++i) {
      as_array(values + closed[i].vertex * stride + first, columns) =
          sums.row(Eigen::Index(i)).transpose().array().template cast<Number>();
    }
  }

  // Columns do not depend on each other.
  template <class Number>
  void apply(Number* values, std::size_t stride, std::size_t columns) const {
    in_parallel(std::size_t{0}, (columns + kColumnsAPart - 1) / kColumnsAPart, [&](std::size_t part) {
      const std::size_t first = part * kColumnsAPart;
      solve(values, stride, first, std::min(kColumnsAPart, columns - first));
    });
  }
};

Fill::Fill(std::vector<ClosedVertex> closed) {
  if (closed.empty()) return;
  const auto system = std::make_shared<System>();
  system->closed = std::move(closed);
  for (std::size_t i = 0; i < system->closed.size(); ++i) system->place[system->closed[i].vertex] = i;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < system->closed.size(); ++i) {
    entries.emplace_back(i, i, system->scale(system->closed[i]));
    for (const std::uint32_t u : system->closed[i].neighbors) {
      if (const auto at = system->place.find(u); at != system->place.end()) entries.emplace_back(i, at->second, -1.0);
    }
  }
  const auto size = Eigen::Index(system->closed.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  system->solver.compute(matrix);
  system_ = system;
}

// A row of the system sums to n (1/c - 1), its absolute values to n (1/c + 1) at most.
double Fill::condition() const { return any() ? (1.0 + kMostClosed) / (1.0 - kMostClosed) : 0.0; }

void Fill::apply(float* values, std::size_t stride, std::size_t columns) const {
  if (any()) system_->apply(values, stride, columns);
}

void Fill::apply(double* values, std::size_t stride, std::size_t columns) const {
  if (any()) system_->apply(values, stride, columns);
}

BuriedCount count_buried(const std::vector<ClosedVertex>& closed, const std::vector<Sight>& sight) {
  std::unordered_map<std::uint32_t, const ClosedVertex*> waiting;
  for (const ClosedVertex& v : closed) {
    if (v.closed > kMoreThanHalf) waiting[v.vertex] = &v;
  }
  BuriedCount count;
  for (const Sight& s : sight) count.buried += s.buried > kMoreThanHalf ? 1 : 0;
  std::vector<const ClosedVertex*> next;
  const auto reach = [&](std::unordered_map<std::uint32_t, const ClosedVertex*>::iterator at) {
    count.filled += sight[at->first].buried > kMoreThanHalf ? 1 : 0;
    next.push_back(at->second);
    waiting.erase(at);
  };
  const auto is_sound = [&](std::uint32_t u) { return sight[u].closed() <= kMoreThanHalf; };
  for (const ClosedVertex& v : closed) {
    const auto at = waiting.find(v.vertex);
    if (at != waiting.end() && std::any_of(v.neighbors.begin(), v.neighbors.end(), is_sound)) reach(at);
  }
  while (!next.empty()) {
    const ClosedVertex& v = *next.back();
    next.pop_back();
    for (const std::uint32_t u : v.neighbors) {
      if (const auto at = waiting.find(u); at != waiting.end()) reach(at);
    }
  }
  return count;
}

}  // namespace sh::prt
