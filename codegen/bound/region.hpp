// The inputs for which a bound is proved: which numbers lie in boxes and which stay symbols.
//
// Directions, quaternions, angles and single parameters are coordinates of a box. The numbers of arrays of coefficients,
// weights and colors are symbols (form.hpp). Coordinates that belong to a unit vector form a group. The inputs of a group
// are numbers of the format at a distance of at most 2 epsilon from the sphere, as any careful normalization gives them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/bound/format.hpp"
#include "codegen/families/family.hpp"

namespace sh::codegen::bound {

using Box = std::vector<Interval>;

/// Coordinates of one unit vector.
struct UnitVector {
  int first = 0;
  int size = 3;
};

/// The domain of a kernel.
struct Region {
  std::vector<int> coordinate;  ///< for every flattened input: its coordinate in the box; -1: a symbol
  std::vector<UnitVector> unit_vectors;
  Interval length = {1, 1};    ///< of the unit vectors, squared
  std::vector<Interval> root;  ///< the box that holds everything
  int logarithmic = -1;        ///< the coordinate whose size goes to zero at both ends of its range; -1: none
  /// True for vectors of any length: every node is homogeneous in them, so length 1 stands for all lengths.
  bool homogeneous = false;
  Interval lengths = {1, 1};  ///< of homogeneous vectors
  std::string text;           ///< for people
};

/// Throws std::domain_error, which says why, for a kernel with inputs that no bound covers.
Region region_of(const Kernel& kernel, const Domain& domain, const Format& format);

/// The part of a box that can meet the unit vectors, or nothing.
std::optional<Box> contracted(Box box, const Region& region);
/// Boxes that cover the region, to start with.
std::vector<Box> first_boxes(const Region& region, const Format& format);
/// The two halves of a box along its longest side, as far as they meet the region.
std::vector<Box> halves(const Box& box, const Region& region);

}  // namespace sh::codegen::bound
