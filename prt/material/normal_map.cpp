#include "prt/material/normal_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include "prt/image/bilinear.hpp"

namespace sh::prt {

NormalMap normal_map_of(std::string name, const Image& image, float scale) {
  NormalMap map{std::move(name), image.width, image.height, {}};
  map.texels.reserve(3 * image.pixels.size());
  for (const Eigen::Vector3f& pixel : image.pixels) {
    const Eigen::Vector3f n = 2.0F * pixel.cwiseMax(0.0F).cwiseMin(1.0F) - Eigen::Vector3f::Ones();
    for (const float value : {scale * n.x(), scale * n.y(), n.z()}) {
      map.texels.emplace_back(std::clamp(value, -1.0F, 1.0F));
    }
  }
  return map;
}

NormalMap read_normal_map(const std::string& file, OnFlaw on_flaw) {
  return normal_map_of(std::filesystem::path(file).filename().string(), read_image(file, on_flaw, ColorSpace::kLinear));
}

std::size_t NormalMaps::first_texel(std::size_t number) const {
  std::size_t first = 0;
  for (std::size_t i = 0; i < number; ++i) {
    first += static_cast<std::size_t>(heads[i].width) * static_cast<std::size_t>(heads[i].height);
  }
  return first;
}

std::size_t NormalMaps::number_of(const NormalMap& map) {
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const bool is_alike = heads[i].name == map.name && heads[i].width == map.width && heads[i].height == map.height;
    if (is_alike && at(i) == map) return i;
  }
  if (texels.size() + map.texels.size() > 3 * kMostTexels ||
      heads.size() == std::numeric_limits<std::uint16_t>::max()) {
    throw std::runtime_error(fmt::format(
        "{}: the normal maps of a scene have more than {} texels; expected smaller ones", map.name, kMostTexels));
  }
  heads.push_back({map.name, map.width, map.height});
  texels.insert(texels.end(), map.texels.begin(), map.texels.end());
  return heads.size() - 1;
}

NormalMap NormalMaps::at(std::size_t number) const {
  const auto begin = static_cast<std::ptrdiff_t>(3 * first_texel(number));
  const auto end = static_cast<std::ptrdiff_t>(3 * first_texel(number + 1));
  const Head& head = heads[number];
  return {head.name, head.width, head.height, {texels.begin() + begin, texels.begin() + end}};
}

Eigen::Vector3f NormalMaps::normal(std::size_t number, const Eigen::Vector2f& texture) const {
  constexpr float kNoLength = 1e-3F;
  const Head& head = heads[number];
  const Eigen::half* first = texels.data() + 3 * first_texel(number);
  const Eigen::Vector3f n = repeated(texture, head.width, head.height, [&](int column, int row) {
    const Eigen::half* texel = first + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(head.width) +
                                            static_cast<std::size_t>(column));
    return Eigen::Vector3f(static_cast<float>(texel[0]), static_cast<float>(texel[1]), static_cast<float>(texel[2]));
  });
  return n.norm() > kNoLength ? n.normalized().eval() : Eigen::Vector3f::UnitZ().eval();
}

}  // namespace sh::prt
