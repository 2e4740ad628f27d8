// Numbers that the sources state about sampling and truncation, measured again.
//
// Input: the measured readings of numeric/errata/errata.hpp, which record the printed number and the verdict on it.
// Output: one row for each reading. The numbers come from quadrature or from samples of fixed seeds: the same bits in
// every run on one machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sh::numeric {

struct SourceClaim {
  std::string id;       ///< the entry of the errata: "S-32"
  std::string claim;    ///< in words: the place in the source, and the reading
  std::string source;   ///< author, year
  std::string printed;  ///< the number as printed, without its unit: "0.3"
  double measured;      ///< in the same unit
  std::string unit;     ///< "%" or ""
  bool reproduced;  ///< the measured number is the printed one, to its digits or within the spread that `how` states
  bool recorded;    ///< the verdict of the errata
  std::string how;  ///< the experiment in a sentence
};

/// The row of an entry's measured reading `reading` (0: its first with a number), reproduced if `measured` rounds to the
/// printed number. Throws std::out_of_range if there is no such reading.
SourceClaim claim_of(const std::string& id, int reading, double measured, const std::string& how);
SourceClaim claim_of(const std::string& id, int reading, double measured, const std::string& how, bool reproduced);

/// All claims below, in their order. Calls `step` after each of the four functions. Quick: under two seconds; full: more
/// seeds and lights.
std::vector<SourceClaim> source_claims(bool quick, const std::function<void()>& step = {});

std::vector<SourceClaim> cube_map_claims();                 ///< S-32, GP-36, GP-38
std::vector<SourceClaim> bilinear_claims();                 ///< S-33
std::vector<SourceClaim> irradiance_claims(bool quick);     ///< RH-13, BJ-01
std::vector<SourceClaim> random_sample_claims(bool quick);  ///< G-15, G-99, GP-14

/// The cube map as a quadrature rule, by its size and kind of weight.
struct CubeMapError {
  int size;              ///< texels along an edge
  std::string weight;    ///< "exact", "differential", "differential scaled"
  double worst_texel;    ///< largest relative error of a weight as a solid angle
  double area;           ///< relative error of the sum of all weights
  double mean_squared;   ///< |E|^2 / 36 of the projection of a signal of 6 bands, E = sum w y y^T - 1
  double worst_squared;  ///< largest singular value of E, squared
};
std::vector<CubeMapError> cube_map_errors(const std::vector<int>& sizes);

/// Six images of signals of 6 bands, read bilinearly on each face: the integral of the squared distance to the signal,
/// for unit power, on average over all signals and for the worst.
struct BilinearError {
  double mean_squared;
  double worst_squared;
};
BilinearError bilinear_error(int size);

/// True if value, rounded at the last digit of `printed`, is `printed`: rounds_to(0.265, "0.3").
bool rounds_to(double value, const std::string& printed);

}  // namespace sh::numeric
