// The rehearsal of a scene; where mirrors have colors, one for each channel, as the bake itself is done channel by channel.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "prt/plan/rehearsal.hpp"

namespace sh::prt {

class ColorRehearsal {
 public:
  ColorRehearsal(const Scene& scene, const std::string& instruction_set);

  /// One, or one a channel.
  [[nodiscard]] const std::vector<std::unique_ptr<Rehearsal>>& each() const { return each_; }
  [[nodiscard]] const Rehearsal& channel(std::size_t c) const { return *each_[each_.size() == 1 ? 0 : c]; }

  /// Rehearsal::rows() of all channels.
  [[nodiscard]] std::vector<float> rows(const BakeOptions& options, const TracedPart& part,
                                        const std::vector<std::uint8_t>& open = {}) const;
  /// These vertices as a part, with those from which closed ones take light.
  [[nodiscard]] TracedPart part(const Mesh& mesh, std::vector<std::uint32_t> wanted) const;
  /// Rays of a bake of the whole mesh for each direction, in all channels.
  [[nodiscard]] double rays_a_direction() const;

 private:
  int degree_;  // the asked one
  std::vector<std::unique_ptr<Rehearsal>> each_;
};

}  // namespace sh::prt
