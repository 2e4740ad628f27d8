// Decides an entry of the errata: every reading that has a statement, and the correct formula.
//
// Input: an entry (numeric/errata/errata.hpp). Output: the readings that hold, the verdict that follows, and a
// contradiction when that is not the recorded one.
#pragma once

#include <string>
#include <vector>

#include "numeric/errata/errata.hpp"

namespace sh::symbolic::errata {

struct Decision {
  std::vector<bool> held;  ///< one value a reading; as recorded where a reading is only measured
  sh::errata::Verdict verdict = sh::errata::Verdict::kDerived;
  std::string contradiction;  ///< one line that names the entry; empty: the decisions are the recorded ones
};

/// Throws std::invalid_argument, naming the entry, when a statement cannot be read.
Decision decide(const sh::errata::Entry& entry);

}  // namespace sh::symbolic::errata
