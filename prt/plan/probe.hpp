// A probe: some vertices that stand for all vertices of a mesh. Half of it is chosen where errors are likely, so that it
// meets rare vertices, too; the rest is spread evenly. A vertex v is chosen with a known probability p_v, so that
//   mean square error = 1/V * sum over the probe of e_v^2 / p_v            [HorvitzThompson52]
// has no bias, and its standard error is about
//   1/V * sqrt(sum over the probe of (1 - p_v) e_v^4 / p_v^2).
// Where e_v^2 is itself a mean over some eyes, of the variance s_v^2, the sum also has s_v^2 / p_v [Cochran77, section 11.8].
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sh::prt {

struct Probe {
  static constexpr std::size_t kVertices = 512;  // about, at most one more
  static constexpr double kDeviations = 2.33;    // one-sided confidence
  static constexpr int kConfidence = 99;         // percent

  std::vector<std::uint32_t> vertices;  // rising
  std::vector<double> chances;          // p of each of them
};

/// likely (vertices): how large the error of each vertex may be, in any unit; all of them may be 0.
Probe choose_probe(const std::vector<double>& likely);

/// The root of the mean square plus kDeviations standard errors over all of the mesh's `vertices`; squares (of the probe),
/// and their variances where they are means, else empty.
double stated_error(const Probe& probe, const std::vector<double>& squares, std::size_t vertices,
                    const std::vector<double>& variances = {});

}  // namespace sh::prt
