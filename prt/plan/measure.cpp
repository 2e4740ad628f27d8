#include "prt/plan/measure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "prt/bake/gray.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/gather.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr double kEvenPart = 0.5;       // of the probe
constexpr double kRiskOfClosed = 0.05;  // of its light: a closed vertex may be decided differently by other rays
constexpr int kTurnsAboutZ = 24;
constexpr int kTurnsOfAnyAxis = 48;
constexpr std::size_t kTurnsOfSpread = 4;
constexpr std::uint32_t kReferenceSeed = 0x5EED;
constexpr std::size_t kMostSources = 1;  // traced for the fill of a vertex, on average

// Even turns about z, or turns that fill all rotations: axes of a spherical Fibonacci set, each with its own angle.
std::vector<LightCoefficients> turns_of(const LightCoefficients& light, LightTurns turns) {
  std::vector<LightCoefficients> lights = {light};
  const int count = turns == LightTurns::kNone ? 1 : turns == LightTurns::kAboutZ ? kTurnsAboutZ : kTurnsOfAnyAxis;
  constexpr double kGolden = 222.49223594996214;  // degrees
  for (int k = 1; k < count; ++k) {
    const double z = turns == LightTurns::kAny ? 1.0 - 2.0 * (k + 0.5) / count : 1.0;
    const double azimuth = kGolden * k * std::acos(-1.0) / 180.0;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const Eigen::Vector3d axis(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
    const double angle = turns == LightTurns::kAny ? std::fmod(137.50776405003785 * k, 360.0) : 360.0 * k / count;
    lights.push_back(turned(light, rotation_about(axis, angle)));
  }
  return lights;
}

// The radiance of a channel: the albedo, unless the numbers hold it, times numbers times light.
double radiance_of(const float* row, const TransferShape& shape, const LightCoefficients& light, std::size_t channel,
                   const Eigen::Vector3f& albedo) {
  const float* numbers = row + (shape.channels == 1 ? 0 : channel * shape.count());
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.count(); ++i) sum += static_cast<double>(numbers[i]) * light.at(channel, i);
  return shape.holds_albedo ? sum : sum * static_cast<double>(albedo[static_cast<Eigen::Index>(channel)]);
}

}  // namespace

Measurement::Measurement(const Scene& scene, const LightCoefficients& light, LightTurns turns, double unit,
                         const std::string& instruction_set)
    : scene_(scene), unit_(unit), lights_(turns_of(light, turns)) {
  const TurningLight turning(light, turns);
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (int l = 0; l <= light.degree; ++l) band_norms_[c].push_back(turning.band_norm(c, l));
  }
  if (has_colored_mirrors(scene.mesh)) {
    for (int c = 0; c < 3; ++c) {
      rehearsals_.push_back(std::make_unique<Rehearsal>(in_gray(scene.mesh, c), scene.bake, instruction_set));
    }
  } else {
    rehearsals_.push_back(std::make_unique<Rehearsal>(scene.mesh, scene.bake, instruction_set));
  }
  choose_probe();
  const std::vector<LightCoefficients> some(lights_.begin(),
                                            lights_.begin() + std::min(lights_.size(), kTurnsOfSpread));
  for (const auto& rehearsal : rehearsals_) spread_ = std::max(spread_, rehearsal->spread(some));
}

// A bound on the radiance of any turn: the albedo, unless the numbers hold it, times the sum of |t_l| |L_l| over bands.
// Unlike the radiance itself it is hardly ever small by accident.
double Measurement::size_of(const float* row, std::size_t vertex) const {
  const TransferShape shape = scene_.bake.kind->shape(scene_.bake.degree);
  double largest = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const float* numbers = row + (shape.channels == 1 ? 0 : c * shape.count());
    double sum = 0.0;
    for (int l = 0; l <= shape.degree; ++l) {
      double squares = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) squares += static_cast<double>(numbers[i] * numbers[i]);
      sum += std::sqrt(squares) * band_norms_[c][static_cast<std::size_t>(l)];
    }
    const auto albedo = static_cast<double>(scene_.mesh.albedo[vertex][static_cast<Eigen::Index>(c)]);
    largest = std::max(largest, shape.holds_albedo ? sum : albedo * sum);
  }
  return largest;
}

// By how much the coarse bakes differ.
std::vector<double> Measurement::likely_errors() const {
  const std::size_t length = scene_.bake.kind->shape(scene_.bake.degree).length();
  std::vector<double> errors(scene_.mesh.positions.size(), 0.0);
  std::vector<float> difference(length);
  for (const auto& rehearsal : rehearsals_) {
    for (std::size_t v = 0; v < errors.size(); ++v) {
      const float* first = rehearsal->coarse(0).data() + v * length;
      const float* second = rehearsal->coarse(1).data() + v * length;
      std::transform(first, first + length, second, difference.begin(), std::minus<>());
      const float closed = std::max(rehearsal->sight(0)[v].closed(), rehearsal->sight(1)[v].closed());
      const double risk = kRiskOfClosed * static_cast<double>(closed) * std::max(size_of(first, v), size_of(second, v));
      errors[v] = std::max({errors[v], size_of(difference.data(), v), risk});
    }
  }
  return errors;
}

void Measurement::choose_probe() {
  const std::vector<double> likely = likely_errors();
  const double sum = std::accumulate(likely.begin(), likely.end(), 0.0);
  const auto vertices = static_cast<double>(likely.size());
  std::vector<std::uint32_t> chosen;
  double before = 0.5;  // of the running sum of chances; where it passes a whole number, a vertex is chosen
  for (std::uint32_t v = 0; v < likely.size(); ++v) {
    const double even = 1.0 / vertices;
    const double weight = sum > 0.0 ? kEvenPart * even + (1.0 - kEvenPart) * likely[v] / sum : even;
    const double chance = std::min(1.0, static_cast<double>(kProbe) * weight);
    const double after = before + chance;
    if (std::floor(after) > std::floor(before)) {
      chosen.push_back(v);
      chance_.push_back(chance);
    }
    before = after;
  }
  const auto is_closed = [&](std::uint32_t v) {
    return std::any_of(rehearsals_.begin(), rehearsals_.end(), [v](const auto& rehearsal) {
      return rehearsal->sight(0)[v].closed() > 0.0F || rehearsal->sight(1)[v].closed() > 0.0F;
    });
  };
  part_.emplace(scene_.mesh, chosen, is_closed, kMostSources);
}

std::vector<float> Measurement::rows(const BakeOptions& options, const std::vector<std::uint8_t>& open) const {
  std::vector<float> rows = rehearsals_[0]->rows(options, *part_, open);
  const TransferShape shape = options.kind->shape(scene_.bake.degree);
  for (std::size_t c = 1; c < rehearsals_.size() && shape.channels == kChannels; ++c) {
    const std::vector<float> own = rehearsals_[c]->rows(options, *part_, open);
    for (std::size_t first = c * shape.count(); first < rows.size(); first += shape.length()) {
      std::copy_n(own.data() + first, shape.count(), rows.data() + first);
    }
  }
  return rows;
}

std::vector<float> Measurement::kept(const std::vector<float>& rows, const TransferShape& shape) const {
  const std::size_t asked = coefficient_count(scene_.bake.degree);
  std::vector<float> cut;
  for (std::size_t first = 0; first < rows.size(); first += asked) {
    cut.insert(cut.end(), rows.begin() + first, rows.begin() + first + shape.count());
  }
  // The scales of 8 bits come from the largest numbers of the whole mesh, which a last row holds.
  std::vector<float> largest(shape.length(), 0.0F);
  const bool same = shape.channels == scene_.bake.kind->shape(0).channels;
  const std::vector<float>& coarse = rehearsals_[0]->coarse(0);
  for (std::size_t i = 0; same && i < coarse.size(); ++i) {
    const std::size_t column = i % asked;
    if (column >= shape.count()) continue;
    float& most = largest[i / asked % shape.channels * shape.count() + column];
    most = std::max(most, std::abs(coarse[i]));
  }
  cut.insert(cut.end(), largest.begin(), largest.end());
  std::vector<float> back = decode(encode(cut, shape), shape);
  back.resize(back.size() - shape.length());
  return back;
}

Measurement::Radiances Measurement::radiances(const std::vector<float>& rows, const TransferShape& shape) const {
  Radiances radiances;
  for (const LightCoefficients& light : lights_) {
    const LightCoefficients low = first_bands(light, shape.degree);
    for (std::size_t i = 0; i < part_->wanted(); ++i) {
      const Eigen::Vector3f& albedo = scene_.mesh.albedo[part_->vertices()[i]];
      for (std::size_t c = 0; c < kChannels; ++c) {
        radiances.push_back(radiance_of(rows.data() + i * shape.length(), shape, low, c, albedo) / unit_);
      }
    }
  }
  return radiances;
}

double Measurement::error(const Radiances& difference) const {
  const auto vertices = static_cast<double>(scene_.mesh.positions.size());
  double worst = 0.0;
  for (std::size_t t = 0; t < lights_.size(); ++t) {
    double squares = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < part_->wanted(); ++i) {
      const double* e = difference.data() + (t * part_->wanted() + i) * kChannels;
      const double square = std::pow(std::max({std::abs(e[0]), std::abs(e[1]), std::abs(e[2])}), 2) / chance_[i];
      squares += square;
      variance += (1.0 - chance_[i]) * square * square;
    }
    worst = std::max(worst, (squares + kDeviations * std::sqrt(variance)) / vertices);
  }
  return std::sqrt(worst);
}

BakeOptions Measurement::reference_options(BakeOptions options) const {
  options.directions = std::min(kMaxDirections, std::max(kReference, 4 * scene_.bake.directions));
  options.seed ^= kReferenceSeed;
  return options;
}

double Measurement::blocked(std::size_t vertex) const {
  const auto visible = [&](std::size_t half) {
    return static_cast<double>(rehearsals_[0]->sight(half)[vertex].visible);
  };
  return std::clamp(1.0 - (visible(0) + visible(1)) / 2.0, 0.0, 1.0);
}

bool Measurement::is_nearly_dark(std::size_t vertex) const { return blocked(vertex) > 1.0 - kNearlyDark; }

double Measurement::rays_a_direction() const {
  double rays = 0.0;
  for (const auto& rehearsal : rehearsals_) rays += rehearsal->rays_a_direction();
  return rays;
}

}  // namespace sh::prt
