#include "prt/commands/frames.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/png.hpp"
#include "prt/commands/commands.hpp"

namespace sh::prt {

void require_frames(int frames) {
  constexpr int kMaxFrames = 1000;
  if (frames < 1 || frames > kMaxFrames) {
    throw std::invalid_argument(fmt::format("--frames {}: expected 1 to {}", frames, kMaxFrames));
  }
}

std::string frame_name(const std::string& output, int frame, int frames) {
  if (frames == 1) return output;
  const std::filesystem::path path(output);
  const std::string name = fmt::format("{}_{:03}{}", path.stem().string(), frame, path.extension().string());
  return (path.parent_path() / name).string();
}

PictureFiles::PictureFiles(std::string output, int frames, int width, int height, const AnimationOptions& options)
    : output_(std::move(output)), frames_(frames), width_(width), height_(height) {
  require_frames(frames);
  if (std::filesystem::path(output_).extension() == ".webp") {
    animation_ = std::make_unique<output::AnimatedWebp>(width, height, options.frames_a_second, options.quality);
  }
  require_writable(name(0));
}

std::string PictureFiles::name(int frame) const { return animation_ ? output_ : frame_name(output_, frame, frames_); }

void PictureFiles::add(int frame, std::span<const std::uint8_t> rgb) {
  if (animation_) {
    animation_->add(rgb);
  } else {
    output::write_png(name(frame), width_, height_, rgb);
  }
}

void PictureFiles::finish() {
  if (animation_) output::write_file(output_, animation_->finish());
}

}  // namespace sh::prt
