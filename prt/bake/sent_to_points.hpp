// What the surfaces of a scene send to points of space, by light: color that bounces, light that mirrors throw. For each
// point the matrix of (result_degree+1)^2 x (degree+1)^2 numbers, one a color,
//   M_rl = integral over the directions s in which the point sees a surface of y_r(s) B_l(s) ds,
// where B_l is the radiance of the surface there under the basis function y_l: its interreflected vector or, behind mirrors,
// that of the surface where the path ends, or y_l itself in the direction in which the path leaves the scene.
#pragma once
#include <vector>

#include "prt/bake/row_tracer.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// (points, 3, rows, columns) in this shape. `setup` has the points and its mesh that of `surfaces`, transfer of kind DI of the
/// degree of the shape. The bits do not depend on the number of threads. Shows progress; throws output::Interrupted on
/// request.
std::vector<float> sent_to_points(const RaySetup& setup, const Transfer& surfaces, const TransferShape& shape);

}  // namespace sh::prt
