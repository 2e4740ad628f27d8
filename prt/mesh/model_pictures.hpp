// The pictures that the materials of a model file name: files beside it, or bytes inside of it (PNG or JPEG).
#pragma once
#include <assimp/material.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "prt/material/normal_map.hpp"
#include "prt/material/pictures.hpp"

struct aiScene;

namespace sh::prt {

class ModelPictures {
 public:
  /// `path` is that of the model. Both must outlive the result.
  ModelPictures(const std::string& path, const aiScene& scene) : path_(path), scene_(scene) {}

  /// The normal map of a material, with its scale; null if it has none, or one that cannot be read.
  std::shared_ptr<const NormalMap> normal_map(const aiMaterial& material);

  /// Another picture of a material; null as above.
  std::shared_ptr<const Image> picture(const aiMaterial& material, aiTextureType type, ColorSpace space);

  /// The same as the file has it, a picture that can be read.
  std::shared_ptr<const EncodedPicture> encoded(const aiMaterial& material, aiTextureType type);

  /// One line for each picture that could not be read.
  [[nodiscard]] const std::vector<std::string>& flaws() const { return flaws_; }

 private:
  [[nodiscard]] EncodedPicture read(const std::string& name) const;
  [[nodiscard]] Image decoded(const std::string& name, ColorSpace space) const;
  // What make() returns, or null with a flaw if it throws.
  template <class Picture, class Make>
  std::shared_ptr<const Picture> made(const std::string& name, const Make& make);

  const std::string& path_;
  const aiScene& scene_;
  std::map<std::pair<std::string, float>, std::shared_ptr<const NormalMap>> normal_maps_;  // by name and scale
  std::map<std::pair<std::string, ColorSpace>, std::shared_ptr<const Image>> pictures_;
  std::map<std::string, std::shared_ptr<const EncodedPicture>> encoded_;
  std::vector<std::string> flaws_;
};

}  // namespace sh::prt
