// The files of a sequence: a picture or a mesh each, or one animated file.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "numeric/output/webp.hpp"

namespace sh::prt {

/// Throws std::invalid_argument unless 1 to 1000, whose numbers have three digits.
void require_frames(int frames);

/// out.png -> out_000.png, ...; a single frame keeps its name.
std::string frame_name(const std::string& output, int frame, int frames);

struct AnimationOptions {
  double frames_a_second = 24.0;
  int quality = 90;  // 100: lossless
};

/// PNG files, one a frame, or one WebP file with all of them, where `output` ends in .webp.
class PictureFiles {
 public:
  /// Throws where the first file could not be written, or for options that cannot be used.
  PictureFiles(std::string output, int frames, int width, int height, const AnimationOptions& options);
  /// What frame `frame` is written to.
  [[nodiscard]] std::string name(int frame) const;
  /// Frames in their order; 8-bit sRGB.
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
