// Writes OpenEXR pictures of any channels.
#pragma once
#include <string>
#include <vector>

namespace sh::prt {

/// A channel, (height, width) row-major, the top row first. A dot separates the name of a layer from that of its channel.
struct ExrChannel {
  std::string name;
  std::vector<float> values;
};

/// The bytes of a scanline file of 32-bit floats, ZIP-compressed. Precondition: every channel has width * height values.
std::string exr_bytes(int width, int height, const std::vector<ExrChannel>& channels);

}  // namespace sh::prt
