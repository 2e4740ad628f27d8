#include "symbolic/errata/entry.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::symbolic::errata {
namespace {

void require(const Entry& entry, bool condition, const std::string& what) {
  if (!condition) throw std::logic_error("errata " + entry.id + ": " + what);
}

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kCorrect:
      return "correct";
    case Verdict::kUnderReading:
      return "correct under reading";
    case Verdict::kWrong:
      return "wrong";
    case Verdict::kDefinition:
      return "definition";
    case Verdict::kDerived:
      return "lost, derived";
    case Verdict::kUndecided:
      return "undecided";
  }
  throw std::logic_error("errata: unknown verdict");
}

Verdict decide(const Entry& entry) {
  const bool correct_is_decided = !entry.correct.empty() && entry.correct_holds != nullptr;
  if (correct_is_decided) require(entry, entry.correct_holds(), "the formula given as correct does not hold");
  if (entry.readings.empty()) {
    if (entry.print == Print::kLost && correct_is_decided) return Verdict::kDerived;
    require(entry, !entry.remark.empty(), "no reading is decided and no remark says why");
    require(entry, entry.verdict == Verdict::kDefinition || entry.verdict == Verdict::kUndecided,
            "a verdict needs a decision");
    return entry.verdict;
  }
  for (const Reading& reading : entry.readings) require(entry, reading.holds != nullptr, "a reading is not decided");
  const auto held = std::count_if(entry.readings.begin(), entry.readings.end(),
                                  [](const Reading& reading) { return reading.holds(); });
  if (held == 0) {
    require(entry, correct_is_decided, "no reading holds, so it needs a correct formula that does");
    return Verdict::kWrong;
  }
  return held == static_cast<long>(entry.readings.size()) ? Verdict::kCorrect : Verdict::kUnderReading;
}

}  // namespace sh::symbolic::errata
