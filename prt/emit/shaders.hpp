// The shaders of an emitted run time, and their data.
#pragma once
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "prt/emit/parts.hpp"

namespace sh::prt {

inline constexpr std::size_t kTextureWidth = 2048;

/// A shader in the making: its kernels, the macros of its texts, and these files of prt/shaders.
struct Shader {
  std::string file;
  std::string functions;
  std::string defines;
  std::vector<std::string_view> texts;

  template <class Value>
  void define(std::string_view name, const Value& value) {
    defines += fmt::format("#define {} {}\n", name, value);
  }
  /// The kernel SH_EMITTED_<name>, if there is one, under its name.
  void use(const EmittedKernels& kernels, std::string_view name);
};

/// relight.bin, and relight.json, which says what stands where.
class ShaderData {
 public:
  using Json = nlohmann::ordered_json;

  /// Numbers of `bytes` in all, one a texel. Throws std::invalid_argument for more than OpenGL 4.5 promises.
  void add_texture(std::string_view name, Element element, const void* numbers, std::size_t bytes);
  void add_texture(std::string_view name, const Encoded& encoded, const TransferShape& shape);
  void add_attribute(std::string_view name, int location, const std::vector<Eigen::Vector3f>& values);
  void add_number(std::string_view name, int location, const std::vector<float>& values);
  /// Three indices of vertices each, unsigned 32 bits.
  void add_faces(const std::vector<Face>& faces);
  /// The rows of a texture; throws like add_texture.
  static std::size_t height_of(std::string_view name, std::size_t texels);

  Json json = Json::object();
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::size_t add(const void* data, std::size_t size);
  void add_attribute(std::string_view name, int location, int components, const std::vector<float>& numbers);

  std::string bytes_;
};

}  // namespace sh::prt
