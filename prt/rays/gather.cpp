#include "prt/rays/gather.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/angles.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/row_sums.hpp"
#include "prt/rays/widest.hpp"

namespace sh::prt {

namespace {

constexpr float kOffset = 2e-3F;           // of the reach of the mesh around
constexpr float kRoundings = 32.0F;        // at least this many roundings of the coordinates,
constexpr float kMostOffset = 0.1F;        // but at most this part of the reach
constexpr float kNearReach = 2.0F;         // hits nearer than this many reaches are near
constexpr std::size_t kStreamRays = 1024;  // a stream call

// out (count) = scale normal.direction for directions (3, count).
SHFORGE_WIDEST void cosines(const float* directions, std::size_t count, float x, float y, float z, float* out) {
  const float* dx = directions;
  const float* dy = directions + count;
  const float* dz = directions + 2 * count;
  for (std::size_t j = 0; j < count; ++j) out[j] = x * dx[j] + y * dy[j] + z * dz[j];
}

// 0 up to the first end, 1 from the second on, a straight line in between.
double ramp(double x, const std::array<double, 2>& ends) {
  return std::clamp((x - ends[0]) / (ends[1] - ends[0]), 0.0, 1.0);
}

// Between these parts of the cosine a vertex goes over from sound to closed: the part that it sees, and the parts of its
// horizon whose rays hit backs of faces or anything near.
constexpr std::array<double, 2> kLittleSeen = {0.02, kNearlyDark};
constexpr std::array<double, 2> kManyBacks = {0.4, 0.6};
constexpr std::array<double, 2> kMostNear = {0.95, 0.99};

// (vertices) 0 where there is no texel, and of a mesh from a file.
std::vector<float> reaches_of_texels(const Mesh& mesh) {
  std::vector<float> reaches(mesh.positions.size(), 0.0F);
  for (std::size_t a = 0; a < mesh.atlases.heads.size() && !mesh.atlases.reach.empty(); ++a) {
    const Atlases::Head& head = mesh.atlases.heads[a];
    std::copy_n(mesh.atlases.reach.begin() + static_cast<std::ptrdiff_t>(mesh.atlases.entry(a)), head.count,
                reaches.begin() + head.first);
  }
  return reaches;
}

}  // namespace

std::vector<RayStart> ray_starts(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> inward(mesh.positions.size(), Eigen::Vector3f::Zero());
  std::vector<float> distance(mesh.positions.size(), 0.0F);
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3.0F;
    for (const std::uint32_t v : face) {
      inward[v] += middle - mesh.positions[v];
      distance[v] += (middle - mesh.positions[v]).norm();
    }
  }
  const std::vector<float> reach_of_vertex = reaches(mesh);
  const std::vector<float> reach_of_texel = reaches_of_texels(mesh);
  std::vector<RayStart> starts;
  starts.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f& position = mesh.positions[v];
    const float reach = distance[v] > 0.0F ? reach_of_vertex[v] : reach_of_texel[v];
    const float rounding = std::numeric_limits<float>::epsilon() * position.cwiseAbs().maxCoeff();
    const float length = std::max(kOffset * reach, std::min(kRoundings * rounding, kMostOffset * reach));
    const Eigen::Vector3f& up = mesh.geometric_normals[v];
    const Eigen::Vector3f along = distance[v] > 0.0F ? (inward[v] / distance[v]).eval() : inward[v];
    starts.push_back({position + length * (up + along - along.dot(up) * up), reach});
  }
  return starts;
}

SharedDirections::SharedDirections(const BakeOptions& options)
    : SharedDirections(options, options.kind->traced_shape(options.degree)) {}

SharedDirections::SharedDirections(const BakeOptions& options, const TransferShape& traced)
    : SharedDirections(make_directions(options.sampler, options.directions, options.seed), traced.columns(),
                       [&](const Eigen::Vector3f& d, float* out) {
                         evaluate_basis(traced.function_degree(), d.x(), d.y(), d.z(), out);
                       }) {
  degree_ = options.degree;
  about_normal_ = options.sampler == Sampler::kCosine;
  weighs_cosine_ = traced.holds_cosine;
}

SharedDirections::SharedDirections(std::vector<Eigen::Vector3f> directions, std::size_t columns, const Row& row)
    : directions_(std::move(directions)),
      row_length_(padded_row(columns)),
      values_(directions_.size() * row_length_, 0.0F),
      components_(3 * directions_.size()) {
  for (std::size_t j = 0; j < directions_.size(); ++j) {
    row(directions_[j], values_.data() + j * row_length_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      components_[axis * directions_.size() + j] = directions_[j][axis];
    }
  }
}

void SharedDirections::cosines_with(const Eigen::Vector3f& normal, float* out) const {
  cosines(components_.data(), directions_.size(), normal.x(), normal.y(), normal.z(), out);
}

void SharedDirections::sum(const std::vector<std::uint32_t>& chosen, std::size_t count, const float* weights,
                           float* result) const {
  sum_rows(values_.data(), row_length_, chosen.data(), count, weights, result);
}

void SharedDirections::turn(const Eigen::Matrix3f& frame, float* row) const {
  rotate_function<float>(degree_, frame, row, row);
}

// This order of operations keeps every bit of DU for an open vertex.
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer) {
  const float fraction = seen.fraction();
  auto own = as_array(transfer, count);
  own = fraction * own + (as_array(seen.visible.data(), count) - fraction * as_array(seen.all.data(), count));
}

Gatherer::Gatherer(const Mesh& mesh, const std::vector<RayStart>& starts, const Tracer& tracer,
                   const SharedDirections& directions)
    : mesh_(mesh),
      starts_(starts),
      tracer_(tracer),
      directions_(directions),
      rays_(directions.size()),
      chosen_(directions.size()),
      visible_(directions.size()),
      blocked_(directions.size()),
      weights_(directions.size(), 1.0F / static_cast<float>(directions.size())),
      heights_(directions.size()) {}

// All points of space have the same directions, weights and sum of all.
void Gatherer::begin_in_space() {
  constexpr float kSphere = 4.0F * std::numbers::pi_v<float>;
  std::fill(weights_.begin(), weights_.end(), kSphere / static_cast<float>(directions_.size()));
  std::iota(chosen_.begin(), chosen_.end(), 0U);
  for (std::uint32_t j = 0; j < directions_.size(); ++j)
    rays_[j].aim(Eigen::Vector3f::Zero(), directions_.direction(j));
  directions_.sum(chosen_, chosen_.size(), weights_.data(), sphere_.data());
  below_ = 0;
  in_space_ = true;
}

std::size_t Gatherer::aim_in_space(const Eigen::Vector3f& origin) {
  if (!in_space_) begin_in_space();
  const std::array<float, 4> front = {origin.x(), origin.y(), origin.z(), 0.0F};  // one store
  static_assert(offsetof(ShadowRay, origin) == 0 && offsetof(ShadowRay, near) == 3 * sizeof(float));
  for (ShadowRay& ray : rays_) {
    std::memcpy(static_cast<void*>(&ray), front.data(), sizeof front);
    ray.far = std::numeric_limits<float>::infinity();
  }
  return rays_.size();
}

void Gatherer::weigh_hemisphere(std::size_t vertex) {
  const Eigen::Vector3f& normal = mesh_.normals[vertex];
  const Eigen::Vector3f& geometric_normal = mesh_.geometric_normals[vertex];
  if (directions_.about_normal()) {
    frame_ = frame_about(normal);
    directions_.cosines_with(frame_.transpose() * geometric_normal, heights_.data());
  } else {
    directions_.cosines_with(geometric_normal, heights_.data());
    const float whole = 4.0F / static_cast<float>(directions_.size());
    if (directions_.weighs_cosine()) {
      directions_.cosines_with(normal * whole, weights_.data());
    } else {
      std::transform(heights_.begin(), heights_.end(), weights_.begin(),
                     [&](float height) { return height > 0.0F ? std::numbers::pi_v<float> * whole : 0.0F; });
    }
  }
}

std::size_t Gatherer::aim(std::size_t receiver) {
  if (starts_[receiver].in_space) return aim_in_space(starts_[receiver].origin);
  in_space_ = false;
  weigh_hemisphere(receiver);
  std::size_t traced = 0;
  below_ = 0;
  for (std::uint32_t j = 0; j < directions_.size(); ++j) {
    // The loop has no branches, because no branch predictor could follow them.
    const std::size_t counts = weights_[j] > 0.0F ? 1U : 0U;
    const std::size_t is_above = heights_[j] > 0.0F ? 1U : 0U;
    chosen_[traced] = j;
    blocked_[below_] = j;
    traced += counts & is_above;
    below_ += counts & (is_above ^ 1U);
  }
  for (std::size_t i = 0; i < traced; ++i) rays_[i].aim(starts_[receiver].origin, towards(chosen_[i]));
  return traced;
}

// Most rays see the sky: the sum of what is blocked is the shorter one. All weights are the same, so that it does not
// matter which directions stand in visible_.
const Gathered& Gatherer::gathered_in_space() {
  std::size_t blocked = 0;
  for (std::uint32_t i = 0; i < rays_.size(); ++i) {
    blocked_[blocked] = i;
    blocked += rays_[i].blocked() ? 1U : 0U;
  }
  visible_count_ = rays_.size() - blocked;
  blocked_count_ = blocked;
  directions_.sum(blocked_, blocked, weights_.data(), result_.visible.data());
  result_.all = sphere_;
  auto seen = as_array(result_.visible.data(), directions_.row_length());
  seen = as_array(sphere_.data(), directions_.row_length()) - seen;
  return result_;
}

const Gathered& Gatherer::gather(std::size_t vertex) {
  closest_known_ = Known::kNothing;
  const std::size_t traced = aim(vertex);
  for (std::size_t first = 0; first < traced; first += kStreamRays) {
    tracer_.occluded({rays_.data() + first, std::min(kStreamRays, traced - first)});
  }
  if (in_space_) return gathered_in_space();
  std::size_t visible = 0;
  std::size_t blocked = below_;
  for (std::size_t i = 0; i < traced; ++i) {
    const std::size_t hit = rays_[i].blocked() ? 1U : 0U;
    visible_[visible] = chosen_[i];
    blocked_[blocked] = chosen_[i];
    visible += hit ^ 1U;
    blocked += hit;
  }
  visible_count_ = visible;
  blocked_count_ = blocked;
  directions_.sum(visible_, visible, weights_.data(), result_.visible.data());
  directions_.sum(blocked_, blocked, weights_.data(), result_.all.data());
  if (directions_.about_normal()) {
    directions_.turn(frame_, result_.visible.data());
    directions_.turn(frame_, result_.all.data());
  }
  as_array(result_.all.data(), directions_.row_length()) += as_array(result_.visible.data(), directions_.row_length());
  return result_;
}

const std::vector<BlockedRay>& Gatherer::closest_hits() {
  find_closest(Known::kFaces);
  return closest_;
}

void Gatherer::find_closest(Known what) {
  if (closest_known_ >= what) return;
  closest_known_ = what;
  closest_.clear();
  double whole = 0.0;
  for (std::size_t i = 0; i < visible_count_; ++i) whole += static_cast<double>(weights_[visible_[i]]);
  for (std::size_t i = 0; i < blocked_count_; ++i) whole += static_cast<double>(weights_[blocked_[i]]);
  along_.clear();
  for (std::size_t i = below_; i < blocked_count_; ++i) along_.push_back(towards(blocked_[i]));
  hits_.resize(along_.size());
  const Eigen::Vector3f origin = rays_.front().origin;  // one for all
  const std::vector<Eigen::Vector3f> origins(along_.size(), origin);
  what == Known::kFaces ? tracer_.intersect(origins, along_, hits_) : tracer_.meet(origins, along_, hits_);
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    closest_.push_back({along_[i], hits_[i], static_cast<double>(weights_[blocked_[below_ + i]]) / whole});
  }
}

Sight Gatherer::sight(std::size_t vertex, float visible) {
  Sight sight{visible};
  if (static_cast<double>(visible) >= kNearlyDark) return sight;
  double backs = 0.0;
  double near = 0.0;
  auto above = static_cast<double>(result_.fraction());  // the horizon
  find_closest(Known::kDistances);
  for (const BlockedRay& ray : closest_) {
    above += ray.part;
    if (ray.hit.face == Hit::kNothing) continue;
    if (ray.hit.from_behind) backs += ray.part;
    if (ray.hit.distance < kNearReach * starts_[vertex].reach) near += ray.part;
  }
  if (!(above > 0.0)) return sight;
  const double dark = 1.0 - ramp(static_cast<double>(visible), kLittleSeen);
  sight.buried = static_cast<float>(dark * ramp(backs / above, kManyBacks));
  sight.covered = static_cast<float>(dark * ramp(near / above, kMostNear));
  return sight;
}

std::vector<ShadowRay> Gatherer::rays(std::size_t vertex) {
  const std::size_t traced = aim(vertex);
  return {rays_.begin(), rays_.begin() + traced};
}

void gather_all(const Mesh& mesh, const std::vector<RayStart>& starts, const Tracer& tracer,
                const SharedDirections& directions, const std::vector<std::uint32_t>& vertices,
                const std::function<void(Gatherer&, const Gathered&, std::size_t)>& each) {
  tbb::enumerable_thread_specific<Gatherer> gatherers([&] { return Gatherer(mesh, starts, tracer, directions); });
  for_vertices(vertices.size(), [&](std::size_t i) {
    output::check_interrupt();
    Gatherer& gatherer = gatherers.local();
    each(gatherer, gatherer.gather(vertices[i]), i);
  });
}

}  // namespace sh::prt
