// Fewer receivers: where the transfer of a mesh changes little along an edge that was halved, its middle is left out, and
// rendering interpolates there. What a middle differs by is the hierarchical surplus of sparse grids [BungartzGriebel04];
// two bakes along directions of their own tell it, so that their noise does not count as a difference.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>

#include "prt/bake/fill_closed.hpp"
#include "prt/chunks.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/plan/draft.hpp"

namespace sh::prt {

namespace {

constexpr int kMostOfProbe = 2048;  // directions
constexpr double kWorthIt = 0.9;    // of the vertices may be left at most
constexpr double kLeft = 0.8;       // of the budget may be used up at most, with all directions

using Shown = std::vector<Eigen::Vector3f>;  // exit radiance of all vertices
using Halves = std::array<Shown, 2>;         // by both coarse bakes

double largest_of(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return static_cast<double>(a.cwiseProduct(b).maxCoeff());
}

// The sum of products of two estimates that are apart in their noise, and its standard error at most.
struct Sum {
  double value = 0.0;
  double squares = 0.0;
  double count = 0.0;

  void add(double product) {
    value += product;
    squares += product * product;
    count += 1.0;
  }
  // The mean, no less than 0, and one standard error: what cannot be told counts as large.
  [[nodiscard]] double cautious_mean() const { return (std::max(0.0, value) + std::sqrt(squares)) / count; }
};

// Replaces the values of middles by the mean over those nearby that have edges of about the same length and normals of
// about the same direction.
void average_nearby(const Mesh& mesh, std::vector<double>& values) {
  constexpr double kCell = 6.0;  // edges
  std::unordered_map<std::array<std::uint32_t, 5>, Sum, WordsHash> sums;
  std::vector<Sum*> sum_of(values.size(), nullptr);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!mesh.halving.is_middle(v)) continue;
    const auto [a, b] = mesh.halving.ends[v];
    const int level = std::ilogb((mesh.positions[a] - mesh.positions[b]).norm());
    const Eigen::Vector3d cell = (mesh.positions[v].cast<double>() / std::ldexp(kCell, level)).array().floor();
    Eigen::Index axis = 0;
    mesh.normals[v].cwiseAbs().maxCoeff(&axis);
    const auto word = [](double x) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(x)); };
    const auto side = static_cast<std::uint32_t>(2 * axis + (mesh.normals[v][axis] < 0.0F ? 1 : 0));
    sum_of[v] = &sums[{static_cast<std::uint32_t>(level), word(cell.x()), word(cell.y()), word(cell.z()), side}];
    sum_of[v]->add(values[v]);
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (sum_of[v] != nullptr) values[v] = sum_of[v]->cautious_mean();
  }
}

// Exit radiance of all vertices by both coarse bakes under some turns of the light.
class CoarseRadiances {
 public:
  explicit CoarseRadiances(const Draft& draft) : mesh_(draft.scene.mesh), order_(ends_first(mesh_.halving)) {
    const Measurement& measurement = *draft.measurement;
    const TransferShape shape = draft.asked.kind->shape(draft.asked.degree);
    for (std::size_t t = 0; t < std::min(measurement.turns(), Measurement::kTurnsOfSome); ++t) {
      for (Shown& radiances : turns_.emplace_back()) radiances.resize(mesh_.positions.size());
      for_vertices(mesh_.positions.size(), [&](std::size_t v) {
        for (std::size_t half = 0; half < 2; ++half) {
          for (std::size_t c = 0; c < 3; ++c) {
            const float* row = measurement.rehearsal().channel(c).coarse(half).data() + v * shape.length();
            const auto channel = static_cast<Eigen::Index>(c);
            const double radiance = radiance_of(row, shape, measurement.lights()[t], mesh_.albedo[v])[channel];
            turns_.back()[half][v][channel] = static_cast<float>(radiance / draft.plan.reference);
          }
        }
      });
    }
  }

  // (vertices) The mean square that a middle adds to the squares of all vertices if it alone is left out.
  [[nodiscard]] std::vector<double> shares() const {
    std::vector<double> parts(mesh_.positions.size(), 1.0);  // vertices that a middle carries along
    for (auto v = order_.rbegin(); v != order_.rend(); ++v) {
      if (!mesh_.halving.is_middle(*v)) continue;
      for (const std::uint32_t end : mesh_.halving.ends[*v]) parts[end] += 0.5 * parts[*v];
    }
    std::vector<double> shares(parts.size(), 0.0);
    for (std::size_t v = 0; v < shares.size(); ++v) {
      if (!mesh_.halving.is_middle(v)) continue;
      const auto [a, b] = mesh_.halving.ends[v];
      const auto surplus = [&, a = a, b = b](const Shown& x) { return (x[v] - 0.5F * (x[a] + x[b])).eval(); };
      for (const auto& halves : turns_) shares[v] += largest_of(surplus(halves[0]), surplus(halves[1]));
      shares[v] /= static_cast<double>(turns_.size());
    }
    average_nearby(mesh_, shares);
    for (std::size_t v = 0; v < shares.size(); ++v) shares[v] *= parts[v];
    return shares;
  }

  // The error that the bakes tell: a guess, without the noise of their directions.
  [[nodiscard]] double error(const std::vector<std::uint8_t>& kept) const {
    double worst = 0.0;
    for (const auto& halves : turns_) {
      const Halves lost = {lost_by(halves[0], kept), lost_by(halves[1], kept)};
      Sum sum;
      for (std::size_t v = 0; v < kept.size(); ++v) sum.add(largest_of(lost[0][v], lost[1][v]));
      worst = std::max(worst, std::sqrt(sum.cautious_mean()));
    }
    return worst;
  }

  // (vertices) How large the error of each vertex may be.
  [[nodiscard]] std::vector<double> likely_errors(const std::vector<std::uint8_t>& kept) const {
    std::vector<double> squares(kept.size(), 0.0);
    for (const auto& halves : turns_) {
      for (const Shown& half : halves) {
        const Shown lost = lost_by(half, kept);
        for (std::size_t v = 0; v < kept.size(); ++v) squares[v] = std::max(squares[v], largest_of(lost[v], lost[v]));
      }
    }
    for (double& square : squares) square = std::sqrt(square);
    return squares;
  }

 private:
  [[nodiscard]] Shown lost_by(const Shown& whole, const std::vector<std::uint8_t>& kept) const {
    Shown lost = whole;
    interpolate_left_out(mesh_.halving, order_, kept, lost);
    for (std::size_t v = 0; v < lost.size(); ++v) lost[v] -= whole[v];
    return lost;
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Halves> turns_;
};

// Closed vertices and their neighbors: between other ones, closed vertices would take other light.
std::vector<std::uint8_t> marks_of_closed(const Mesh& mesh, const ColorRehearsal& rehearsal) {
  std::vector<std::uint8_t> marks(mesh.positions.size(), 0);
  for (const auto& one : rehearsal.each()) {
    for (const std::size_t half : {0U, 1U}) {
      for (const ClosedVertex& closed : closed_vertices(mesh, one->sight(half))) {
        marks[closed.vertex] = 1;
        for (const std::uint32_t neighbor : closed.neighbors) marks[neighbor] = 1;
      }
    }
  }
  return marks;
}

// The fewest vertices for which the coarse bakes tell at most this error; those of `needed` are among them.
std::vector<std::uint8_t> fewest(const Mesh& mesh, const CoarseRadiances& coarse,
                                 const std::vector<std::uint8_t>& needed, double error) {
  constexpr int kSteps = 16;
  const std::vector<double> shares = coarse.shares();
  const auto above = [&](double limit) {
    std::vector<std::uint8_t> kept = needed;
    for (std::size_t v = 0; v < kept.size(); ++v) {
      if (shares[v] > limit) kept[v] = 1;
    }
    return with_ends(mesh, std::move(kept));
  };
  double most = *std::max_element(shares.begin(), shares.end());
  double least = most * 1e-12;
  for (int step = 0; step < kSteps && most > least; ++step) {
    const double middle = std::sqrt(least) * std::sqrt(most);
    (coarse.error(above(middle)) > error ? most : least) = middle;
  }
  return above(least);
}

// What fewer receivers cost: the marks, and the error that they alone make, as measured.
struct Choice {
  std::vector<std::uint8_t> kept;
  std::vector<double> likely = {};
  double error = 0.0;
};

// Tries some counts of receivers. Their errors differ from the guesses of coarse bakes, so that each try corrects the next
// guess. Nothing if none leaves out a tenth within `room`.
std::optional<Choice> choose(const Draft& draft, const CoarseRadiances& coarse, Measurement& measurement, double room) {
  constexpr int kTries = 4;
  constexpr double kFirstGuess = 0.5;  // parts of the room
  constexpr double kAimedAt = 0.8;
  constexpr double kCloseToRoom = 0.6;
  constexpr double kLeastPart = 0.1;
  const std::vector<std::uint8_t> needed = marks_of_closed(draft.scene.mesh, measurement.rehearsal());
  std::optional<Choice> best;
  double guess = kFirstGuess * room;
  for (int i = 0; i < kTries; ++i) {
    Choice choice{.kept = fewest(draft.scene.mesh, coarse, needed, guess)};
    const auto left = static_cast<double>(std::count(choice.kept.begin(), choice.kept.end(), 1));
    if (left > kWorthIt * static_cast<double>(choice.kept.size())) break;
    choice.likely = coarse.likely_errors(choice.kept);
    measurement.keep(choice.kept, choice.likely);
    const std::vector<float> rows = measurement.rows(draft.along(std::min(draft.asked.directions, kMostOfProbe)));
    Measurement::Radiances error = measurement.radiances(rows, draft.traced_shape());
    const Measurement::Radiances own = measurement.own_radiances(rows, draft.traced_shape());
    std::transform(error.begin(), error.end(), own.begin(), error.begin(), std::minus<>());
    const double measured = choice.error = measurement.error(error);
    if (measured <= room && (!best || measured > best->error)) best = std::move(choice);
    if (measured <= room && measured >= kCloseToRoom * room) break;
    guess *= kAimedAt * room / std::max(measured, kLeastPart * room);
  }
  return best;
}

}  // namespace

void decide_receivers(Draft& draft) {
  constexpr double kPart = 0.4;
  const Mesh& mesh = draft.scene.mesh;
  if (!draft.bake.kind->traces_rays() || mesh.halving.empty() || !mesh.atlases.heads.empty()) return;
  const std::size_t all = mesh.positions.size();
  const auto refuse = [&](const char* why) {
    draft.decide(kReceiversDecision, fmt::format("all {} vertices", all), why);
  };
  if (draft.needs_all_receivers) return refuse("fewer would leave no room for the other decisions");
  Measurement& measurement = *draft.measurement;
  const CoarseRadiances coarse(draft);
  const std::optional<Choice> choice = choose(draft, coarse, measurement, draft.share(kPart));
  const auto keep = [&](const Choice& one) {
    measurement.keep(one.kept, one.likely);
    draft.take_reference();
    draft.plan.receivers = one.kept;
  };
  if (!choice) {
    keep({});
    return refuse("fewer would exceed the budget, or leave out less than a tenth");
  }
  keep(*choice);
  if (draft.error_along(draft.asked.directions) > kLeft * draft.options.error) {
    keep({});
    return refuse("fewer would leave no room for the other decisions");
  }
  draft.decide(kReceiversDecision, fmt::format("{} of {} vertices", draft.receivers(), all),
               "colors between them are interpolated, on faces that were split", choice->error, "measured");
  // What interpolation loses does not depend on what the other decisions lose, so that squares add.
  draft.left = std::sqrt(std::max(0.0, std::pow(draft.left + choice->error, 2) - std::pow(choice->error, 2)));
}

}  // namespace sh::prt
