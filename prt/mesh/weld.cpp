#include "prt/mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/halving.hpp"

namespace sh::prt {
namespace {

constexpr float kNormalSteps = 8192.0F;

Eigen::Vector3f rounded(const Eigen::Vector3f& normal) { return (normal * kNormalSteps).array().round().matrix(); }

// Appends an optional array of a mesh part; a mesh or part without it has zeros.
template <class T>
void append_all_or_zeros(std::vector<T>& to, std::size_t count, const std::vector<T>& from, std::size_t from_count,
                         const T& zero) {
  if (!to.empty() || !from.empty()) {
    to.resize(count, zero);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(count + from_count, zero);
  }
}

// (finish of each vertex) -> one of its colors for each vertex, or nothing if all are zero.
template <class Color>
std::vector<Eigen::Vector3f> spread(const std::vector<std::uint32_t>& finish_of_vertex,
                                    const std::vector<Finish>& finishes, const Color& color) {
  std::vector<Eigen::Vector3f> values;
  bool is_zero = true;
  for (const std::uint32_t finish : finish_of_vertex) {
    values.push_back(color(finishes[finish]));
    is_zero = is_zero && values.back().isZero(0.0F);
  }
  return is_zero ? std::vector<Eigen::Vector3f>() : values;
}

// (vertices) 1 + number of what table_of(finish) points to in `tables`, 0 for null; nothing if all are null.
template <class Tables, class TableOf>
std::vector<std::uint16_t> numbers_of(const std::vector<std::uint32_t>& finish_of_vertex,
                                      const std::vector<Finish>& finishes, Tables& tables, const TableOf& table_of) {
  std::vector<std::uint16_t> numbers;
  for (const Finish& finish : finishes) {
    const auto* table = table_of(finish);
    numbers.push_back(table != nullptr ? static_cast<std::uint16_t>(1 + tables.number_of(*table)) : 0);
  }
  std::vector<std::uint16_t> of_vertices;
  if (tables.heads.empty()) return of_vertices;
  for (const std::uint32_t finish : finish_of_vertex) of_vertices.push_back(numbers[finish]);
  return of_vertices;
}

// The numbers of the vertices of a part, which refer to its own tables, in `all`, which gets the tables that it lacks.
template <class Tables>
std::vector<std::uint16_t> renumbered(const std::vector<std::uint16_t>& of_vertices, const Tables& own, Tables& all) {
  std::vector<std::uint16_t> numbers = {0};
  for (std::size_t i = 0; i < own.heads.size(); ++i) {
    numbers.push_back(static_cast<std::uint16_t>(1 + all.number_of(own.at(i))));
  }
  std::vector<std::uint16_t> renumbered;
  for (const std::uint16_t number : of_vertices) renumbered.push_back(numbers[number]);
  return renumbered;
}

template <class T>
void append_all(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Atlases are never shared: their texels are vertices of the part. To be called before its positions are there.
void append_atlases(Mesh& mesh, const Mesh& part) {
  const std::size_t first = mesh.positions.size();
  const auto before = static_cast<std::uint16_t>(mesh.atlases.heads.size());
  std::vector<std::uint16_t> numbers = part.atlas;
  for (std::uint16_t& number : numbers) number = number == 0 ? 0 : static_cast<std::uint16_t>(number + before);
  append_all_or_zeros(mesh.chart, first, part.chart, part.positions.size(), Eigen::Vector2f::Zero().eval());
  append_all_or_zeros(mesh.atlas, first, numbers, part.positions.size(), std::uint16_t{0});
  for (Atlases::Head head : part.atlases.heads) {
    head.first += static_cast<std::uint32_t>(first);
    mesh.atlases.heads.push_back(head);
  }
  append_all(mesh.atlases.pixels, part.atlases.pixels);
  append_all(mesh.atlases.reach, part.atlases.reach);
}

}  // namespace

Mesh weld(const Soup& soup, std::size_t source_vertices) {
  Mesh mesh;
  mesh.remap.assign(source_vertices, kNoVertex);
  std::unordered_map<std::array<std::uint32_t, 14>, std::uint32_t, WordsHash> welded;
  welded.reserve(soup.positions.size());
  std::vector<std::uint32_t> finish_of_vertex;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Face& face = soup.faces[f];
    Face indices{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = face[k];
      const std::uint32_t finish = soup.finish_of(f);
      const Eigen::Vector2f texture =
          soup.finishes[finish].has_pictures() ? soup.texture[v] : Eigen::Vector2f::Zero().eval();
      const Eigen::Vector2f chart = soup.chart.empty() ? Eigen::Vector2f::Zero().eval() : soup.chart[v];
      Eigen::Matrix<float, 13, 1> numbers;
      numbers << soup.positions[v].cast<float>(), rounded(soup.normals[v]), soup.albedo[v], texture, chart;
      std::array<std::uint32_t, 14> key{};
      std::copy_n(bits_of(numbers).begin(), 13, key.begin());
      key[13] = finish;
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [entry, added] = welded.try_emplace(key, next);
      if (added) {
        mesh.positions.emplace_back(soup.positions[v].cast<float>());
        mesh.normals.push_back(soup.normals[v]);
        mesh.albedo.push_back(soup.albedo[v]);
        mesh.texture.push_back(texture);
        if (!soup.chart.empty()) mesh.chart.push_back(chart);
        finish_of_vertex.push_back(finish);
      }
      indices[k] = entry->second;
      if (source_vertices > 0) {
        std::uint32_t& made = mesh.remap.at(soup.source.empty() ? v : soup.source[v]);
        made = made == kNoVertex ? entry->second : made;
      }
    }
    mesh.faces.push_back(indices);
  }
  mesh.emission = spread(finish_of_vertex, soup.finishes, [](const Finish& finish) { return finish.emission; });
  mesh.mirror = spread(finish_of_vertex, soup.finishes, [](const Finish& finish) { return finish.mirror; });
  mesh.specular = spread(finish_of_vertex, soup.finishes, [](const Finish& finish) { return finish.gloss.specular; });
  for (std::size_t v = 0; v < mesh.specular.size(); ++v) {
    mesh.exponent.push_back(soup.finishes[finish_of_vertex[v]].gloss.exponent);
  }
  mesh.brdf = numbers_of(finish_of_vertex, soup.finishes, mesh.brdfs,
                         [](const Finish& finish) { return finish.gloss.brdf.get(); });
  mesh.normal_map = numbers_of(finish_of_vertex, soup.finishes, mesh.normal_maps,
                               [](const Finish& finish) { return finish.normal_map.get(); });
  mesh.albedo_map = numbers_of(finish_of_vertex, soup.finishes, mesh.albedo_maps,
                               [](const Finish& finish) { return finish.varied.shown.get(); });
  mesh.translucence = numbers_of(finish_of_vertex, soup.finishes, mesh.translucences, [](const Finish& finish) {
    return finish.translucence ? &*finish.translucence : nullptr;
  });
  if (!mesh.albedo_map.empty()) mesh.tint = mesh.albedo;  // until vary_materials()
  if (std::none_of(soup.finishes.begin(), soup.finishes.end(), std::mem_fn(&Finish::has_pictures)))
    mesh.texture.clear();
  set_geometric_normals(mesh);
  return mesh;
}

void set_geometric_normals(Mesh& mesh) {
  mesh.geometric_normals.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f normal = face_normal(mesh.positions, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const float side = normal.dot(mesh.normals[face[k]]) < 0.0F ? -1.0F : 1.0F;
      mesh.geometric_normals[face[k]] += normal * (side * corner_angle(mesh.positions, face, k));
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Eigen::Vector3f& normal = mesh.geometric_normals[v];
    normal = normal.norm() > 1e-6F ? normal.normalized() : mesh.normals[v];
  }
}

std::vector<float> reaches(const Mesh& mesh) {
  if (!mesh.reach.empty()) return mesh.reach;
  std::vector<float> distance(mesh.positions.size(), 0.0F);
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0F;
    for (const std::uint32_t v : face) {
      distance[v] += (middle - mesh.positions[v]).norm();
      ++faces[v];
    }
  }
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (faces[v] > 0) distance[v] /= static_cast<float>(faces[v]);
  }
  return distance;
}

void append(Mesh& mesh, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Eigen::Vector3f black = Eigen::Vector3f::Zero();
  append_all_or_zeros(mesh.emission, first, part.emission, part.positions.size(), black);
  append_all_or_zeros(mesh.mirror, first, part.mirror, part.positions.size(), black);
  append_all_or_zeros(mesh.specular, first, part.specular, part.positions.size(), black);
  append_all_or_zeros(mesh.exponent, first, part.exponent, part.positions.size(), 0.0F);
  append_all_or_zeros(mesh.brdf, first, renumbered(part.brdf, part.brdfs, mesh.brdfs), part.positions.size(),
                      std::uint16_t{0});
  append_all_or_zeros(mesh.texture, first, part.texture, part.positions.size(), Eigen::Vector2f::Zero().eval());
  append_all_or_zeros(mesh.normal_map, first, renumbered(part.normal_map, part.normal_maps, mesh.normal_maps),
                      part.positions.size(), std::uint16_t{0});
  append_all_or_zeros(mesh.albedo_map, first, renumbered(part.albedo_map, part.albedo_maps, mesh.albedo_maps),
                      part.positions.size(), std::uint16_t{0});
  append_all_or_zeros(mesh.tint, first, part.tint, part.positions.size(), black);
  append_all_or_zeros(mesh.translucence, first, renumbered(part.translucence, part.translucences, mesh.translucences),
                      part.positions.size(), std::uint16_t{0});
  append_atlases(mesh, part);
  append_halving(mesh, part);
  append_all(mesh.positions, part.positions);
  append_all(mesh.normals, part.normals);
  append_all(mesh.geometric_normals, part.geometric_normals);
  append_all(mesh.albedo, part.albedo);
  for (MeshNode node : part.nodes) {
    for (auto& run : node.faces) run[0] += static_cast<std::uint32_t>(mesh.faces.size());
    mesh.nodes.push_back(std::move(node));
  }
  for (const Face& face : part.faces) mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  for (const std::uint32_t vertex : part.remap) mesh.remap.push_back(vertex == kNoVertex ? kNoVertex : vertex + first);
}

void repeat_finish(Mesh& mesh, std::uint32_t vertex) {
  for (std::vector<Eigen::Vector3f>* values : {&mesh.emission, &mesh.mirror, &mesh.specular, &mesh.tint}) {
    if (!values->empty()) values->push_back(Eigen::Vector3f((*values)[vertex]));
  }
  if (!mesh.exponent.empty()) mesh.exponent.push_back(float{mesh.exponent[vertex]});
  for (std::vector<std::uint16_t>* numbers : {&mesh.brdf, &mesh.normal_map, &mesh.albedo_map, &mesh.translucence}) {
    if (!numbers->empty()) numbers->push_back(std::uint16_t{(*numbers)[vertex]});
  }
}

void add_backs(Mesh& mesh, const std::vector<std::uint8_t>& is_two_sided) {
  std::vector<std::uint32_t> backs(mesh.positions.size(), kNoVertex);
  const auto back_of = [&](std::uint32_t front) {
    if (backs[front] == kNoVertex) {
      backs[front] = static_cast<std::uint32_t>(mesh.positions.size());
      visit_vertex_arrays(mesh, [front](auto& values) {
        if (!values.empty()) values.push_back(values[front]);
      });
      mesh.normals.back() = -mesh.normals[front];
    }
    return backs[front];
  };
  const std::size_t faces = mesh.faces.size();
  std::vector<std::uint32_t> back_faces(faces, kNoFace);
  for (std::size_t f = 0; f < faces; ++f) {
    if (is_two_sided[f] != 0) {
      back_faces[f] = static_cast<std::uint32_t>(mesh.faces.size());
      const Face front = mesh.faces[f];
      const std::uint32_t first = back_of(front[0]);
      const std::uint32_t second = back_of(front[2]);
      mesh.faces.push_back({first, second, back_of(front[1])});
    }
  }
  add_backs(mesh.halving, backs, back_faces);
  set_geometric_normals(mesh);
}

}  // namespace sh::prt
