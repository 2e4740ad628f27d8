// Turntables, tone curves and the animated file.
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <cmath>
#include <cstring>

#include "numeric/output/webp.hpp"
#include "prt/image/tone_map.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/scene/camera.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Camera some_camera() {
  Camera camera;
  camera.position = {3.0, -4.0, 2.5};
  camera.target = {0.5, 0.25, 1.0};
  camera.up = {0.1, 0.0, 1.0};
  return camera;
}

constexpr Turntable kTurntables[] = {Turntable::kNone, Turntable::kLight, Turntable::kCamera, Turntable::kObject};

TEST(ViewAt, BeginsWithTheCameraAndTheLightAsTheyAre) {
  for (const Turntable turntable : kTurntables) {
    const View view = view_at(turntable, some_camera(), 0.0);
    EXPECT_EQ(view.camera.position, some_camera().position);
    EXPECT_EQ(view.camera.up, some_camera().up);
    EXPECT_EQ(view.light_turn, Eigen::Matrix3d::Identity());
  }
}

TEST(ViewAt, TurnsRightHandedAboutTheVerticalThroughTheTarget) {
  const Camera camera = some_camera();
  const View quarter = view_at(Turntable::kCamera, camera, 0.25);
  EXPECT_LT((quarter.camera.position - Eigen::Vector3d(0.5 + 4.25, 0.25 + 2.5, 2.5)).norm(), 1e-12);
  EXPECT_EQ(quarter.camera.target, camera.target);
  EXPECT_EQ(quarter.light_turn, Eigen::Matrix3d::Identity());
  const View light = view_at(Turntable::kLight, camera, 0.25);
  EXPECT_EQ(light.camera.position, camera.position);
  EXPECT_LT((light.light_turn * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST(ViewAt, TurningTheObjectIsTurningCameraAndLightBack) {
  const View object = view_at(Turntable::kObject, some_camera(), 0.3);
  const View camera = view_at(Turntable::kCamera, some_camera(), -0.3);
  const View light = view_at(Turntable::kLight, some_camera(), -0.3);
  EXPECT_LT((object.camera.position - camera.camera.position).norm(), 1e-12);
  EXPECT_LT((object.light_turn - light.light_turn).norm(), 1e-12);
}

TEST(ToneMap, ReinhardIsLOverOnePlusLAndLinearClips) {
  EXPECT_NEAR(reinhard(Eigen::Vector3f::Constant(3.0F)).x(), 0.75F, 1e-6F);
  EXPECT_NEAR(reinhard({0.0F, 2.0F, 0.0F}).y(), 2.0F / (1.0F + 2.0F * 0.7152F), 1e-6F);
  const std::vector<Eigen::Vector3f> gray{Eigen::Vector3f::Constant(0.25F), Eigen::Vector3f::Constant(5.0F)};
  EXPECT_EQ(tone_map(gray, 1.0F, ToneCurve::kLinear), (std::vector<std::uint8_t>{137, 137, 137, 255, 255, 255}));
  EXPECT_EQ(tone_map(gray, 1.0F), tone_map(gray, 1.0F, ToneCurve::kNeutral));
  EXPECT_LT(tone_map(gray, 1.0F, ToneCurve::kReinhard).back(), 245);
}

/// Pictures of a colored gradient that moves.
std::vector<std::uint8_t> moving_picture(int width, int height, int frame) {
  std::vector<std::uint8_t> rgb;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      rgb.push_back(static_cast<std::uint8_t>(8 * column + 5 * frame));
      rgb.push_back(static_cast<std::uint8_t>(8 * row));
      rgb.push_back(static_cast<std::uint8_t>(7 * (row + column + frame)));
    }
  }
  return rgb;
}

struct Decoded {
  std::vector<std::vector<std::uint8_t>> frames;  // RGB
  std::vector<int> ends;                          // ms
  WebPAnimInfo info;
};

Decoded decode(const std::string& bytes) {
  Decoded decoded;
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  EXPECT_NE(decoder, nullptr);
  WebPAnimDecoderGetInfo(decoder, &decoded.info);
  while (WebPAnimDecoderHasMoreFrames(decoder) != 0) {
    std::uint8_t* rgba = nullptr;
    WebPAnimDecoderGetNext(decoder, &rgba, &decoded.ends.emplace_back());
    std::vector<std::uint8_t>& rgb = decoded.frames.emplace_back();
    for (std::size_t i = 0; i < std::size_t{decoded.info.canvas_width} * decoded.info.canvas_height; ++i) {
      rgb.insert(rgb.end(), rgba + 4 * i, rgba + 4 * i + 3);
    }
  }
  WebPAnimDecoderDelete(decoder);
  return decoded;
}

TEST(AnimatedWebp, LosslessHoldsEveryPixelOfEveryFrameAndItsTime) {
  output::AnimatedWebp animation(31, 17, 30.0, 100);
  for (int k = 0; k < 5; ++k) animation.add(moving_picture(31, 17, k));
  const Decoded decoded = decode(animation.finish());
  ASSERT_EQ(decoded.frames.size(), 5U);
  EXPECT_EQ(decoded.ends, (std::vector<int>{33, 67, 100, 133, 167}));  // whole milliseconds that do not drift
  EXPECT_EQ(decoded.info.loop_count, 0U) << "for ever";
  for (int k = 0; k < 5; ++k) EXPECT_EQ(decoded.frames[k], moving_picture(31, 17, k)) << k;
}

TEST(AnimatedWebp, LessQualityIsNearTheSameBytesEachTimeAndSmaller) {
  const auto made = [](int quality) {
    output::AnimatedWebp animation(64, 48, 24.0, quality);
    for (int k = 0; k < 3; ++k) animation.add(moving_picture(64, 48, k));
    return animation.finish();
  };
  const std::string good = made(90);
  EXPECT_EQ(good, made(90));
  EXPECT_LT(made(20).size(), good.size());
  EXPECT_EQ(decode(good).frames.size(), 3U);
}

TEST(AnimatedWebp, WhatItCannotHoldIsRefused) {
  EXPECT_EQ(message_of([] { output::AnimatedWebp(16384, 1, 24.0, 90); }),
            "expected a WebP picture with sides of 1 to 16383 pixels, got 16384 x 1");
  EXPECT_NE(message_of([] { output::AnimatedWebp(8, 8, 0.0, 90); }).find("frames a second"), std::string::npos);
  EXPECT_NE(message_of([] { output::AnimatedWebp(8, 8, std::nan(""), 90); }).find("frames a second"),
            std::string::npos);
  EXPECT_NE(message_of([] { output::AnimatedWebp(8, 8, 24.0, 101); }).find("a quality of 0 to 100, got 101"),
            std::string::npos);
  output::AnimatedWebp animation(8, 8, 24.0, 90);
  EXPECT_EQ(message_of([&] { animation.add(std::vector<std::uint8_t>(5)); }),
            "expected the bytes of a picture of 8 x 8 pixels, got 5");
}

}  // namespace
}  // namespace sh::prt::test
