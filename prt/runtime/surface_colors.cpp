#include "prt/runtime/surface_colors.hpp"

#include <fmt/core.h>

#include "prt/image/bilinear.hpp"

namespace sh::prt {

std::vector<Eigen::Vector3f> without_albedo(const std::vector<Eigen::Vector3f>& radiance,
                                            const std::vector<Eigen::Vector3f>& emitted,
                                            const std::vector<Eigen::Vector3f>& albedo) {
  std::vector<Eigen::Vector3f> white(radiance.size(), Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < radiance.size(); ++v) {
    for (int c = 0; c < 3; ++c) {
      const float own = emitted.empty() ? 0.0F : emitted[v][c];
      if (albedo[v][c] > 0.0F) white[v][c] = (radiance[v][c] - own) / albedo[v][c];
    }
  }
  return white;
}

DecodedPictures decoded(const Pictures& pictures, const std::string& name) {
  auto images = std::make_shared<std::vector<Image>>();
  for (std::size_t i = 0; i < pictures.heads.size(); ++i) {
    const EncodedPicture picture = pictures.at(i);
    images->push_back(read_png_or_jpeg(fmt::format("{}: picture {}", name, picture.name), picture.bytes,
                                       ColorSpace::kOfFile, OnFlaw::kMend));
  }
  return images;
}

Eigen::Vector3f SurfaceColors::at(const Hit& hit) const {
  const std::uint32_t corner = mesh_.faces[hit.face][0];
  if (!has_picture(corner)) return interpolated(hit, mesh_, albedo_);
  const Image& picture = (*pictures_)[mesh_.albedo_map[corner] - std::size_t{1}];
  const Eigen::Vector3f color = repeated(interpolated(hit, mesh_, mesh_.texture), picture);
  return interpolated(hit, mesh_, mesh_.tint).cwiseProduct(color).cwiseMin(1.0F);
}

}  // namespace sh::prt
