#include "prt/bake/glossy_bounces.hpp"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/gray.hpp"
#include "prt/basis.hpp"
#include "prt/material/lobe.hpp"
#include "prt/material/reflected.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/rays/row_sums.hpp"
#include "prt/transfer/visibility.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

constexpr int kBouncesBeforeJudgment = 8;
constexpr double kMostBounces = 300.0;

constexpr std::size_t kRaysAtOnce = 64;
constexpr std::size_t kMostRow = padded_row(3 * coefficient_count(kHighestProduct));

struct BlockedAt {
  Eigen::Vector3f direction;
  Hit hit;
};

using Weights = std::array<float, coefficient_count(kHighestProduct)>;

template <class Factor>
Weights weights_about(int degree, const Eigen::Vector3f& direction, const Factor& factor) {
  Weights values;
  zonal_about(degree, direction, factor, values.data());
  return values;
}

// sum (count) += part times the values.
void add(const float* values, std::size_t count, float part, float* sum) {
  const auto length = static_cast<Eigen::Index>(count);
  Eigen::Map<Eigen::ArrayXf>(sum, length) += part * Eigen::Map<const Eigen::ArrayXf>(values, length);
}

std::size_t channels_of(const Mesh& mesh) {
  return is_gray(mesh.albedo) && is_gray(mesh.specular) && is_gray(mesh.brdfs) ? 1 : 3;
}

class Bounces {
 public:
  explicit Bounces(BakeRun& run)
      : run_(run),
        mesh_(run.scene.mesh),
        degree_(run.transfer.degree()),
        count_(coefficient_count(degree_)),
        channels_(channels_of(mesh_)),
        vertices_(mesh_.positions.size()),
        row_(padded_row(channels_ * count_)),
        size_(count_ * row_),
        fill_(closed_vertices(mesh_, run.found->sight)),
        hits_(vertices_),
        tracers_(
            [&run] { return Gatherer(run.scene.mesh, run.rays->starts, run.rays->tracer, run.rays->directions); }) {
    for (const float exponent : mesh_.exponent) {
      for (int l = 0; l <= degree_; ++l) {
        lobes_.push_back(static_cast<float>(phong_factor(l, static_cast<double>(exponent))));
      }
    }
    in_order_.resize(std::max(kRaysAtOnce, count_));
    std::iota(in_order_.begin(), in_order_.end(), 0U);
  }

  void solve() {
    take_direct();
    trace();
    std::vector<float> sum(term_.size(), 0.0F);
    BounceReport& report = run_.transfer.bounces;
    report = {.solver = "series"};
    for (double before = largest_of(term_);;) {
      next_.resize(term_.size());
      bounce();
      term_.swap(next_);
      ++report.applications;
      for_chunks(vertices_, [&](std::size_t chunk) {
        const VertexRange range = chunk_range(chunk, vertices_);
        const std::size_t first = range.first * size_;
        add(&term_[first], range.last * size_ - first, 1.0F, &sum[first]);
      });
      const double now = largest_of(term_);
      report.spectral_bound = before > 0.0 ? now / before : 0.0;
      report.residual = now > 0.0 ? now * report.spectral_bound / std::max(1.0 - report.spectral_bound, 1e-9) : 0.0;
      if (is_done(report, now)) break;
      before = now;
    }
    report.largest = largest_of(sum);
    take_sum(sum);
  }

 private:
  // term = G: column j is the visibility times Y_j.
  void take_direct() {
    term_.assign(vertices_ * size_, 0.0F);
    std::vector<float> columns(vertices_ * 3 * count_);
    for (std::size_t first = 0; first < count_; first += 3) {
      const std::size_t some = std::min<std::size_t>(3, count_ - first);
      std::vector<float> lights(3 * count_, 0.0F);
      for (std::size_t k = 0; k < some; ++k) lights[k * count_ + first + k] = 1.0F;
      times_visibility(degree_, vertices_, run_.transfer.coefficients.data(), prepared_light(degree_, lights.data()),
                       columns.data());
      for_vertices(vertices_, [&](std::size_t v) {
        for (std::size_t i = 0; i < some * count_; ++i) {
          for (std::size_t c = 0; c < channels_; ++c) {
            term_[v * size_ + i % count_ * row_ + c * count_ + first + i / count_] = columns[v * 3 * count_ + i];
          }
        }
      });
    }
  }

  // The blocked rays of a vertex that meet fronts.
  std::vector<BlockedAt> blocked(std::size_t vertex) {
    Gatherer& gatherer = tracers_.local();
    gatherer.gather(vertex);
    std::vector<BlockedAt> rays;
    for (const BlockedRay& ray : gatherer.closest_hits()) {
      if (ray.hit.face == Hit::kNothing) continue;
      if (face_normal(mesh_.positions, mesh_.faces[ray.hit.face]).dot(ray.direction) >= 0.0F) continue;
      rays.push_back({ray.direction, ray.hit});
    }
    return rays;
  }

  // Keeps as many hits as the memory for bounces allows; the others are traced again for each bounce.
  void trace() {
    output::Progress progress("hits", vertices_);
    std::atomic<std::size_t> bytes{0};
    kept_.assign(vertices_, 0);
    for_vertices(vertices_, [&](std::size_t v) {
      output::check_interrupt();
      if (is_open(v)) {
        kept_[v] = 1;
      } else if (bytes < run_.settings.bounce_memory) {
        hits_[v] = blocked(v);
        kept_[v] = 1;
        bytes += hits_[v].size() * sizeof(BlockedAt);
      }
      progress.advance();
    });
    progress.finish();
  }

  [[nodiscard]] bool is_open(std::size_t vertex) const { return !run_.open.empty() && run_.open[vertex] != 0; }

  // row (row_) += weights times the matrix of a vertex, each channel times its part of the color.
  void add_weighed(const float* weights, std::size_t vertex, const Eigen::Vector3f& color, float* row) const {
    alignas(64) std::array<float, kMostRow> sums;
    sum_rows(term_.data() + vertex * size_, row_, in_order_.data(), count_, weights, sums.data());
    for (std::size_t c = 0; c < channels_; ++c) {
      add(sums.data() + c * count_, count_, color[static_cast<Eigen::Index>(c)], row + c * count_);
    }
  }

  // What leaves each vertex diffusely, (vertices, row_).
  [[nodiscard]] std::vector<float> diffuse() const {
    std::vector<float> rows(vertices_ * row_, 0.0F);
    for_vertices(vertices_, [&](std::size_t v) {
      const Weights cosine = weights_about(degree_, mesh_.normals[v], [](int l) { return phong_factor(l, 1.0); });
      add_weighed(cosine.data(), v, mesh_.albedo[v], rows.data() + v * row_);
    });
    return rows;
  }

  // Adds what leaves a hit against the ray to `row` (row_).
  void add_exit(const BlockedAt& ray, const std::vector<float>& diffuse_rows, float* row) const {
    const Face& face = mesh_.faces[ray.hit.face];
    const std::array<float, 3> parts = {1.0F - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t q = face[k];
      if (const BrdfTable brdf = mesh_.brdf_of(q)) {
        for_reflected_lobes(brdf, mesh_.albedo[q], degree_, mesh_.normals[q], -ray.direction,
                            [&](const Eigen::Vector3f& color, const float* weights) {
                              add_weighed(weights, q, parts[k] * color, row);
                            });
        continue;
      }
      add(&diffuse_rows[q * row_], row_, parts[k], row);
      if (mesh_.specular.empty() || mesh_.specular[q].isZero(0.0F)) continue;
      const Eigen::Vector3f about = mirrored(ray.direction, mesh_.normals[q]);
      const float* factors = &lobes_[q * (degree_ + 1)];
      const Weights lobe = weights_about(degree_, about, [factors](int l) { return factors[l]; });
      add_weighed(lobe.data(), q, parts[k] * mesh_.specular[q], row);
    }
  }

  // The matrix of a vertex whose rays meet fronts here: sum over rays of arriving times leaving.
  void collect(const std::vector<BlockedAt>& rays, const std::vector<float>& diffuse_rows, float* out) const {
    const auto weight = static_cast<float>(4.0 * std::numbers::pi / static_cast<double>(run_.rays->directions.size()));
    std::fill_n(out, size_, 0.0F);
    std::vector<float> arriving(count_ * kRaysAtOnce);
    std::vector<float> leaving(kRaysAtOnce * row_);
    std::vector<float> part(row_);
    for (std::size_t first = 0; first < rays.size(); first += kRaysAtOnce) {
      const std::size_t some = std::min(kRaysAtOnce, rays.size() - first);
      std::fill(leaving.begin(), leaving.end(), 0.0F);
      for (std::size_t j = 0; j < some; ++j) {
        const BlockedAt& ray = rays[first + j];
        const Weights basis = weights_about(degree_, ray.direction, [&](int) { return weight; });
        for (std::size_t i = 0; i < count_; ++i) arriving[i * kRaysAtOnce + j] = basis[i];
        add_exit(ray, diffuse_rows, leaving.data() + j * row_);
      }
      for (std::size_t i = 0; i < count_; ++i) {
        sum_rows(leaving.data(), row_, in_order_.data(), some, &arriving[i * kRaysAtOnce], part.data());
        add(part.data(), row_, 1.0F, out + i * row_);
      }
    }
  }

  // next = K term.
  void bounce() {
    const std::vector<float> diffuse_rows = diffuse();
    output::Progress progress(fmt::format("bounce {}", run_.transfer.bounces.applications + 1), vertices_);
    for_vertices(vertices_, [&](std::size_t v) {
      output::check_interrupt();
      const std::vector<BlockedAt> again = kept_[v] != 0 ? std::vector<BlockedAt>() : blocked(v);
      collect(kept_[v] != 0 ? hits_[v] : again, diffuse_rows, next_.data() + v * size_);
      progress.advance();
    });
    progress.finish();
    fill_.apply(next_.data(), size_, size_);
  }

  [[nodiscard]] double largest_of(const std::vector<float>& all) const {
    std::vector<float> largest(chunk_count(vertices_), 0.0F);
    for_chunks(vertices_, [&](std::size_t chunk) {
      const VertexRange range = chunk_range(chunk, vertices_);
      for (std::size_t i = range.first * size_; i < range.last * size_; ++i) {
        largest[chunk] = std::max(largest[chunk], std::abs(all[i]));
      }
    });
    return static_cast<double>(*std::max_element(largest.begin(), largest.end()));
  }

  // No number of the direct part is above 1.
  [[nodiscard]] bool is_done(const BounceReport& report, double now) const {
    const BounceOptions& options = run_.scene.bake.bounces;
    const double rate = report.spectral_bound;
    const double enough = options.tolerance;
    if (now == 0.0 || (rate < 1.0 && report.residual <= enough)) return true;
    if (std::chrono::steady_clock::now() >= options.deadline) return true;
    const double left = rate < 1.0 ? std::log(enough / report.residual) / std::log(rate) : kMostBounces;
    if (report.applications >= kBouncesBeforeJudgment && report.applications + left > kMostBounces) {
      throw std::runtime_error(
          fmt::format("{}: its bounces shrink to only {:.4f} of the one before: surfaces that reflect nearly all light "
                      "enclose it; expected lower reflectances or a larger opening",
                      run_.scene.name, rate));
    }
    return false;
  }

  void take_sum(const std::vector<float>& sum) {
    Transfer& transfer = run_.transfer;
    transfer.indirect_shape = transfer.kind->indirect(degree_);
    transfer.indirect_shape.channels = channels_;
    transfer.indirect.resize(vertices_ * transfer.indirect_shape.length());
    for_vertices(vertices_, [&](std::size_t v) {
      float* to = transfer.indirect.data() + v * transfer.indirect_shape.length();
      for (std::size_t c = 0; c < channels_; ++c) {
        for (std::size_t i = 0; i < count_; ++i, to += count_) {
          std::copy_n(sum.data() + v * size_ + i * row_ + c * count_, count_, to);
        }
      }
    });
  }

  BakeRun& run_;
  const Mesh& mesh_;
  int degree_;
  std::size_t count_;  // coefficients: rows, and columns of a channel
  std::size_t channels_;
  std::size_t vertices_;
  std::size_t row_;   // channels x columns, padded
  std::size_t size_;  // numbers of a vertex: count_ rows
  Fill fill_;
  std::vector<float> lobes_;             // (vertices, bands), empty without lobes
  std::vector<std::uint32_t> in_order_;  // 0, 1, 2, ...
  std::vector<float> term_;
  std::vector<float> next_;
  std::vector<std::vector<BlockedAt>> hits_;
  std::vector<std::uint8_t> kept_;
  tbb::enumerable_thread_specific<Gatherer> tracers_;
};

}  // namespace

std::size_t glossy_bounce_bytes(const Mesh& mesh, int degree) {
  constexpr std::size_t kTables = 4;  // the sum, two terms, the result
  const std::size_t count = coefficient_count(degree);
  return kTables * mesh.positions.size() * count * padded_row(channels_of(mesh) * count) * sizeof(float);
}

void require_glossy_bounce_memory(const Scene& scene, double there) {
  const auto needed = static_cast<double>(glossy_bounce_bytes(scene.mesh, scene.bake.degree));
  if (needed <= there) return;
  constexpr double kMiB = 1048576.0;
  throw std::runtime_error(
      fmt::format("{}: its bounces need {:.0f} MiB for a matrix at each of {} vertices, this machine has {:.0f}; "
                  "expected fewer vertices, a lower degree, gray materials, or {}",
                  scene.name, needed / kMiB, scene.mesh.positions.size(), there / kMiB, kGlossyShadowed.word));
}

void add_glossy_bounces(BakeRun& run) { Bounces(run).solve(); }

}  // namespace sh::prt
