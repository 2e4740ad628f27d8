// Densities in files: raw numbers, and NRRD ("nearly raw raster data", teem.sourceforge.net/nrrd/format.html).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "prt/medium/density.hpp"

namespace sh::prt {

struct DensityValues {
  Counts counts = {1, 1, 1};
  std::vector<float> values;  // (z, y, x)
};

/// A file that ends in .nrrd: three axes, x fastest, with the data in the same file, encoded as raw or gzip; numbers of
/// any type of NRRD but block, in either byte order. Its spacings and directions are not read. Any other file: raw
/// binary32, little-endian, x fastest, as many as the counts say. Counts of an .nrrd file must agree with the given ones.
/// Throws std::runtime_error with one line that names the file for anything else, for numbers below 0, not finite or
/// beyond single precision, and for more or fewer numbers than announced. Memory is allocated as data arrive.
DensityValues read_density(const std::string& path, const std::optional<Counts>& counts);

}  // namespace sh::prt
