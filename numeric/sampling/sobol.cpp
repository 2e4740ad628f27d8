// The points of Sobol'; see random.hpp.
#include "numeric/oracle/require.hpp"
#include "numeric/sampling/random.hpp"

namespace sh::numeric {
namespace {

constexpr unsigned kBits = 32;

// 0.b0 b1 b2 ... in base 2 of the index ... b2 b1 b0, times 2^32: van der Corput.
std::uint32_t first_coordinate(std::uint32_t index) {
  std::uint32_t value = 0;
  for (std::uint32_t bit = 1U << (kBits - 1); index != 0; index >>= 1U, bit >>= 1U) {
    value ^= (index & 1U) != 0 ? bit : 0U;
  }
  return value;
}

// Direction numbers of the primitive polynomial x + 1: v_k = v_(k-1) xor v_(k-1) / 2, Pascal's triangle modulo 2.
std::uint32_t second_coordinate(std::uint32_t index) {
  std::uint32_t value = 0;
  for (std::uint32_t v = 1U << (kBits - 1); index != 0; index >>= 1U, v ^= v >> 1U) value ^= (index & 1U) != 0 ? v : 0U;
  return value;
}

// Every bit is flipped or not by a coin of its own for each of the bits before it: the coin of a node of the binary
// tree, numbered like a heap.
double scrambled(std::uint32_t value, std::uint64_t key) {
  std::uint64_t node = 1;
  std::uint32_t result = 0;
  for (unsigned bit = kBits; bit-- > 0;) {
    const std::uint32_t digit = (value >> bit) & 1U;
    const std::uint32_t flip = Random(key + node).next() < 0 ? 1U : 0U;
    result |= (digit ^ flip) << bit;
    node = 2 * node + digit;
  }
  return (result + 0.5) * 0x1p-32;
}

}  // namespace

std::vector<std::array<double, 2>> sobol_points(int count, std::uint64_t seed) {
  require_range("sobol_points: count", count, 0);
  // Far apart, so that no two trees of nearby seeds share a coin.
  const std::uint64_t key = 2 * seed * 0x9FB21C651E98DF25U;
  const std::uint64_t other = (2 * seed + 1) * 0x9FB21C651E98DF25U;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    points.push_back({scrambled(first_coordinate(index), key), scrambled(second_coordinate(index), other)});
  }
  return points;
}

}  // namespace sh::numeric
