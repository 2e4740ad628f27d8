#include "symbolic/errata/decide.hpp"

#include <stdexcept>

#include "symbolic/errata/statement.hpp"

namespace sh::symbolic::errata {
namespace {

using sh::errata::Entry;
using sh::errata::Reading;
using sh::errata::Verdict;

// What is wrong with the entry itself: a reading or a correction that nothing decides.
std::string gap(const Entry& entry, Verdict verdict) {
  for (const Reading& reading : entry.readings) {
    if (reading.statement.empty() && reading.number.empty()) return "nothing decides '" + reading.text + "'";
  }
  const bool needs_correction = verdict == Verdict::kWrong || verdict == Verdict::kDerived;
  return needs_correction && entry.correct_statement.empty() ? "nothing decides the correct formula" : "";
}

std::string disagreement(const Entry& entry, const Decision& decision) {
  for (std::size_t i = 0; i < entry.readings.size(); ++i) {
    const Reading& reading = entry.readings[i];
    if (reading.holds == decision.held[i]) continue;
    return "'" + reading.text + "' is recorded as " + (reading.holds ? "right, but fails" : "wrong, but holds");
  }
  return !entry.correct_statement.empty() && !holds(entry.correct_statement) ? "the correct formula fails" : "";
}

Decision decide_or_throw(const Entry& entry) {
  Decision decision;
  for (const Reading& reading : entry.readings) {
    decision.held.push_back(reading.statement.empty() ? reading.holds : holds(reading.statement));
  }
  decision.verdict = sh::errata::verdict_of(decision.held);
  decision.contradiction = disagreement(entry, decision);
  if (decision.contradiction.empty()) decision.contradiction = gap(entry, decision.verdict);
  if (!decision.contradiction.empty()) decision.contradiction.insert(0, entry.place.id + ": ");
  return decision;
}

}  // namespace

Decision decide(const Entry& entry) {
  try {
    return decide_or_throw(entry);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(entry.place.id + ": " + error.what());
  }
}

}  // namespace sh::symbolic::errata
