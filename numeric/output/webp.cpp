#include "numeric/output/webp.hpp"

#include <fmt/core.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <stdexcept>

namespace sh::output {

namespace {

WebPConfig config_of(int quality) {
  WebPConfig config;
  WebPConfigInit(&config);
  config.quality = static_cast<float>(quality);
  config.lossless = quality == 100 ? 1 : 0;
  config.use_sharp_yuv = 1;  // colored edges stay sharp
  return config;
}

}  // namespace

struct AnimatedWebp::Encoder {
  int width;
  int height;
  double frames_a_second;
  WebPConfig config;
  int frames = 0;
  WebPAnimEncoder* handle = nullptr;

  /// When the picture begins, whole milliseconds: rounded, so that the sequence keeps its length.
  [[nodiscard]] int begin_of(int frame) const {
    return static_cast<int>(std::lround(1000.0 * frame / frames_a_second));
  }

  [[noreturn]] void fail(const char* what) const {
    throw std::runtime_error(fmt::format("cannot make an animated WebP: {}", what));
  }
};

AnimatedWebp::AnimatedWebp(int width, int height, double frames_a_second, int quality) {
  if (width < 1 || height < 1 || width > WEBP_MAX_DIMENSION || height > WEBP_MAX_DIMENSION) {
    throw std::invalid_argument(fmt::format("expected a WebP picture with sides of 1 to {} pixels, got {} x {}",
                                            WEBP_MAX_DIMENSION, width, height));
  }
  if (!(frames_a_second > 0.0 && frames_a_second <= 1000.0)) {
    throw std::invalid_argument(
        fmt::format("expected more than 0 and at most 1000 frames a second, got {}", frames_a_second));
  }
  if (quality < 0 || quality > 100) {
    throw std::invalid_argument(fmt::format("expected a quality of 0 to 100, got {}", quality));
  }
  WebPAnimEncoderOptions options;
  WebPAnimEncoderOptionsInit(&options);
  encoder_ = std::make_unique<Encoder>(Encoder{width, height, frames_a_second, config_of(quality)});
  encoder_->handle = WebPAnimEncoderNew(width, height, &options);
  if (encoder_->handle == nullptr) encoder_->fail("out of memory");
}

AnimatedWebp::~AnimatedWebp() { WebPAnimEncoderDelete(encoder_->handle); }

void AnimatedWebp::add(std::span<const std::uint8_t> rgb) {
  Encoder& e = *encoder_;
  if (rgb.size() != std::size_t{3} * static_cast<std::size_t>(e.width) * static_cast<std::size_t>(e.height)) {
    throw std::invalid_argument(
        fmt::format("expected the bytes of a picture of {} x {} pixels, got {}", e.width, e.height, rgb.size()));
  }
  WebPPicture picture;
  WebPPictureInit(&picture);
  picture.width = e.width;
  picture.height = e.height;
  picture.use_argb = 1;
  const bool added = WebPPictureImportRGB(&picture, rgb.data(), 3 * e.width) != 0 &&
                     WebPAnimEncoderAdd(e.handle, &picture, e.begin_of(e.frames), &e.config) != 0;
  WebPPictureFree(&picture);
  if (!added) e.fail(WebPAnimEncoderGetError(e.handle));
  ++e.frames;
}

std::string AnimatedWebp::finish() {
  Encoder& e = *encoder_;
  WebPData data;
  WebPDataInit(&data);
  if (WebPAnimEncoderAdd(e.handle, nullptr, e.begin_of(e.frames), nullptr) == 0 ||
      WebPAnimEncoderAssemble(e.handle, &data) == 0) {
    WebPDataClear(&data);
    e.fail(WebPAnimEncoderGetError(e.handle));
  }
  std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
  WebPDataClear(&data);
  return bytes;
}

}  // namespace sh::output
