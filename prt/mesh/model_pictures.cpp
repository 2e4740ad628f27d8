#include "prt/mesh/model_pictures.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace sh::prt {

EncodedPicture ModelPictures::read(const std::string& name) const {
  const aiTexture* inside = scene_.GetEmbeddedTexture(name.c_str());
  if (inside == nullptr) {
    std::string file = name;
    std::replace(file.begin(), file.end(), '\\', '/');  // names from Windows
    return {name, read_picture_file((std::filesystem::path(path_).parent_path() / file).lexically_normal().string())};
  }
  if (inside->mHeight != 0) throw std::runtime_error("it is neither PNG nor JPEG");
  return {name, std::string(reinterpret_cast<const char*>(inside->pcData), inside->mWidth)};
}

Image ModelPictures::decoded(const std::string& name, ColorSpace space) const {
  return read_png_or_jpeg(fmt::format("{}: picture {}", path_, name), read(name).bytes, space, OnFlaw::kMend);
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
        name.C_Str(), [&] { return normal_map_of(name.C_Str(), decoded(name.C_Str(), ColorSpace::kLinear), scale); });
  }
  return entry->second;
}

std::shared_ptr<const Image> ModelPictures::picture(const aiMaterial& material, aiTextureType type, ColorSpace space) {
  aiString name;
  if (material.Get(AI_MATKEY_TEXTURE(type, 0), name) != AI_SUCCESS) return nullptr;
  const auto [entry, added] = pictures_.try_emplace({name.C_Str(), space});
  if (added) entry->second = made<Image>(name.C_Str(), [&] { return decoded(name.C_Str(), space); });
  return entry->second;
}

std::shared_ptr<const EncodedPicture> ModelPictures::encoded(const aiMaterial& material, aiTextureType type) {
  if (picture(material, type, ColorSpace::kOfFile) == nullptr) return nullptr;
  aiString name;
  material.Get(AI_MATKEY_TEXTURE(type, 0), name);
  std::shared_ptr<const EncodedPicture>& known = encoded_[name.C_Str()];
  if (known == nullptr) known = std::make_shared<EncodedPicture>(read(name.C_Str()));
  return known;
}

}  // namespace sh::prt
