// exr_as IN OUT COMPRESSION half|float increasing|decreasing: writes the colors of an OpenEXR picture once more, by the OpenEXR
// library, beside channels of other types and with a data window that is not at the origin. COMPRESSION: its number.
#include <ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <half.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

const Imath::V2i kOrigin(-3, 7);

void add(Imf::Header& header, Imf::FrameBuffer& buffer, const std::string& name, Imf::PixelType type, std::size_t size,
         const void* first, std::size_t width) {
  header.channels().insert(name, Imf::Channel(type));
  buffer.insert(name, Imf::Slice::Make(type, first, kOrigin, std::int64_t(width), 1, size, size * width));
}

void write_again(const char* in, const char* out, Imf::Compression compression, bool is_half, Imf::LineOrder order) {
  Imf::InputFile input(in);
  const Imath::Box2i window = input.header().dataWindow();
  const auto width = std::size_t(window.max.x - window.min.x + 1);
  const auto height = std::size_t(window.max.y - window.min.y + 1);
  std::vector<std::vector<float>> colors(3, std::vector<float>(width * height));
  const std::string names[] = {"R", "G", "B"};
  Imf::FrameBuffer read;
  for (std::size_t c = 0; c < 3; ++c) {
    read.insert(names[c], Imf::Slice::Make(Imf::FLOAT, colors[c].data(), window, sizeof(float), sizeof(float) * width));
  }
  input.setFrameBuffer(read);
  input.readPixels(window.min.y, window.max.y);

  Imf::Header header(window, Imath::Box2i(kOrigin, kOrigin + window.max - window.min), 1.0F, Imath::V2f(0, 0), 1.0F,
                     order, compression);
  Imf::FrameBuffer written;
  std::vector<std::vector<half>> halves;
  for (const std::vector<float>& color : colors) halves.emplace_back(color.begin(), color.end());
  for (std::size_t c = 0; c < 3; ++c) {
    if (is_half)
      add(header, written, names[c], Imf::HALF, sizeof(half), halves[c].data(), width);
    else
      add(header, written, names[c], Imf::FLOAT, sizeof(float), colors[c].data(), width);
  }
  std::vector<std::uint32_t> numbers(width * height);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::uint32_t(i * i);
  add(header, written, "A", Imf::HALF, sizeof(half), halves[1].data(), width);
  add(header, written, "Id", Imf::UINT, sizeof(std::uint32_t), numbers.data(), width);
  add(header, written, "Z", Imf::FLOAT, sizeof(float), colors[0].data(), width);
  Imf::OutputFile file(out, header, 0);
  file.setFrameBuffer(written);
  file.writePixels(int(height));
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fputs("exr_as: expected IN OUT COMPRESSION half|float increasing|decreasing\n", stderr);
    return 2;
  }
  const bool is_increasing = std::string(words[5]) == "increasing";
  write_again(words[1], words[2], Imf::Compression(std::atoi(words[3])), std::string(words[4]) == "half",
              is_increasing ? Imf::INCREASING_Y : Imf::DECREASING_Y);
  return 0;
}
