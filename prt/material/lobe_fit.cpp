#include "prt/material/lobe_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "prt/material/lobe.hpp"
#include "prt/material/tabulate.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kTableRow = even_count(kMaxDegree);
constexpr double kAlike = 1e-15;                                 // sine^2 of the angle between lobes that are one
constexpr double kNothing = std::numeric_limits<double>::min();  // square of no lobe

// The coefficients with m >= 0 of all views one under another, times the root of the weight of their view.
using Stacked = Eigen::VectorXd;

class Views {
 public:
  explicit Views(int degree) : degree_(degree), count_(static_cast<Eigen::Index>(even_count(degree))) {}

  [[nodiscard]] Stacked part(const float* table, std::size_t part) const {
    return stacked([&](int view, auto row) {
      const float* from = table + (static_cast<std::size_t>(view) * kReflectionParts + part) * kTableRow;
      row = Eigen::Map<const Eigen::VectorXf>(from, count_).cast<double>();
    });
  }

  // The lobe of this exponent about `axis(view)`.
  template <class Axis>
  [[nodiscard]] Stacked lobe(double exponent, const Axis& axis) const {
    return stacked([&](int view, auto row) {
      BasisValues all;
      zonal_about(
          degree_, axis(view), [exponent](int l) { return phong_factor(l, exponent); }, all.data());
      for (int l = 0; l <= degree_; ++l) even_band(row.data(), l) = band(all.data(), l).tail(l + 1);
    });
  }

 private:
  template <class Fill>
  [[nodiscard]] Stacked stacked(const Fill& fill) const {
    Stacked all(kViews * count_);
    for (int view = 0; view < kViews; ++view) {
      const Eigen::Vector3d eye = view_direction(view);
      auto row = all.segment(view * count_, count_);
      fill(view, row);
      row *= std::sqrt(eye.z() * eye.x());  // cosine times solid angle
    }
    return all;
  }

  int degree_;
  Eigen::Index count_;
};

// The two shares, not negative, with the least squares of `target` - first x - second y.
Eigen::Vector2d shares_of(const Stacked& target, const Stacked& first, const Stacked& second) {
  const Eigen::Vector2d squares(first.squaredNorm(), second.squaredNorm());
  const double both = first.dot(second);
  const Eigen::Vector2d sides(first.dot(target), second.dot(target));
  const double determinant = squares.prod() - both * both;
  if (determinant > kAlike * squares.prod()) {
    Eigen::Vector2d free =
        Eigen::Vector2d(squares.y() * sides.x() - both * sides.y(), squares.x() * sides.y() - both * sides.x()) /
        determinant;
    if (free.minCoeff() >= 0.0) return free;
  }
  const Eigen::Vector2d alone = sides.cwiseMax(0.0).cwiseQuotient(squares.cwiseMax(kNothing));
  const Eigen::Vector2d gains = alone.cwiseProduct(sides);  // of squares
  return gains.x() >= gains.y() ? Eigen::Vector2d(alone.x(), 0.0) : Eigen::Vector2d(0.0, alone.y());
}

std::array<Eigen::Vector3f, kReflectionParts> gray_of_parts(const BrdfTable& table) {
  return colors_of_parts(table.is_measured, Eigen::Vector3f::Constant(0.5F));
}

// The sum of the parts as it is seen in each channel, one for a surface model.
std::vector<Stacked> targets_of(const Views& views, const BrdfTable& table) {
  const auto colors = gray_of_parts(table);
  std::vector<Stacked> targets;
  for (Eigen::Index channel = 0; channel < (table.is_measured ? 3 : 1); ++channel) {
    Stacked sum = static_cast<double>(colors[0][channel]) * views.part(table.rows, 0);
    for (std::size_t part = 1; part < kReflectionParts; ++part) {
      sum += static_cast<double>(colors[part][channel]) * views.part(table.rows, part);
    }
    targets.push_back(std::move(sum));
  }
  return targets;
}

// The x in low..high with the least f(x): of some values, then between the neighbors of the best.
template <class Function>
double least(const Function& f, double low, double high) {
  constexpr int kSteps = 56;
  constexpr int kBits = 26;  // half the digits of a double: more show no difference at a minimum
  const double step = (high - low) / kSteps;
  std::pair best(low, f(low));
  for (int i = 1; i <= kSteps; ++i) {
    const double x = low + i * step;
    if (const double value = f(x); value < best.second) best = {x, value};
  }
  const auto found = boost::math::tools::brent_find_minima(f, std::max(low, best.first - step),
                                                           std::min(high, best.first + step), kBits);
  return found.second < best.second ? found.first : best.first;
}

// No more light than arrives, for albedo 1.
void lose_what_is_gained(bool is_measured, LobeFit& fit) {
  double all = 0.0;
  double most = 0.0;
  for (std::size_t part = 0; part < kReflectionParts; ++part) {
    const double one = fit.diffuse[part] + fit.specular[part];
    all += one;
    most = std::max(most, one);
  }
  const double too_much = std::max(1.0, is_measured ? most : all);
  for (std::size_t part = 0; part < kReflectionParts; ++part) {
    fit.diffuse[part] /= too_much;
    fit.specular[part] /= too_much;
  }
}

double error_of(const LobeFit& fit, const BrdfTable& table, const std::vector<Stacked>& targets, const Stacked& diffuse,
                const Stacked& lobe) {
  double left = 0.0;
  double all = 0.0;
  for (std::size_t channel = 0; channel < targets.size(); ++channel) {
    Stacked difference = targets[channel];
    for (std::size_t part = 0; part < kReflectionParts; ++part) {
      const auto color = static_cast<double>(gray_of_parts(table)[part][static_cast<Eigen::Index>(channel)]);
      difference -= color * (fit.diffuse[part] * diffuse + fit.specular[part] * lobe);
    }
    left += difference.squaredNorm();
    all += targets[channel].squaredNorm();
  }
  return all > 0.0 ? std::sqrt(left / all) : 0.0;
}

}  // namespace

LobeFit fit_lobe(const BrdfTable& table, int degree) {
  const Views views(degree);
  const Stacked diffuse = views.lobe(1.0, [](int) { return Eigen::Vector3d(0.0, 0.0, 1.0); });
  const std::vector<Stacked> targets = targets_of(views, table);
  const auto fit_of = [&](double exponent) {
    const Stacked lobe = views.lobe(exponent, [](int view) {
      const Eigen::Vector3d eye = view_direction(view);
      return Eigen::Vector3d(-eye.x(), 0.0, eye.z());
    });
    LobeFit fit{.exponent = std::min(static_cast<float>(exponent), kMaxExponent)};
    for (std::size_t part = 0; part < kReflectionParts; ++part) {
      const Eigen::Vector2d shares = shares_of(views.part(table.rows, part), diffuse, lobe);
      fit.diffuse[part] = shares.x();
      fit.specular[part] = shares.y();
    }
    lose_what_is_gained(table.is_measured, fit);
    fit.error = error_of(fit, table, targets, diffuse, lobe);
    return fit;
  };
  const auto error_at = [&](double log_exponent) { return fit_of(std::expm1(log_exponent)).error; };
  return fit_of(std::expm1(least(error_at, 0.0, std::log1p(static_cast<double>(kMaxExponent)))));
}

}  // namespace sh::prt
