#include "prt/medium/anisotropic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kTables = 3;  // the sum, the last order, the next one

// The orders of one albedo: (voxels, result bands^2, bands^2) numbers.
class Orders {
 public:
  Orders(const Scattering& scattering, double albedo, double anisotropy, int degree)
      : scattering_(scattering),
        voxels_(scattering.density().size()),
        degree_(degree),
        count_(coefficient_count(degree)),
        size_(count_ * count_),
        seen_(voxels_ * count_) {
    for (int l = 0; l <= degree; ++l) {
      factors_.insert(factors_.end(), static_cast<std::size_t>(2 * l + 1),
                      static_cast<float>(albedo * std::pow(anisotropy, l)));
    }
  }

  // The first order: what scatters of the light itself.
  [[nodiscard]] std::vector<float> first() { return gathered({}, "direct light"); }
  [[nodiscard]] std::vector<float> next(const std::vector<float>& order, int number) {
    return gathered(order, fmt::format("order {}", number));
  }

 private:
  // What reaches the voxels of an order, or of the light if there is none, scattered once.
  std::vector<float> gathered(const std::vector<float>& order, const std::string& what) {
    std::vector<float> out(voxels_ * size_, 0.0F);
    output::Progress progress(what, scattering_.directions().size());
    for (std::size_t j = 0; j < scattering_.directions().size(); ++j) {
      const auto& [direction, weight] = scattering_.directions()[j];
      std::array<float, coefficient_count(kMaxDegree)> basis{};
      const Eigen::Vector3f s = direction.cast<float>();
      evaluate_basis(degree_, s.x(), s.y(), s.z(), basis.data());
      if (!order.empty()) look(order, basis.data());
      const auto share = static_cast<float>(4.0 * std::numbers::pi * weight);
      for_chunks(voxels_, [&](std::size_t chunk) {
        const VertexRange range = chunk_range(chunk, voxels_);
        std::vector<float> light(count_);
        for (std::size_t v = range.first; v < range.last; ++v) {
          reach(j, v, order.empty() ? basis.data() : nullptr, light.data());
          for (std::size_t r = 0; r < count_; ++r) {
            as_array(&out[v * size_ + r * count_], count_) +=
                (share * factors_[r] * basis[r]) * as_array(light.data(), count_);
          }
        }
      });
      progress.advance();
    }
    progress.finish();
    return out;
  }

  // seen_ = the order, seen in the direction of these basis values.
  void look(const std::vector<float>& order, const float* basis) {
    for_vertices(voxels_, [&](std::size_t v) {
      auto row = as_array(&seen_[v * count_], count_);
      row.setZero();
      for (std::size_t r = 0; r < count_; ++r) row += basis[r] * as_array(&order[v * size_ + r * count_], count_);
    });
  }

  // light (bands^2) = what reaches a voxel: of the light behind, whose basis values these are, or of seen_.
  void reach(std::size_t j, std::size_t voxel, const float* basis, float* light) const {
    const VoxelPath& path = scattering_.paths()[j];
    const Counts place = scattering_.density().place(voxel);
    auto sum = as_array(light, count_);
    if (basis != nullptr) {
      sum = static_cast<float>(transmittance(path, scattering_.padded(), place)) * as_array(basis, count_);
      return;
    }
    sum.setZero();
    for_sources(path, scattering_.padded(), place, static_cast<std::uint32_t>(voxel),
                [&](std::uint32_t from, double weight) {
                  sum += static_cast<float>(weight) * as_array(&seen_[from * count_], count_);
                });
  }

  const Scattering& scattering_;
  std::size_t voxels_;
  int degree_;
  std::size_t count_;
  std::size_t size_;
  std::vector<float> factors_;  // (result bands^2)
  std::vector<float> seen_;     // (voxels, bands^2)
};

double largest_of(const std::vector<float>& numbers) {
  return static_cast<double>(as_array(numbers).abs().maxCoeff<Eigen::PropagateNumbers>());
}

// Sums the orders of one albedo.
std::vector<float> sum_orders(Orders orders, const BounceOptions& options, const std::string& name,
                              BounceReport& report) {
  constexpr int kBeforeJudgment = 12;
  constexpr double kMostOrders = 400.0;
  std::vector<float> order = orders.first();
  std::vector<float> sum = order;
  double before = largest_of(order);
  for (int number = 2;; ++number) {
    order = orders.next(order, number);
    as_array(sum) += as_array(order);
    const double now = largest_of(order);
    const double rate = before > 0.0 ? now / before : 0.0;
    before = now;
    const double largest = largest_of(sum);
    const double left = rate < 1.0 ? now * rate / (1.0 - rate) : std::numeric_limits<double>::infinity();
    const bool is_done = now == 0.0 || left <= options.tolerance * largest;
    const bool is_late = number > options.most_applications || std::chrono::steady_clock::now() >= options.deadline;
    const double more = rate < 1.0 ? std::log(options.tolerance * largest / left) / std::log(rate) : kMostOrders;
    if (is_done || is_late) {
      report.applications = std::max(report.applications, number - 1);
      report.residual = std::max(report.residual, left);
      report.largest = std::max(report.largest, largest);
      report.spectral_bound = std::max(report.spectral_bound, rate);
      return sum;
    }
    if (number >= kBeforeJudgment && number + more > kMostOrders) {
      throw std::runtime_error(fmt::format(
          "{}: an order of scattering is {:.4f} of the one before: it is too thick for its albedo; expected a lower "
          "extinction or albedo, or an isotropic phase function",
          name, rate));
    }
  }
}

}  // namespace

AnisotropicLight scatter_anisotropically(const Scattering& scattering, const Medium& medium, int degree,
                                         const BounceOptions& options, const std::string& name) {
  const std::size_t voxels = scattering.density().size();
  const std::size_t size = coefficient_count(degree) * coefficient_count(degree);
  AnisotropicLight light{std::vector<float>(voxels * 3 * size), {}};
  light.report.solver = "series";
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const Eigen::Index same = c > 0 && medium.albedo[c] == medium.albedo[c - 1] ? c - 1 : c;
    std::vector<float> sum;
    if (same == c) {
      sum = sum_orders(Orders(scattering, static_cast<double>(medium.albedo[c]), medium.anisotropy, degree), options,
                       name, light.report);
    }
    for (std::size_t v = 0; v < voxels; ++v) {
      float* to = &light.rows[(3 * v + channel) * size];
      const float* from = same == c ? &sum[v * size] : to - size;
      std::copy_n(from, size, to);
    }
  }
  return light;
}

std::size_t anisotropic_bytes(std::size_t voxels, int degree) {
  const std::size_t count = coefficient_count(degree);
  return voxels * count * sizeof(float) * (kTables * count + 1 + 3 * count);
}

}  // namespace sh::prt
