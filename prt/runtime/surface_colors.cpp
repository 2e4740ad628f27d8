#include "prt/runtime/surface_colors.hpp"

#include <fmt/core.h>

#include "prt/image/bilinear.hpp"

namespace sh::prt {

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
  const Eigen::Vector3f color =
      repeated(interpolated(hit, mesh_, mesh_.texture), picture.width, picture.height,
               [&](int column, int row) -> const Eigen::Vector3f& { return picture.at(column, row); });
  return interpolated(hit, mesh_, mesh_.tint).cwiseProduct(color).cwiseMin(1.0F);
}

}  // namespace sh::prt
