// The part of sharp lobes that the degree of a transfer cannot hold, from the distant light itself: a prefiltered
// environment beside SH transfer, as in [Green03, section on glossy surfaces]. The split is by band:
//   bands 0 .. degree         from the transfer: shadowed, with bounces
//   bands degree+1 .. 128     the light convolved with the lobe, looked up at the mirrored direction of view, times the
//                             visibility there (GS, GI) from its own coefficients: no bounces
// In place of BRDFs stand the lobes nearest to them (prt/mesh/fit_lobes.hpp), in these bands alone.
// Transforms are those of numeric/oracle/sphere_transform.hpp.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <map>
#include <vector>

#include "prt/mesh/fit_lobes.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Distant radiance in a unit direction, linear RGB.
using SkyRadiance = std::function<Eigen::Vector3f(const Eigen::Vector3d& direction)>;

class SharpLayer {
 public:
  static constexpr int kHighest = 128;  // holds a lobe of exponent 1000 to 1e-3
  static constexpr std::size_t kMostExponents = 64;

  /// Above `degree`, for every exponent of the lobes of the mesh. Throws std::invalid_argument for more than
  /// kMostExponents, and std::runtime_error if the sky is not finite.
  SharpLayer(const SkyRadiance& sky, int degree, Mesh mesh);

  /// What a lobe of the mesh about a unit direction gathers in the bands above the degree.
  [[nodiscard]] Eigen::Vector3f at(float exponent, const Eigen::Vector3f& direction) const;
  /// What the lobe of a vertex sends.
  [[nodiscard]] Eigen::Vector3f at(std::size_t vertex, const Eigen::Vector3f& direction) const;
  /// The lobes in place of the BRDFs of the mesh, nearest in the bands 0 .. kMaxDegree.
  [[nodiscard]] const std::vector<FittedBrdf>& fits() const { return fits_; }

 private:
  std::vector<FittedBrdf> fits_;
  std::vector<Eigen::Vector3f> specular_;  // of the vertices; empty: no lobes
  std::vector<float> exponent_;
  using Map = std::vector<Eigen::Vector3f>;  // (kRings, kAround): latitudes from +z, azimuths from +x
  std::map<float, Map> maps_;                // by exponent
};

/// The projected visibility of a place in a direction, cut to 0..1; 1 for transfer without visibility.
float visibility_towards(const Transfer& transfer, const Hit& hit, const Eigen::Vector3f& direction);

}  // namespace sh::prt
