#include "prt/bake/mirror_light.hpp"

#include <algorithm>
#include <array>

#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

const std::vector<BlockedRay>& MirrorLight::follow(const Eigen::Vector3f& origin,
                                                   const std::vector<BlockedRay>& closest) {
  legs_.clear();
  for (std::uint32_t i = 0; i < closest.size(); ++i) legs_.push_back({origin, closest[i].direction, closest[i].hit, i});
  paths_.follow(legs_);
  met_ = closest;
  sky_.clear();
  cut_ = 0.0;
  for (const Leg& leg : legs_) {
    const double part = closest[leg.ray].part * static_cast<double>(leg.throughput.x());
    cut_ += leg.is_cut ? part : 0.0;
    if (leg.mirrors > 0) (leg.hit.face == Hit::kNothing ? sky_ : met_).push_back({leg.direction, leg.hit, part});
  }
  return met_;
}

float MirrorLight::add_sky(int degree, float* transfer) const {
  const auto count = coefficient_count(degree);
  std::array<float, kMaxRow> values{};
  double whole = 0.0;
  for (const BlockedRay& ray : sky_) {
    evaluate_basis(degree, ray.direction.x(), ray.direction.y(), ray.direction.z(), values.data());
    const auto part = static_cast<float>(ray.part);
    std::transform(values.data(), values.data() + count, transfer, transfer,
                   [part](float value, float sum) { return sum + part * value; });
    whole += ray.part;
  }
  return static_cast<float>(whole);
}

}  // namespace sh::prt
