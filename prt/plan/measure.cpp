#include "prt/plan/measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "prt/arrays.hpp"
#include "prt/chunks.hpp"
#include "prt/plan/views.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/gather.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr double kRiskOfClosed = 0.05;  // of its light: a closed vertex may be decided differently by other rays
constexpr int kTurnsAboutZ = 24;
constexpr int kTurnsOfAnyAxis = 48;
constexpr std::uint32_t kReferenceSeed = 0x5EED;

// One of kTurnsOfAnyAxis even rotations: a super-Fibonacci spiral of unit quaternions [Alexa22], turned so that rotation 0
// is the identity.
Eigen::Matrix3d even_rotation(int k) {
  constexpr double kPsi = 1.533751168755204288;  // psi^4 = psi + 4
  const auto on_spiral = [](double s) {
    const double inner = std::sqrt(s / kTurnsOfAnyAxis);
    const double outer = std::sqrt(1.0 - s / kTurnsOfAnyAxis);
    const double a = 2.0 * std::numbers::pi * s / std::numbers::sqrt2;
    const double b = 2.0 * std::numbers::pi * s / kPsi;
    return Eigen::Quaterniond(outer * std::cos(b), inner * std::sin(a), inner * std::cos(a), outer * std::sin(b));
  };
  return (on_spiral(k + 0.5) * on_spiral(0.5).conjugate()).toRotationMatrix();
}

// The same numbers for light and result of another degree, in plain storage.
TransferShape of_degree(TransferShape shape, int degree) {
  shape.degree = degree;
  if (!shape.holds_cosine) shape.result_degree = degree;
  shape.storage = {};
  return shape;
}

// A transfer of the rows of so many vertices, without a mesh but for its size.
Transfer transfer_of(const std::vector<float>& rows, const RowShape& shape, std::size_t vertices) {
  Transfer transfer;
  transfer.kind = shape.matrices ? &kGlossyInterreflected : &kGlossyShadowed;
  transfer.shape = shape.numbers;
  transfer.shape.storage = {};
  if (shape.matrices) transfer.indirect_shape = *shape.matrices;
  const std::size_t length = shape.length();
  transfer.mesh.positions.resize(vertices);
  for (auto row = rows.begin(); row < rows.end(); row += static_cast<std::ptrdiff_t>(length)) {
    const auto matrix = row + static_cast<std::ptrdiff_t>(shape.numbers.length());
    transfer.coefficients.insert(transfer.coefficients.end(), row, matrix);
    transfer.indirect.insert(transfer.indirect.end(), matrix, row + static_cast<std::ptrdiff_t>(length));
  }
  return transfer;
}

}  // namespace

std::vector<LightCoefficients> turns_of(const LightCoefficients& light, LightTurns turns) {
  std::vector<LightCoefficients> lights = {light};
  for (int k = 1; turns == LightTurns::kAboutZ && k < kTurnsAboutZ; ++k) {
    lights.push_back(turned(light, rotation_about(Eigen::Vector3d::UnitZ(), 360.0 * k / kTurnsAboutZ)));
  }
  for (int k = 1; turns == LightTurns::kAny && k < kTurnsOfAnyAxis; ++k) {
    lights.push_back(turned(light, even_rotation(k)));
  }
  return lights;
}

Eigen::Vector3d radiance_of(const float* row, const TransferShape& shape, const LightCoefficients& light,
                            const Eigen::Vector3f& albedo) {
  const Eigen::Vector3d sums = integral_with(row, shape.channels, light);
  return shape.holds_albedo ? sums : sums.cwiseProduct(albedo.cast<double>());
}

double radiance_bound(const float* row, const TransferShape& shape, const TurningLight& light,
                      const Eigen::Vector3f& albedo) {
  double largest = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const float* numbers = row + (shape.channels == 1 ? 0 : c * shape.count());
    double sum = 0.0;
    for (int l = 0; l <= shape.degree; ++l) {
      sum += band(numbers, l).matrix().cast<double>().norm() * light.band_norm(c, l);
    }
    largest = std::max(largest, shape.holds_albedo ? sum : static_cast<double>(albedo[c]) * sum);
  }
  return largest;
}

double worst_radiance(const Transfer& transfer, const std::vector<LightCoefficients>& lights) {
  const Mesh& mesh = transfer.mesh;
  double worst = 0.0;
  for (const LightCoefficients& light : lights) {
    const LightCoefficients low = first_bands(light, transfer.degree());
    std::vector<double> squares(mesh.positions.size());
    if (transfer.kind->is_glossy()) {
      squares = seen_squares(TransferredRadiance(transfer, low), mesh);
    } else {
      for (std::size_t v = 0; v < squares.size(); ++v) {
        const Eigen::Vector3d radiance = radiance_of(transfer.row(v), transfer.shape, low, mesh.albedo[v]);
        squares[v] = radiance.cwiseAbs2().maxCoeff();
      }
    }
    const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
    worst = std::max(worst, std::sqrt(sum / static_cast<double>(squares.size())));
  }
  return worst;
}

Measurement::Measurement(const Scene& scene, const LightCoefficients& light, LightTurns turns, double unit,
                         const std::string& instruction_set)
    : scene_(scene), unit_(unit), lights_(turns_of(light, turns)), rehearsal_(scene, instruction_set) {
  likely_ = scene.bake.kind->is_glossy() ? likely_glossy_errors() : likely_errors(TurningLight(light, turns));
  keep({}, {});
  for (const auto& rehearsal : rehearsal_.each()) spread_ = std::max(spread_, rehearsal->spread(some_lights()));
}

std::vector<LightCoefficients> Measurement::some_lights() const {
  return {lights_.begin(), lights_.begin() + std::min(lights_.size(), kTurnsOfSome)};
}

std::size_t Measurement::eyes() const { return scene_.bake.kind->is_glossy() ? Views::kEyes : 1; }

// By how much the coarse bakes differ.
std::vector<double> Measurement::likely_errors(const TurningLight& light) const {
  const TransferShape shape = scene_.bake.kind->shape(scene_.bake.degree);
  const std::size_t length = shape.length();
  std::vector<double> errors(scene_.mesh.positions.size(), 0.0);
  std::vector<float> difference(length);
  for (const auto& rehearsal : rehearsal_.each()) {
    for (std::size_t v = 0; v < errors.size(); ++v) {
      const auto size = [&](const float* row) { return radiance_bound(row, shape, light, scene_.mesh.albedo[v]); };
      const float* first = rehearsal->coarse(0).data() + v * length;
      const float* second = rehearsal->coarse(1).data() + v * length;
      as_array(difference) = as_array(first, length) - as_array(second, length);
      const float closed = std::max(rehearsal->sight(0)[v].closed(), rehearsal->sight(1)[v].closed());
      const double risk = kRiskOfClosed * static_cast<double>(closed) * std::max(size(first), size(second));
      errors[v] = std::max({errors[v], size(difference.data()), risk});
    }
  }
  return errors;
}

// The same, as exit radiance towards the eyes.
std::vector<double> Measurement::likely_glossy_errors() const {
  const Rehearsal& rehearsal = rehearsal_.channel(0);
  const Transfer difference = rehearsal.difference();
  Transfer whole = difference;
  whole.coefficients = rehearsal.coarse(0);
  std::vector<double> errors(scene_.mesh.positions.size(), 0.0);
  for (const LightCoefficients& light : some_lights()) {
    const std::vector<double> squares = seen_squares(TransferredRadiance(difference, light), scene_.mesh);
    const std::vector<double> own = seen_squares(TransferredRadiance(whole, light), scene_.mesh);
    for (std::size_t v = 0; v < errors.size(); ++v) {
      const float closed = std::max(rehearsal.sight(0)[v].closed(), rehearsal.sight(1)[v].closed());
      errors[v] =
          std::max({errors[v], std::sqrt(squares[v]), kRiskOfClosed * static_cast<double>(closed) * std::sqrt(own[v])});
    }
  }
  return errors;
}

std::vector<float> Measurement::rows(const BakeOptions& options, const std::vector<std::uint8_t>& open) const {
  return rehearsal_.rows(options, *part_, open);
}

std::vector<float> Measurement::kept(const std::vector<float>& rows, const RowShape& shape) const {
  const RowShape asked = [&] {
    RowShape whole = of_degree(shape.numbers, scene_.bake.degree);
    if (shape.matrices) whole.matrices = of_degree(*shape.matrices, scene_.bake.degree);
    return whole;
  }();
  std::vector<float> numbers;
  std::vector<float> matrices;
  for (std::size_t first = 0; first < rows.size(); first += asked.length()) {
    append_lower(rows.data() + first, asked.numbers, shape.numbers, numbers);
    if (!shape.matrices) continue;
    append_lower(rows.data() + first + asked.numbers.length(), *asked.matrices, *shape.matrices, matrices);
  }
  // The scales of 8 bits come from the largest numbers of the whole mesh, which a last row holds.
  Eigen::ArrayXf largest = Eigen::ArrayXf::Zero(Eigen::Index(asked.numbers.length()));
  if (shape.numbers.channels == scene_.bake.kind->shape(0).channels) {
    largest = largest_numbers(rehearsal_.channel(0).coarse(0), asked.numbers.length());
  }
  append_lower(largest.data(), asked.numbers, shape.numbers, numbers);
  numbers = decode(encode(numbers, shape.numbers), shape.numbers);
  numbers.resize(numbers.size() - shape.numbers.length());
  if (!shape.matrices) return numbers;
  matrices = decode(encode(matrices, *shape.matrices), *shape.matrices);
  std::vector<float> back;
  for (std::size_t i = 0; i * asked.length() < rows.size(); ++i) {
    const auto append = [&](const std::vector<float>& from, std::size_t length) {
      back.insert(back.end(), from.data() + i * length, from.data() + (i + 1) * length);
    };
    append(numbers, shape.numbers.length());
    append(matrices, shape.matrices->length());
  }
  return back;
}

void Measurement::keep(const std::vector<std::uint8_t>& kept, const std::vector<double>& likely) {
  shown_.clear();
  std::vector<double> likely_of_both = likely_;
  for (std::size_t v = 0; v < likely.size(); ++v) likely_of_both[v] = std::hypot(likely_[v] / unit_, likely[v]);
  probe_ = choose_probe(likely_of_both);
  std::vector<std::uint32_t> wanted = probe_.vertices;
  if (!kept.empty()) {
    std::unordered_map<std::uint32_t, std::uint32_t> places;
    for (std::uint32_t i = 0; i < wanted.size(); ++i) places[wanted[i]] = i;
    shown_ = blends_of(scene_.mesh.halving, kept, probe_.vertices);
    for (Blend& blend : shown_) {
      for (auto& [vertex, part] : blend) {
        const auto [place, is_new] = places.try_emplace(vertex, static_cast<std::uint32_t>(wanted.size()));
        if (is_new) wanted.push_back(vertex);
        vertex = place->second;
      }
    }
  }
  part_.emplace(rehearsal_.part(scene_.mesh, std::move(wanted)));
}

Measurement::Radiances Measurement::radiances(const std::vector<float>& rows, const RowShape& shape) const {
  return scene_.bake.kind->is_glossy() ? glossy_radiances(rows, shape) : blended(rows, shape.numbers, shown_);
}

Measurement::Radiances Measurement::own_radiances(const std::vector<float>& rows, const RowShape& shape) const {
  return scene_.bake.kind->is_glossy() ? glossy_radiances(rows, shape) : blended(rows, shape.numbers, {});
}

Measurement::Radiances Measurement::blended(const std::vector<float>& rows, const TransferShape& shape,
                                            const std::vector<Blend>& blends) const {
  Radiances radiances;
  std::vector<Eigen::Vector3d> own(blends.empty() ? probe_.vertices.size() : part_->wanted());
  for (const LightCoefficients& light : lights_) {
    const LightCoefficients low = first_bands(light, shape.degree);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Eigen::Vector3f& albedo = scene_.mesh.albedo[part_->vertices()[i]];
      own[i] = radiance_of(rows.data() + i * shape.length(), shape, low, albedo) / unit_;
    }
    for (std::size_t i = 0; i < probe_.vertices.size(); ++i) {
      Eigen::Vector3d shown = blends.empty() ? own[i] : Eigen::Vector3d::Zero().eval();
      if (!blends.empty()) {
        for (const auto& [place, part] : blends[i]) shown += part * own[place];
      }
      radiances.insert(radiances.end(), shown.begin(), shown.end());
    }
  }
  return radiances;
}

Measurement::Radiances Measurement::glossy_radiances(const std::vector<float>& rows, const RowShape& shape) const {
  const Transfer probe = transfer_of(rows, shape, part_->wanted());
  const std::size_t numbers = eyes() * kChannels;  // of a vertex
  Radiances radiances(lights_.size() * part_->wanted() * numbers);
  std::vector<TransferredRadiance> reaching;
  for (const LightCoefficients& light : lights_) reaching.emplace_back(probe, first_bands(light, probe.degree()));
  for_vertices(part_->wanted(), [&](std::size_t i) {
    const Views views(scene_.mesh, part_->vertices()[i], probe.degree());
    for (std::size_t t = 0; t < lights_.size(); ++t) {
      double* to = radiances.data() + (t * part_->wanted() + i) * numbers;
      for (const Eigen::Vector3d& seen : views.radiance(reaching[t].at(i))) {
        to = std::transform(seen.begin(), seen.end(), to, [this](double radiance) { return radiance / unit_; });
      }
    }
  });
  return radiances;
}

double Measurement::error(const Radiances& difference) const {
  double worst = 0.0;
  const auto eyes = static_cast<double>(this->eyes());
  std::vector<double> squares(probe_.vertices.size());
  std::vector<double> variances(eyes > 1.0 ? squares.size() : 0);
  const double* e = difference.data();
  for (std::size_t t = 0; t < lights_.size(); ++t) {
    for (std::size_t i = 0; i < squares.size(); ++i) {
      double sum = 0.0;
      double fourth = 0.0;
      for (std::size_t eye = 0; eye < this->eyes(); ++eye, e += kChannels) {
        const double square = std::pow(std::max({std::abs(e[0]), std::abs(e[1]), std::abs(e[2])}), 2);
        sum += square;
        fourth += square * square;
      }
      squares[i] = sum / eyes;
      if (!variances.empty()) variances[i] = std::max(0.0, fourth - sum * squares[i]) / (eyes * (eyes - 1.0));
    }
    worst = std::max(worst, stated_error(probe_, squares, scene_.mesh.positions.size(), variances));
  }
  return worst;
}

BakeOptions Measurement::reference_options(BakeOptions options) const {
  options.directions = std::min(kMaxDirections, std::max(kReference, 4 * scene_.bake.directions));
  options.bounces.directions = 0;
  options.seed ^= kReferenceSeed;
  return options;
}

double Measurement::blocked(std::size_t vertex) const {
  const auto visible = [&](std::size_t half) {
    return static_cast<double>(rehearsal_.channel(0).sight(half)[vertex].visible);
  };
  return std::clamp(1.0 - (visible(0) + visible(1)) / 2.0, 0.0, 1.0);
}

bool Measurement::is_nearly_dark(std::size_t vertex) const { return blocked(vertex) > 1.0 - kNearlyDark; }

double Measurement::rays_a_direction() const { return rehearsal_.rays_a_direction(); }

}  // namespace sh::prt
