// The container of GLB files: a header, a chunk of JSON and a chunk of numbers [Khronos, glTF 2.0, section 4].
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace sh::prt {

inline constexpr std::uint32_t kGlbMagic = 0x46546C67, kGlbVersion = 2, kGlbJson = 0x4E4F534A, kGlbBinary = 0x004E4942;
inline constexpr std::size_t kGlbHeaderBytes = 12, kGlbChunkBytes = 8;
/// Numbers of OpenGL in glTF: the types of components, and what a buffer view is for.
inline constexpr int kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126, kVertices = 34962, kIndices = 34963;

/// What stands before the numbers: `json` and the head of a chunk of `binary_bytes`, which the caller fills up to a
/// multiple of 4; no such chunk for 0. Throws std::invalid_argument from 4 GB on.
std::string glb_front(std::string json, std::uint64_t binary_bytes);

}  // namespace sh::prt
