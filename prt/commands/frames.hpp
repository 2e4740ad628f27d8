// The output files of a sequence: one picture or mesh for each frame, or one animated file.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "numeric/output/webp.hpp"

namespace sh::prt {

/// Throws std::invalid_argument unless 1 <= frames <= 1000, so that frame numbers have three digits.
void require_frames(int frames);

/// out.png -> out_000.png, ...; a single frame keeps its name.
std::string frame_name(const std::string& output, int frame, int frames);

struct AnimationOptions {
  double frames_a_second = 24.0;
  int quality = 90;  // 100: lossless
};

/// Writes one PNG file for each frame, or one WebP file with all frames if `output` ends in .webp.
class PictureFiles {
 public:
  /// Throws if the first file cannot be written or if the options are invalid.
  PictureFiles(std::string output, int frames, int width, int height, const AnimationOptions& options);
  /// The file to which frame `frame` is written.
  [[nodiscard]] std::string name(int frame) const;
  /// Adds the next frame, in 8-bit sRGB. Frames must come in order.
  void add(int frame, std::span<const std::uint8_t> rgb);
  void finish();

 private:
  std::string output_;
  int frames_;
  int width_;
  int height_;
  std::unique_ptr<output::AnimatedWebp> animation_;  // none: PNG files
};

}  // namespace sh::prt
