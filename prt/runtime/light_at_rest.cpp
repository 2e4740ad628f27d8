#include "prt/runtime/light_at_rest.hpp"

#include <array>
#include <utility>

#include "generated/batch/drivers.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/material/lobe.hpp"
#include "prt/mesh/corners.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLanes = batch::kBlock<float>;
static_assert(kVerticesPerChunk % kLanes == 0, "a chunk is made of whole blocks");

// to (3, bands^2) in its lane of a block = specular times the lobe's factors times what arrives.
void convolve(const Mesh& mesh, std::size_t vertex, int degree, const float* reaching, float* to) {
  std::array<float, kMaxDegree + 1> factors;
  for (int l = 0; l <= degree; ++l) {
    factors[l] = static_cast<float>(phong_factor(l, static_cast<double>(mesh.exponent[vertex])));
  }
  using Lane = Eigen::Map<Eigen::ArrayXf, Eigen::Unaligned, Eigen::InnerStride<kLanes>>;
  for (Eigen::Index c = 0; c < 3; ++c, reaching += coefficient_count(degree)) {
    for (int l = 0; l <= degree; ++l) {
      Lane(to, 2 * l + 1) = mesh.specular[vertex][c] * factors[l] * band(reaching, l);
      to += (2 * l + 1) * kLanes;
    }
  }
}

}  // namespace

LightAtRest::LightAtRest(const Transfer& transfer, TransferredRadiance reaching, std::vector<Eigen::Vector3f> albedo)
    : transfer_(transfer),
      reaching_(std::move(reaching)),
      albedo_(std::move(albedo)),
      constant_(transfer.mesh.positions.size(), Eigen::Vector3f::Zero()) {
  const Mesh& mesh = transfer.mesh;
  const int degree = reaching_.degree();
  const std::size_t size = 3 * coefficient_count(degree);
  if (!mesh.specular.empty()) lobes_.resize(batch::blocked_size<float>(constant_.size(), size));
  for_vertices(constant_.size(), [&](std::size_t v) {
    if (!transfer.emitted.empty()) constant_[v] = transfer.emitted[v];
    if (mesh.brdf_of(v)) return;
    const Eigen::Vector3f& normal = mesh.normals[v];
    constant_[v] += prt::exit_radiance(Material{.albedo = albedo_[v]}, degree, reaching_.at(v), normal, normal);
    if (lobes_.empty() || mesh.specular[v].isZero(0.0F)) return;
    convolve(mesh, v, degree, reaching_.at(v), &lobes_[v / kLanes * kLanes * size + v % kLanes]);
  });
}

std::vector<Eigen::Vector3f> LightAtRest::exit_radiance(const Eigen::Vector3d& eye) const {
  const Mesh& mesh = transfer_.mesh;
  const int degree = reaching_.degree();
  const std::size_t size = 3 * coefficient_count(degree);
  const Eigen::Vector3d local_eye = mesh.frame.local(eye);
  std::vector<Eigen::Vector3f> radiance = constant_;
  for_chunks(radiance.size(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, radiance.size());
    const auto to_eye = [&](std::size_t v) {
      return (local_eye - mesh.positions[v].cast<double>()).normalized().cast<float>().eval();
    };
    if (!lobes_.empty()) {
      std::array<Eigen::Vector3f, kVerticesPerChunk> directions;
      std::array<Eigen::Vector3f, kVerticesPerChunk> sent;
      for (std::size_t v = range.first; v < range.last; ++v) {
        directions[v - range.first] = mirrored(-to_eye(v), mesh.normals[v]);
      }
      batch::evaluate_rgb(degree, range.size(), batch::blocked(&lobes_[range.first * size]),
                          batch::plain(directions[0].data()), batch::plain(sent[0].data()));
      for (std::size_t v = range.first; v < range.last; ++v) radiance[v] += sent[v - range.first];
    }
    for (std::size_t v = range.first; v < range.last && !mesh.brdf.empty(); ++v) {
      if (!mesh.brdf_of(v)) continue;
      radiance[v] +=
          prt::exit_radiance(material_of(mesh, v, albedo_[v]), degree, reaching_.at(v), mesh.normals[v], to_eye(v));
    }
  });
  return radiance;
}

std::size_t LightAtRest::bytes_of_vertex() const {
  const std::size_t lobe = lobes_.empty() ? 0 : 3 * coefficient_count(reaching_.degree()) * sizeof(float);
  return lobe + sizeof(Eigen::Vector3f);
}

}  // namespace sh::prt
