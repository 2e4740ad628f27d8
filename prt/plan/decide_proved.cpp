// Decisions that are exact or proved: open vertices, one channel, coefficients that the lights do not have, and the type
// of the stored numbers; and room for what a bake measures: clusters.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "prt/bake/gray.hpp"
#include "prt/plan/draft.hpp"
#include "prt/plan/open_vertices.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

constexpr double kExactAngle = 1e-5;  // radians: a lune error below single precision
constexpr double kWidestAngle = 0.1;

// Counts of clusters that a plan may choose from, bytes rising.
constexpr std::array<ClusterCounts, 5> kLadder = {{{32, 4}, {64, 8}, {128, 8}, {256, 8}, {256, 16}}};

double norm_of_light(const TurningLight& light) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double squares = 0.0;
    for (int l = 0; l <= light.coefficients().degree; ++l) squares += std::pow(light.band_norm(c, l), 2);
    largest = std::max(largest, std::sqrt(squares));
  }
  return largest;
}

// The relative error of a lune of this angle. It and its inverse convert between angles and errors.
double error_of_angle(const Draft& draft, double angle) {
  return draft.gain() * static_cast<double>(draft.albedo) * norm_of_light(*draft.light) * lune_error(angle) /
         draft.plan.reference;
}

double angle_within(const Draft& draft, double error) {
  return std::clamp(std::pow(error / error_of_angle(draft, 1.0), 2.0 / 3.0), kExactAngle, kWidestAngle);
}

double widest_angle(const Draft& draft) {
  double widest = 0.0;
  for (std::size_t v = 0; v < draft.starts.size(); ++v) {
    if (draft.plan.open[v] != 0 && draft.keeps(v)) {
      const Eigen::Vector3f apart = draft.scene.mesh.normals[v] - draft.scene.mesh.geometric_normals[v];
      widest = std::max(widest, 1.01 * static_cast<double>(apart.norm()));  // chord to angle, up to kWidestAngle
    }
  }
  return widest;
}

// The largest error that an element makes in each column of the rows, (bands^2 of the requested degree).
std::vector<double> storage_errors(const Draft& draft, Element element) {
  std::vector<double> errors(draft.light->coefficients().bands_squared(), 0.0);
  const Storage& storage = draft.plan.storage;
  for (std::size_t i = 0; i < draft.count(); ++i) {
    if (storage.kept.empty() || std::binary_search(storage.kept.begin(), storage.kept.end(), i)) {
      errors[i] = encoding_error(element, static_cast<double>(draft.plan.largest[i]));
    }
  }
  return errors;
}

}  // namespace

void decide_analytic(Draft& draft) {
  if (!draft.bake.kind->traces_rays()) {
    draft.decide("analytic", "all vertices", "the scene requests unshadowed transfer");
    return;
  }
  constexpr double kPart = 0.02;
  const bool may_differ = draft.light && !draft.bake.kind->is_glossy();
  const double angle = may_differ ? angle_within(draft, draft.share(kPart)) : kExactAngle;
  draft.plan.open = open_vertices(draft.scene.mesh, draft.starts, angle);
  const std::size_t open = draft.receivers() - draft.traced();
  const double widest = widest_angle(draft);
  const bool exact = widest <= 1.01 * kExactAngle;
  draft.decide("analytic", fmt::format("{} of {} vertices", open, draft.receivers()),
               exact ? "nothing lies above their horizon: transfer in closed form, no rays"
                     : fmt::format("nothing lies above their horizon: transfer in closed form, no rays; normals differ "
                                   "by up to {:.2g} degrees from the surface's",
                                   widest * 180.0 / 3.14159265358979),
               exact ? 0.0 : error_of_angle(draft, widest), exact ? "exact" : "bound");
}

void decide_channels(Draft& draft) {
  if (!draft.shape().holds_albedo) {
    const bool is_glossy = draft.bake.kind->is_glossy();
    draft.decide("channels", "one",
                 is_glossy ? "visibility holds no albedo" : "transfer without bounces holds no albedo");
    return;
  }
  const Mesh& mesh = draft.scene.mesh;
  const bool gray = is_gray(mesh.albedo) && is_gray(mesh.mirror);
  draft.plan.storage.one_channel = gray;
  draft.decide("channels", gray ? "one for all three" : "three",
               gray ? "every albedo and mirror is gray" : "surfaces are colored, and bounces carry the color");
}

void decide_symmetry(Draft& draft) {
  std::vector<std::uint32_t> kept = draft.light->needed();
  std::erase_if(kept, [&](std::uint32_t i) { return i >= draft.count(); });
  const std::size_t count = kept.size();
  const std::string turns(name_of(draft.options.turns));
  if (count == 0 || count == draft.count()) {
    draft.decide("symmetry", fmt::format("all {} coefficients", draft.count()),
                 fmt::format("the lights, turned ({}), need all of them", turns));
    return;
  }
  draft.plan.storage.kept = std::move(kept);
  draft.decide(
      "symmetry", fmt::format("{} of {} coefficients", count, draft.count()),
      fmt::format("no rotation ({}) gives the lights other coefficients; lights that need others are refused", turns));
}

void decide_storage(Draft& draft) {
  constexpr double kSampling = 1.01;  // sums over directions may exceed the exact bound
  constexpr double kPart = 0.5;
  draft.plan.largest.resize(draft.count());
  for (int l = 0; l <= draft.shape().function_degree(); ++l) {
    std::fill(draft.plan.largest.begin() + l * l, draft.plan.largest.begin() + (l + 1) * (l + 1),
              static_cast<float>(kSampling * draft.band_bound(l)));
  }
  const bool proves = !draft.bake.kind->is_glossy();  // else numbers meet light and lobes
  for (const Element element : {Element::kByte, Element::kHalf}) {
    const double error = proves ? draft.error_of(storage_errors(draft, element)) : measured_error_of(draft, element);
    if (error <= draft.share(kPart)) {
      draft.plan.storage.element = element;
      const bool byte = element == Element::kByte;
      draft.decide("storage", byte ? "8 bits with a scale a coefficient" : "half",
                   fmt::format("{}, {}", byte ? "half a scale for each number" : "2^-11 of each number",
                               proves ? "bounded by what transfer can be, times the lights" : "at most"),
                   error, proves ? "bound" : "measured");
      return;
    }
  }
  draft.decide("storage", "single", "the budget leaves no room for half");
}

void decide_clusters(Draft& draft) {
  constexpr double kPart = 0.25;
  std::vector<ClusterCounts>& counts = draft.plan.clusters;
  if (draft.asked.compress.clusters > 0) counts = {draft.asked.compress};
  if (draft.asked.compress_by_plan) counts.assign(kLadder.begin(), kLadder.end());
  if (counts.empty()) return;
  const auto bytes = [&](ClusterCounts some) { return draft.stored_shape(some).stored_bytes(draft.receivers()); };
  const std::size_t rows = bytes({});
  const std::size_t least = bytes(counts.front());
  std::erase_if(counts, [&](ClusterCounts some) { return bytes(some) >= rows; });
  const double room = draft.share(kPart);
  if (counts.empty() || !(room > 0.0)) {
    counts.clear();
    draft.bake.compress = {};
    draft.decide(
        kClustersDecision, "rows as they are",
        least < rows ? "the budget leaves no room" : fmt::format("clusters take {} bytes, rows {}", least, rows));
    return;
  }
  draft.clusters = counts.back();
  draft.room_for_clusters = room;
  const std::string most = fmt::format("{} of {} vectors", draft.clusters.clusters, draft.clusters.vectors);
  draft.decide(kClustersDecision, counts.size() == 1 ? most : "at most " + most,
               counts.size() == 1 ? "as long as the bake measures no larger error; else rows as they are"
                                  : "the least for which the bake measures no larger error; else rows as they are",
               room, "measured");
}

}  // namespace sh::prt
