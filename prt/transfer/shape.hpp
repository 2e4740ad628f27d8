// The numbers that one receiver (a vertex) stores, and their meaning. Bakes, bounces, checkpoints, files, plans and the
// run time all use this type.
//   meets      numbers of a channel                       the receiver gives
//   dot        rows x columns, row by row:                (result_degree+1)^2 coefficients; of degree 0 it is exit
//              (result_degree+1)^2 x (degree+1)^2         radiance itself: a transfer vector is a matrix of one row
//   operator   (degree+result_degree+1)^2, one row:       the product of its function with the light, projected: the
//              a function of direction                    matrix of equation (11) [SloanKautzSnyder02], exactly
//   nothing    none                                       the light itself
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "numeric/oracle/index.hpp"

namespace sh::prt {

inline constexpr int kMaxDegree = 10;

/// bands^2, the number of coefficients of degrees 0 .. degree.
constexpr std::size_t coefficient_count(int degree) { return numeric::coefficient_count(degree); }

/// The type of a number in a file: IEEE binary32, IEEE binary16, or signed 8 bits times a scale a column.
enum class Element : std::uint32_t { kSingle = 0, kHalf = 1, kByte = 2 };

/// Their names in headers and messages, in the order of Element.
inline constexpr std::array<std::string_view, 3> kElementNames = {"single", "half", "byte"};

constexpr std::size_t bytes_of(Element element) {
  return element == Element::kSingle ? 4 : element == Element::kHalf ? 2 : 1;
}

/// The numbers of a row that a file keeps, and their type; prt/transfer/storage.hpp encodes them. The rows are those of
/// the receivers, or the means and vectors of clusters that the receivers mix (prt/transfer/clusters.hpp).
struct Storage {
  Element element = Element::kSingle;
  bool one_channel = false;         // one channel is stored for all channels, which are equal
  std::vector<std::uint32_t> kept;  // columns, ascending; empty: all. The others are zeros, which no light of a shape
                                    // that meets it by `dot` may need
  std::uint32_t clusters = 0;       // 0: a row for each receiver
  std::uint32_t vectors = 0;        // of a cluster, besides its mean; a receiver has so many 8-bit weights
  [[nodiscard]] bool is_clustered() const { return clusters > 0; }
  /// True if the file stores every number as in memory.
  [[nodiscard]] bool is_plain() const {
    return element == Element::kSingle && !one_channel && kept.empty() && !is_clustered();
  }
};

enum class Meets : std::uint32_t { kDot = 0, kOperator = 1, kNothing = 2 };
inline constexpr std::array<std::string_view, 3> kMeetsNames = {"dot", "operator", "nothing"};

struct TransferShape {
  std::size_t channels = 1;  // 1: serves all colors; 3: one each, red, green, blue
  int degree = 0;            // of the incident light
  int result_degree = 0;     // of the result
  Meets meets = Meets::kDot;
  bool holds_cosine = true;   // and 1/pi: the result is exit radiance, or exit radiance over albedo; else it is the
                              // incident radiance that reaches the receiver
  bool holds_albedo = false;  // then it cannot be recolored
  Storage storage = {};

  [[nodiscard]] std::size_t rows() const { return meets == Meets::kDot ? coefficient_count(result_degree) : 1; }
  [[nodiscard]] std::size_t columns() const {
    return meets == Meets::kNothing ? 0 : coefficient_count(function_degree());
  }
  /// The degree of the functions of direction that the columns are coefficients of.
  [[nodiscard]] int function_degree() const { return meets == Meets::kOperator ? degree + result_degree : degree; }
  /// The count of numbers in memory: of a channel, and of a receiver.
  [[nodiscard]] std::size_t count() const { return rows() * columns(); }
  [[nodiscard]] std::size_t length() const { return channels * count(); }
  /// The count of numbers of a row in a file, and their bytes.
  [[nodiscard]] std::size_t stored_length() const {
    return (storage.one_channel ? 1 : channels) * rows() * (storage.kept.empty() ? columns() : storage.kept.size());
  }
  [[nodiscard]] std::size_t row_bytes() const { return stored_length() * bytes_of(storage.element); }
  /// The rows of a file with so many receivers.
  [[nodiscard]] std::size_t stored_rows(std::size_t receivers) const {
    return storage.is_clustered() ? std::size_t{storage.clusters} * (1 + storage.vectors) : receivers;
  }
  /// The bytes that a file has for each receiver alone: its row, or its cluster and weights.
  [[nodiscard]] std::size_t receiver_bytes() const {
    return storage.is_clustered() ? sizeof(std::uint16_t) + storage.vectors : row_bytes();
  }
  /// The bytes that a file has for all receivers.
  [[nodiscard]] std::size_t stored_bytes(std::size_t receivers) const {
    const std::size_t shared = storage.is_clustered() ? stored_rows(receivers) * row_bytes() : 0;
    return receivers * receiver_bytes() + shared;
  }
};

/// True if both shapes have the same numbers with the same meaning, whatever their storage.
inline bool is_alike(const TransferShape& a, const TransferShape& b) {
  return a.channels == b.channels && a.degree == b.degree && a.result_degree == b.result_degree && a.meets == b.meets &&
         a.holds_cosine == b.holds_cosine && a.holds_albedo == b.holds_albedo;
}

}  // namespace sh::prt
