#include "numeric/errata/errata.hpp"

#include <algorithm>
#include <iterator>

#include "numeric/errata/parts.hpp"

namespace sh::errata {
namespace {

std::vector<Entry> green() {
  std::vector<Entry> all;
  for (const auto part : {green_sampling, green_basis, green_rotation, green_lighting}) {
    std::ranges::move(part(), std::back_inserter(all));
  }
  std::ranges::sort(all, {}, [](const Entry& entry) { return entry.place.id; });
  return all;
}

// Entries of a paper that we know from other texts only.
std::vector<Entry> reported(std::vector<Entry> entries) {
  for (Entry& entry : entries) entry.place.print = Print::kReport;
  return entries;
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
    default:
      return "lost, derived";
  }
}

Verdict verdict_of(const std::vector<bool>& held) {
  if (held.empty()) return Verdict::kDerived;
  const auto count = std::ranges::count(held, true);
  if (count == 0) return Verdict::kWrong;
  return count == std::ssize(held) ? Verdict::kCorrect : Verdict::kUnderReading;
}

Verdict recorded_verdict(const Entry& entry) {
  std::vector<bool> held;
  for (const Reading& reading : entry.readings) held.push_back(reading.holds);
  return verdict_of(held);
}

std::vector<Source> all_sources() {
  return {
      {"G", "Green, Spherical Harmonic Lighting: The Gritty Details, 2003", "Green 2003", green()},
      {"GP", "gpfault.net, Introduction to Spherical Harmonics for Graphics Programmers, 2026", "gpfault 2026",
       gpfault()},
      {"S", "Sloan, Kautz, Snyder, Precomputed Radiance Transfer, 2002", "Sloan, Kautz, Snyder 2002", sloan()},
      {"B", "Brown, Spherical Harmonic Basis Functions, 2004", "Brown 2004", brown()},
      {"IR", "Ivanic, Ruedenberg, Rotation Matrices for Real Spherical Harmonics, 1996 with the corrections of 1998",
       "Ivanic, Ruedenberg 1996", reported(ivanic_ruedenberg())},
      {"CH", "Choi, Ivanic, Gordon, Ruedenberg, Rapid and Stable Determination of Rotation Matrices, 1999",
       "Choi et al. 1999", reported(choi())},
      {"BL", "Blanco, Florez, Bermejo, Evaluation of the Rotation Matrices, 1997", "Blanco, Florez, Bermejo 1997",
       reported(blanco())},
      {"RH", "Ramamoorthi, Hanrahan, An Efficient Representation for Irradiance Environment Maps, 2001",
       "Ramamoorthi, Hanrahan 2001", reported(ramamoorthi())},
      {"BJ", "Basri, Jacobs, Lambertian Reflectance and Linear Subspaces, 2003", "Basri, Jacobs 2003",
       reported(basri_jacobs())},
  };
}

}  // namespace sh::errata
