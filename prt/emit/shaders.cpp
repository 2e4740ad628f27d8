#include "prt/emit/shaders.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::prt {

namespace {

constexpr std::size_t kTextureHeight = 16384;  // that OpenGL 4.5 promises
constexpr std::size_t kAlignment = 64;
constexpr std::string_view kFormats[] = {"R32F", "R16F", "R8_SNORM"};

}  // namespace

void Shader::use(const EmittedKernels& kernels, std::string_view name) {
  for (const auto& use : kernels.all()) {
    if (use.macro.substr(std::string_view("SH_EMITTED_").size()) != name) continue;
    if (functions.find(use.kernel.text) == std::string::npos) functions += "\n" + use.kernel.text;  // may serve twice
    define(name, use.kernel.function);
  }
}

std::size_t ShaderData::height_of(std::string_view name, std::size_t texels) {
  const std::size_t height = std::max<std::size_t>(1, (texels + kTextureWidth - 1) / kTextureWidth);
  if (height <= kTextureHeight) return height;
  throw std::invalid_argument(
      fmt::format("a texture of {} numbers for {}: expected at most {}; bake a lower degree, or rows in clusters",
                  texels, name, kTextureWidth * kTextureHeight));
}

void ShaderData::add_texture(std::string_view name, Element element, const void* numbers, std::size_t bytes) {
  const std::size_t height = height_of(name, bytes / bytes_of(element));
  std::string all(static_cast<const char*>(numbers), bytes);
  all.resize(height * kTextureWidth * bytes_of(element));
  json["textures"].push_back({{"name", name},
                              {"offset", add(all.data(), all.size())},
                              {"format", kFormats[static_cast<std::size_t>(element)]},
                              {"width", kTextureWidth},
                              {"height", height}});
}

void ShaderData::add_texture(std::string_view name, const Encoded& encoded, const TransferShape& shape) {
  add_texture(name, shape.storage.element, encoded.data.data(), encoded.data.size());
}

void ShaderData::add_attribute(std::string_view name, int location, const std::vector<Eigen::Vector3f>& values) {
  add_attribute(name, location, 3, flat(values));
}

void ShaderData::add_number(std::string_view name, int location, const std::vector<float>& values) {
  add_attribute(name, location, 1, values);
}

void ShaderData::add_faces(const std::vector<Face>& faces) {
  const std::size_t offset = add(faces.data(), faces.size() * sizeof(Face));
  json["faces"] = {{"count", faces.size()}, {"offset", offset}};
}

std::size_t ShaderData::add(const void* data, std::size_t size) {
  const std::size_t offset = bytes_.size();
  bytes_.append(static_cast<const char*>(data), size);
  bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
  return offset;
}

void ShaderData::add_attribute(std::string_view name, int location, int components, const std::vector<float>& numbers) {
  json["attributes"].push_back({{"name", name},
                                {"location", location},
                                {"components", components},
                                {"offset", add(numbers.data(), numbers.size() * sizeof(float))}});
}

}  // namespace sh::prt
