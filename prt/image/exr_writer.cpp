#include "prt/image/exr_writer.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <cstdint>

namespace sh::prt {
namespace {

// A file in memory.
class Bytes final : public Imf::OStream {
 public:
  explicit Bytes(std::string& bytes) : Imf::OStream("memory"), bytes_(bytes) {}
  void write(const char* data, int count) override {
    const auto size = static_cast<std::size_t>(count);
    bytes_.replace(place_, size, data, size);  // longer, if it is written behind its end
    place_ += size;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

 private:
  std::string& bytes_;
  std::size_t place_ = 0;
};

}  // namespace

std::string exr_bytes(int width, int height, const std::vector<ExrChannel>& channels) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  for (const ExrChannel& channel : channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    auto* first = reinterpret_cast<char*>(const_cast<float*>(channel.values.data()));
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, first, sizeof(float), sizeof(float) * std::size_t(width)));
  }
  std::string bytes;
  {
    Bytes stream(bytes);
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
  return bytes;
}

}  // namespace sh::prt
