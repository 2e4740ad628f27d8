#include "prt/study/frames.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "prt/chunks.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/light_at_rest.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {

namespace {

/// The least processor time of some passes, on one thread.
template <class Work>
double least_seconds(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  on_threads(1, [&] {
    for (int pass = 0; pass < kFramePasses; ++pass) {
      const double start = thread_seconds();
      work();
      least = std::min(least, thread_seconds() - start);
    }
  });
  return least;
}

Radiances in_double(const std::vector<Eigen::Vector3f>& radiance) {
  Radiances values;
  for (const Eigen::Vector3f& value : radiance) values.push_back(value.cast<double>());
  return values;
}

double bytes_of_vertex(const Transfer& transfer) {
  const std::size_t vertices = transfer.mesh.positions.size();
  const bool matrices = transfer.kind->indirect != nullptr;
  const std::size_t bytes =
      transfer.shape.stored_bytes(vertices) + (matrices ? transfer.indirect_shape.stored_bytes(vertices) : 0);
  return static_cast<double>(bytes) / static_cast<double>(vertices);
}

}  // namespace

LightCoefficients Frames::light(const Transfer& transfer) const { return first_bands(light_, transfer.degree()); }

ShownFrame Frames::free(const Transfer& transfer) const {
  if (!transfer.kind->is_glossy()) return relit(transfer, transfer);
  const double seconds = least_seconds([&] {
    return exit_radiance(transfer, TransferredRadiance(transfer, light(transfer)), eye_, transfer.mesh.albedo);
  });
  return shown(transfer, seconds, bytes_of_vertex(transfer));
}

ShownFrame Frames::light_at_rest(const Transfer& transfer) const {
  const LightAtRest at_rest(transfer, TransferredRadiance(transfer, light(transfer)), transfer.mesh.albedo);
  const double seconds = least_seconds([&] { return at_rest.exit_radiance(eye_); });
  return shown(transfer, seconds, static_cast<double>(at_rest.bytes_of_vertex()));
}

ShownFrame Frames::view_at_rest(const Transfer& transfer) const { return relit(seen_from(transfer, eye_), transfer); }

// `rows` are those of the mesh of `transfer`.
ShownFrame Frames::relit(const Transfer& rows, const Transfer& transfer) const {
  std::vector<Eigen::Vector3f> radiance(rows.mesh.positions.size());
  const double seconds = least_seconds([&] { relight_into(rows, light(rows), radiance); });
  return {seconds, bytes_of_vertex(rows), in_double(radiance), diffuse_surface(transfer.mesh, radiance)};
}

ShownFrame Frames::shown(const Transfer& transfer, double seconds, double bytes) const {
  TransferredRadiance reaching(transfer, light(transfer));
  Radiances values = in_double(exit_radiance(transfer, reaching, eye_, transfer.mesh.albedo));
  return {seconds, bytes, std::move(values), glossy_surface(transfer, std::move(reaching), transfer.mesh.albedo)};
}

}  // namespace sh::prt
