#include "prt/mesh/model_pictures.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace sh::prt {

Image ModelPictures::read(const std::string& name, ColorSpace space) const {
  const aiTexture* inside = scene_.GetEmbeddedTexture(name.c_str());
  if (inside == nullptr) {
    return read_image((std::filesystem::path(path_).parent_path() / name).string(), OnFlaw::kMend, space);
  }
  const std::string label = fmt::format("{}: picture {}", path_, name);
  if (inside->mHeight != 0) throw std::runtime_error(label + ": cannot be read: it is neither PNG nor JPEG");
  const std::string_view bytes(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
  return bytes.starts_with("\xff\xd8") ? read_jpeg(label, bytes, space) : read_png(label, bytes, space, OnFlaw::kMend);
}

template <class Picture, class Make>
std::shared_ptr<const Picture> ModelPictures::made(const std::string& name, const Make& make) {
  try {
    return std::make_shared<Picture>(make());
  } catch (const std::runtime_error& error) {
    flaws_.push_back(fmt::format("its picture {} is left out: {}", name, error.what()));
    return nullptr;
  }
}

std::shared_ptr<const NormalMap> ModelPictures::normal_map(const aiMaterial& material) {
  aiString name;
  if (material.Get(AI_MATKEY_TEXTURE(aiTextureType_NORMALS, 0), name) != AI_SUCCESS) return nullptr;
  float scale = 1.0F;
  material.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), scale);
  const auto [entry, added] = normal_maps_.try_emplace({name.C_Str(), scale});
  if (added) {
    entry->second = made<NormalMap>(
        name.C_Str(), [&] { return normal_map_of(name.C_Str(), read(name.C_Str(), ColorSpace::kLinear), scale); });
  }
  return entry->second;
}

std::shared_ptr<const Image> ModelPictures::picture(const aiMaterial& material, aiTextureType type, ColorSpace space) {
  aiString name;
  if (material.Get(AI_MATKEY_TEXTURE(type, 0), name) != AI_SUCCESS) return nullptr;
  const auto [entry, added] = pictures_.try_emplace({name.C_Str(), space});
  if (added) entry->second = made<Image>(name.C_Str(), [&] { return read(name.C_Str(), space); });
  return entry->second;
}

}  // namespace sh::prt
