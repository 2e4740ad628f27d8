// Arrays of records and the choice of the instruction set, for batch.hpp.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// A record is what a kernel takes or returns in one call: a direction is 3 values, a vector of coefficients bands^2.
// An array holds n records in one of four layouts; the caller chooses a layout for each argument:
//   plain    value k of record i at [i * size + k]: one record after the other
//   blocked  at [i / kBlock * kBlock * size + k * kBlock + i % kBlock]: blocks of kBlock records, in each of them one
//            value after the other; kBlock values are 64 bytes on every machine. The array holds whole blocks
//            (blocked_size); lanes past n are neither read nor written. The fastest, when aligned to 64 bytes.
//   shared   one record that serves all n (inputs only), e.g. one matrix for many vectors
//   interleaved  three channels, coefficient by coefficient (r g b r g b ...), as probes of engines have them: value k
//            of channel c of record i at [(i * bands^2 + k) * 3 + c]. For coefficients of three channels, and for those of
//            rotate and product: these compute each channel, and an array of another layout serves all three.
//
// The instruction set (AVX-512, AVX2 with FMA, or the compiler's own) is chosen when it is first needed. On one
// instruction set a result depends only on the values of its record: not on n, layout, alignment or position. The
// caller may therefore split a range among threads. Sums are the exception: they depend on where a range is split.
// Between instruction sets results differ by contraction: with FMA a product and the sum that it enters are rounded
// once.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sh::batch {

/// A half-precision number, IEEE 754 binary16, by its bits.
enum class Half : std::uint16_t {};

/// Records in a block: 16 of float, 8 of double.
template <class T>
inline constexpr std::size_t kBlock = 64 / sizeof(T);

enum class Layout : std::uint8_t { kPlain, kBlocked, kShared, kInterleaved };

/// An array of records and how it is laid out.
template <class T>
struct Records {
  T* data = nullptr;
  Layout layout = Layout::kPlain;
  constexpr operator Records<const T>() const noexcept { return {data, layout}; }
};

template <class T>
constexpr Records<T> plain(T* data) noexcept {
  return {data, Layout::kPlain};
}
template <class T>
constexpr Records<T> blocked(T* data) noexcept {
  return {data, Layout::kBlocked};
}
template <class T>
constexpr Records<T> shared(T* data) noexcept {
  return {data, Layout::kShared};
}
template <class T>
constexpr Records<T> interleaved(T* data) noexcept {
  return {data, Layout::kInterleaved};
}

/// Values in a blocked array of n records of `size` values.
template <class T>
constexpr std::size_t blocked_size(std::size_t n, std::size_t size) noexcept {
  return (n + kBlock<T> - 1) / kBlock<T> * kBlock<T> * size;
}

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

/// Whether this build and this machine have it.
bool available(InstructionSet set) noexcept;
/// The one in use: the widest available unless the caller set another.
InstructionSet instruction_set() noexcept;
/// Sets it for all later calls of this process. Throws std::invalid_argument when it is not available.
void use_instruction_set(InstructionSet set);

}  // namespace sh::batch
