#include "prt/plan/color_rehearsal.hpp"

#include <algorithm>
#include <utility>

#include "prt/bake/gray.hpp"

namespace sh::prt {

ColorRehearsal::ColorRehearsal(const Scene& scene, const std::string& instruction_set) : degree_(scene.bake.degree) {
  if (!has_colored_mirrors(scene.mesh)) {
    each_.push_back(std::make_unique<Rehearsal>(scene, instruction_set));
    return;
  }
  for (int c = 0; c < 3; ++c) {
    Scene gray = scene;
    gray.mesh = in_gray(std::move(gray.mesh), c);
    each_.push_back(std::make_unique<Rehearsal>(gray, instruction_set));
  }
}

std::vector<float> ColorRehearsal::rows(const BakeOptions& options, const TracedPart& part,
                                        const std::vector<std::uint8_t>& open) const {
  std::vector<float> rows = each_[0]->rows(options, part, open);
  const TransferShape shape = options.kind->shape(degree_);
  for (std::size_t c = 1; c < each_.size() && shape.channels == each_.size(); ++c) {
    const std::vector<float> own = each_[c]->rows(options, part, open);
    for (std::size_t first = c * shape.count(); first < rows.size(); first += shape.length()) {
      std::copy_n(own.data() + first, shape.count(), rows.data() + first);
    }
  }
  return rows;
}

TracedPart ColorRehearsal::part(const Mesh& mesh, std::vector<std::uint32_t> wanted) const {
  constexpr std::size_t kMostSources = 1;  // traced for the fill of a vertex, on average
  const auto is_closed = [this](std::uint32_t v) {
    return std::any_of(each_.begin(), each_.end(), [v](const auto& rehearsal) {
      return rehearsal->sight(0)[v].closed() > 0.0F || rehearsal->sight(1)[v].closed() > 0.0F;
    });
  };
  return {mesh, std::move(wanted), is_closed, kMostSources};
}

double ColorRehearsal::rays_a_direction() const {
  double rays = 0.0;
  for (const auto& rehearsal : each_) rays += rehearsal->rays_a_direction();
  return rays;
}

}  // namespace sh::prt
