#include "prt/bake/between_vertices.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "prt/arrays.hpp"
#include "prt/bake/row_tracer.hpp"
#include "prt/chunks.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kProbes = 256;
constexpr float kOffset = 2e-3F;  // of the distance from the center to the corners, as for vertices

double area(const Mesh& mesh, const Face& face) {
  const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
  return 0.5 * (mesh.positions[face[1]].cast<double>() - a).cross(mesh.positions[face[2]].cast<double>() - a).norm();
}

// Faces at equal steps of the area.
std::vector<std::uint32_t> choose_faces(const Mesh& mesh) {
  std::vector<double> sums;
  for (const Face& face : mesh.faces) sums.push_back((sums.empty() ? 0.0 : sums.back()) + area(mesh, face));
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const double at = sums.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(kProbes);
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, at);
    chosen.push_back(static_cast<std::uint32_t>(found - sums.begin()));
  }
  return chosen;
}

// The mean over the corners of a face.
Hit center(std::uint32_t face) { return {face, 1.0F / 3.0F, 1.0F / 3.0F, 0.0F}; }

// The mesh with a vertex without faces at the center of every chosen face.
Mesh with_centers(const Mesh& mesh, const std::vector<std::uint32_t>& faces) {
  Mesh out = mesh;
  for (const std::uint32_t face : faces) {
    out.positions.push_back(interpolated(center(face), mesh, mesh.positions));
    out.normals.push_back(interpolated(center(face), mesh, mesh.normals).normalized());
    out.geometric_normals.push_back(face_normal(mesh.positions, mesh.faces[face]));
    out.albedo.push_back(interpolated(center(face), mesh, mesh.albedo));
    repeat_finish(out, mesh.faces[face][0]);
  }
  return out;
}

}  // namespace

BetweenVertices measure_between_vertices(const Scene& scene, const std::string& instruction_set, const Panel& x,
                                         const BounceLayout& layout) {
  const std::vector<std::uint32_t> faces = choose_faces(scene.mesh);
  const Mesh mesh = with_centers(scene.mesh, faces);
  RaySetup setup(mesh, scene.bake, 0, instruction_set);
  const std::size_t first = scene.mesh.positions.size();
  for (std::size_t i = 0; i < kProbes; ++i) {
    const Eigen::Vector3f& at = mesh.positions[first + i];
    const float reach = (mesh.positions[mesh.faces[faces[i]][0]] - at).norm();
    setup.starts[first + i] = {at + kOffset * reach * mesh.geometric_normals[first + i], reach};
  }
  std::vector<double> differences(kProbes, 0.0);
  std::vector<double> lights(kProbes, 0.0);
  tbb::enumerable_thread_specific<RowTracer> tracers([&] { return RowTracer(setup); });
  for_vertices(kProbes, [&](std::size_t i) {
    const std::size_t v = first + i;
    RowTracer& rows = tracers.local();
    std::vector<float> direct = unshadowed_transfer(scene.bake.degree, {mesh.normals[v]});
    control_with_unshadowed(rows.gatherer().gather(v), direct.size(), direct.data());
    rows.meet(v);
    if (setup.mirrors.any()) rows.add_sky(scene.bake.degree, direct.data());
    const FormFactorRow row = rows.row(v);
    const ReceiversAt around = setup.receivers.at(center(faces[i]));
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
      const auto of = [&](std::size_t q) { return as_array(x.row(q) + layout.channel(c), layout.count); };
      Eigen::ArrayXd light = Eigen::ArrayXd::Zero(Eigen::Index(layout.count));
      for (const FormFactor& factor : row) light += static_cast<double>(factor.weight) * of(factor.vertex);
      light.head(Eigen::Index(direct.size())) += as_array(direct).cast<double>();
      light *= static_cast<double>(mesh.albedo[v][c]);
      if (layout.emitted > 0) light.tail<1>() += static_cast<double>(mesh.emission[v][c]);
      Eigen::ArrayXd between = Eigen::ArrayXd::Zero(Eigen::Index(layout.count));
      for (std::size_t k = 0; k < around.count; ++k)
        between += static_cast<double>(around.part[k]) * of(around.receiver[k]);
      differences[i] += (light - between).square().sum();
      lights[i] += light.square().sum();
    }
  });
  const auto root = [](const std::vector<double>& squares) {
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
  };
  return {root(differences), root(lights)};
}

}  // namespace sh::prt
