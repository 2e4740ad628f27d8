// A sequence of pictures as one animated file (libwebp), which browsers show and repeat.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace sh::output {

/// Takes the pictures in their order: 8-bit sRGB, (height, width, 3) row-major, top row first.
class AnimatedWebp {
 public:
  /// `quality` 0 .. 100; 100 is lossless. Throws std::invalid_argument for a size WebP does not have (1 to 16383 a
  /// side), frames a second outside (0, 1000], or another quality.
  AnimatedWebp(int width, int height, double frames_a_second, int quality);
  ~AnimatedWebp();
  AnimatedWebp(const AnimatedWebp&) = delete;
  AnimatedWebp& operator=(const AnimatedWebp&) = delete;

  /// Throws std::invalid_argument for a picture of another size, std::runtime_error where libwebp fails.
  void add(std::span<const std::uint8_t> rgb);

  /// The bytes of the file, which repeats the pictures for ever. Call it once, after the last picture.
  std::string finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace sh::output
