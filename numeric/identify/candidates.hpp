// The search behind identify.hpp: every convention, with the number of columns it does not explain.
#pragma once

#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/identify/samples.hpp"

namespace sh::numeric::identify {

struct Candidate {
  Convention convention;
  int wrong = 0;       // columns that deviate by more than kRounded, holes that are not zero
  double penalty = 0;  // how far their sizes are off: 0 where only signs are wrong
  int rank = 0;        // 0: a preset, 1: a preset's world, 2: axes x,y,z, 3: right-handed, 4: mirrored
};

// All of them, the best first: fewest wrong, then smallest penalty, then rank, then the order of the enumerations.
std::vector<Candidate> ranked_candidates(const Samples& samples);

// Presets that say what the convention says, in their own coordinates or, where those differ, in our world's.
std::vector<std::string> own_presets(const Convention& convention);
std::vector<std::string> world_presets(const Convention& convention);

}  // namespace sh::numeric::identify
