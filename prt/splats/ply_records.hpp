// The records of a PLY file of any encoding, as little-endian bytes; and where the numbers of a splat stand in them.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "prt/splats/ply_header.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {

/// Reads a text body into memory, once; binary ones as they are asked for.
class PlyRecords {
 public:
  /// Throws std::runtime_error with one line for a text body that is not what the header announces.
  PlyRecords(const InputFile& file, const PlyHeader& header);

  /// (count, record_size) bytes.
  void read(std::size_t first, std::size_t count, char* to) const;

 private:
  const InputFile& file_;
  const PlyHeader& header_;
  std::string text_;  // the records of a text file
};

/// Copies numbers between records and a block. Missing normals are zeros.
class PlySplatMap {
 public:
  PlySplatMap(const std::vector<PlyProperty>& properties, std::size_t record_size, int degree);

  /// Everything of a block of that size from its records, in this project's convention.
  void take(const char* records, SplatBlock& block) const;
  /// Writes these parts of a block into its records.
  void put(const SplatBlock& block, const SplatParts& parts, char* records) const;

 private:
  struct Place {
    std::size_t offset;
    bool is_double;
  };
  // Numbers of one array of the block that stand in a record.
  struct Places {
    std::vector<Place> all;
    bool is_run = true;  // floats, one after another

    void add(const Place& place);
  };

  static void take_row(const Places& places, const char* record, float* row);
  static void put_row(const Places& places, const float* row, char* record);

  std::size_t record_size_;
  Places position_, normal_, rotation_, scale_, opacity_;
  Places constant_, rest_;    // coefficients of degree 0 (3), and the others (3, bands^2 - 1)
  std::vector<float> signs_;  // (bands^2), theirs from ours
};

}  // namespace sh::prt
