// Rays through bodies. From each vertex rays go inside, over the hemisphere opposite to its normal, and are followed
// through every surface that they meet:
//   thickness    the distance to the exit: where the ray has left as many surfaces as it has entered
//   transmitted  rows_c += transmission_c * integral over the inner hemisphere of
//                  exp(-sum of extinction_c * way inside) V(s) |n.s| / pi y(s) ds,
//                where V is 0 if an opaque surface stands anywhere on the way, inside or outside, else 1
// Both are sums over shared directions. The second takes the integral without attenuation in closed form as a control
// variate, as shadows do (prt/bake/steps.hpp): it is exact where nothing absorbs and nothing blocks.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/scene/options.hpp"

namespace sh::prt {

struct BodyRays {
  std::vector<float> rows;
  std::size_t open = 0;    // vertices with rays that leave no body: their surface is not closed, or its front is inside
  double share = 0.0;      // the part of such rays of those vertices, the mean; they count as blocked, of thickness 0
  std::uint64_t rays = 0;  // traced
  std::string instruction_set;
};

/// Coefficients of the distance to the exit by direction, in the unit of the scene, 0 outside of the inner hemisphere:
/// (vertices, bands^2 of options.degree). The bits do not depend on the number of threads. Shows progress; throws
/// output::Interrupted on request, and like Tracer and make_directions().
BodyRays thickness(const Mesh& mesh, const BakeOptions& options, int threads, const std::string& instruction_set);

/// Transmitted light of the vertices of bodies through which it goes along straight lines: (vertices, 3, bands^2), zeros
/// of the others. As thickness() else.
BodyRays transmitted(const Mesh& mesh, const BakeOptions& options, int threads, const std::string& instruction_set);

}  // namespace sh::prt
