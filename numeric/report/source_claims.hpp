// Numbers that the sources state about sampling and truncation, measured again.
//
// Output: a row a claim, ready for a table. Everything is computed here, by quadrature or with samples of fixed seeds:
// the same bits in every run on one machine.
#pragma once

#include <string>
#include <vector>

namespace sh::numeric {

struct SourceClaim {
  std::string claim;    // in words: "6 images of 4 x 4, mean squared error of a signal of 6 bands"
  std::string source;   // author, year, place
  std::string printed;  // the number as printed, without its unit: "0.3"
  double measured;      // in the same unit
  std::string unit;     // "%" or ""
  bool reproduced;      // the measured number is the printed one, to its digits or within the spread that `how` states
  std::string how;      // the experiment in a sentence
};

// All of the below, in the order in which they are declared. Quick: under two seconds; full: more seeds and lights.
std::vector<SourceClaim> source_claims(bool quick);

std::vector<SourceClaim> cube_map_claims();              // Sloan, Kautz, Snyder 2002, 6.2; gpfault 2026
std::vector<SourceClaim> bilinear_claims();              // Sloan, Kautz, Snyder 2002, 6.2
std::vector<SourceClaim> irradiance_claims(bool quick);  // Ramamoorthi, Hanrahan 2001; Brown 2004; Basri, Jacobs 2003
std::vector<SourceClaim> random_sample_claims(bool quick);  // Green 2003; gpfault 2026

// The cube map as a quadrature rule, by its size and kind of weight.
struct CubeMapError {
  int size;              // texels along an edge
  std::string weight;    // "exact", "differential", "differential scaled"
  double worst_texel;    // largest relative error of a weight as a solid angle
  double area;           // relative error of the sum of all weights
  double mean_squared;   // |E|^2 / 36 of the projection of a signal of 6 bands, E = sum w y y^T - 1
  double worst_squared;  // largest singular value of E, squared
};
std::vector<CubeMapError> cube_map_errors(const std::vector<int>& sizes);

// Six images of signals of 6 bands, read bilinearly on each face: the integral of the squared distance to the signal,
// for unit power, on average over all signals and for the worst.
struct BilinearError {
  double mean_squared;
  double worst_squared;
};
BilinearError bilinear_error(int size);

// True if value, rounded at the last digit of `printed`, is `printed`: rounds_to(0.265, "0.3").
bool rounds_to(double value, const std::string& printed);

}  // namespace sh::numeric
