// Light that scatters below surfaces: of a receiver x with the material of a body,
//   rows_c(x) += sum over the faces of the body of the integral of R_d,c(|x - y|) arriving(y) dy,
// by one dipole a color (prt/translucent/dipole.hpp). Faces are cut until R_d is smooth over each piece and then integrated
// by a rule of degree 4, so that lengths far below an edge need no finer mesh; groups of far faces count as one point
// [JensenBuhler02], in a tree over the faces of the body.
#pragma once
#include <cstddef>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// How coarsely far faces are taken: groups are at most this part of their distance from the receiver, pieces of faces
/// twice. `build/bin/bodies_bench` measures error against time; with this value the error is about 5e-3 of the light.
inline constexpr double kFarFaces = 0.3;

/// Adds to rows (vertices, 3, count) the light that scatters to each vertex of a body that scatters it. `arriving`
/// (vertices, count): irradiance over pi, by coefficients of the light. The bits do not depend on the number of threads.
/// Shows progress; throws output::Interrupted on request.
void add_scattered(const Mesh& mesh, const std::vector<float>& arriving, std::size_t count, std::vector<float>& rows,
                   double far_faces = kFarFaces);

}  // namespace sh::prt
