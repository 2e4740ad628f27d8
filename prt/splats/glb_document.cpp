#include "prt/splats/glb_document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "numeric/output/parse_json.hpp"
#include "numeric/output/printable.hpp"
#include "prt/binary/glb_container.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/splats/glb_splats.hpp"

namespace sh::prt {
namespace {

constexpr std::uint64_t kLongestJson = std::uint64_t{1} << 26U;
constexpr double kMostBytes = 4294967295.0;

std::uint64_t whole(const JsonReader& value) {
  const double number = value.number(0.0, kMostBytes, "a whole number");
  if (number != std::floor(number)) value.expected("a whole number");
  return static_cast<std::uint64_t>(number);
}

std::uint64_t whole_or(const JsonReader& object, std::string_view key, std::uint64_t otherwise) {
  const auto value = object.find(key);
  return value ? whole(*value) : otherwise;
}

/// The element of an array at the top that another value refers to.
JsonReader referred(const JsonReader& root, std::string_view array, const JsonReader& index) {
  const std::vector<JsonReader> items = root.items(array);
  const std::uint64_t i = whole(index);
  if (i >= items.size()) index.expected(fmt::format("one of the {} {}", items.size(), array));
  return items[i];
}

struct Chunks {
  std::string json;
  std::uint64_t binary = 0;  // offset
  std::uint64_t binary_size = 0;
};

Chunks read_chunks(const InputFile& file) {
  const std::string start = file.start(20);
  std::array<std::uint32_t, 5> head{};  // magic, version, size; size and type of the first chunk
  if (start.size() < 20 || !start.starts_with("glTF")) file.fail("not a GLB file: expected `glTF` in its first bytes");
  std::memcpy(head.data(), start.data(), start.size());
  if (head[1] != kGlbVersion) file.fail(fmt::format("GLB of version {}: expected version 2", head[1]));
  if (head[2] > file.size()) file.fail(fmt::format("truncated: expected {} bytes, got {}", head[2], file.size()));
  if (head[2] < file.size()) {
    file.fail(fmt::format("the header announces {} bytes, the file has {}", head[2], file.size()));
  }
  if (head[4] != kGlbJson || head[3] > kLongestJson || 20 + std::uint64_t{head[3]} > file.size()) {
    file.fail("GLB: expected a JSON chunk first, within the file");
  }
  Chunks chunks;
  chunks.json.resize(head[3]);
  file.read(20, chunks.json.data(), chunks.json.size());
  const std::uint64_t next = 20 + std::uint64_t{head[3]};
  std::array<std::uint32_t, 2> second{};
  if (next + sizeof second > file.size()) file.fail("GLB: expected a binary chunk with the splats, got none");
  file.read(next, second.data(), sizeof second);
  chunks.binary = next + sizeof second;
  chunks.binary_size = second[0];
  if (second[1] != kGlbBinary || chunks.binary + chunks.binary_size > file.size()) {
    file.fail("GLB: expected a binary chunk after the JSON chunk, within the file");
  }
  return chunks;
}

struct Primitive {
  std::size_t mesh;
  JsonReader json;
};

/// The only primitive with the extension.
Primitive find_primitive(const JsonReader& root, const InputFile& file) {
  std::optional<Primitive> found;
  const std::vector<JsonReader> meshes = root.items("meshes");
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    for (const JsonReader& primitive : meshes[mesh].items("primitives")) {
      const auto extensions = primitive.find("extensions");
      if (!extensions || !extensions->find(kSplatExtension)) continue;
      if (found) file.fail(fmt::format("expected one primitive with {}, got several", kSplatExtension));
      found = Primitive{mesh, primitive};
    }
  }
  if (!found) file.fail(fmt::format("expected splats: a primitive with the extension {}, got none", kSplatExtension));
  return *found;
}

Eigen::Matrix4d matrix_of(const JsonReader& node) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  const auto numbers = [&](const JsonReader& array, Eigen::Index count, double* to) {
    const std::vector<JsonReader> items = array.items();
    if (items.size() != static_cast<std::size_t>(count)) array.expected(fmt::format("{} numbers", count));
    for (const JsonReader& item : items) *to++ = item.real();
  };
  if (const auto whole_matrix = node.find("matrix")) {
    numbers(*whole_matrix, 16, matrix.data());  // column by column, as Eigen has it
    return matrix;
  }
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  if (const auto value = node.find("translation")) numbers(*value, 3, move.data());
  if (const auto value = node.find("scale")) numbers(*value, 3, scale.data());
  if (const auto value = node.find("rotation")) numbers(*value, 4, turn.coeffs().data());  // x, y, z, w as in Eigen
  matrix.topLeftCorner<3, 3>() = turn.toRotationMatrix() * scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = move;
  return matrix;
}

Similarity similarity_of(const Eigen::Matrix4d& matrix, const InputFile& file) {
  if (matrix.isIdentity(0.0)) return {};
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  const double scale = std::cbrt(linear.determinant());
  constexpr double kRounded = 1e-4;
  const bool is_similar = scale > 0.0 && std::isfinite(scale) &&
                          (linear.transpose() * linear / (scale * scale)).isIdentity(kRounded) &&
                          matrix.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
  if (!is_similar) {
    file.fail(
        "the node of the splats stretches or mirrors them; expected a rotation, a uniform scale and a translation");
  }
  return {checked_rotation(linear / scale, "the node of the splats"), scale, matrix.topRightCorner<3, 1>()};
}

/// From the splats to the scene.
Similarity placement_of(const JsonReader& root, std::size_t mesh, const InputFile& file) {
  const std::vector<JsonReader> nodes = root.items("nodes");
  std::vector<std::size_t> parents(nodes.size(), nodes.size());
  std::vector<std::size_t> with_splats;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].find("mesh") && whole(nodes[n].at("mesh")) == mesh) with_splats.push_back(n);
    for (const JsonReader& child : nodes[n].items("children")) {
      const std::uint64_t c = whole(child);
      if (c >= nodes.size() || parents[c] != nodes.size()) child.expected("a node that has no other parent");
      parents[c] = n;
    }
  }
  if (with_splats.size() > 1) {
    file.fail(fmt::format("expected one node with the splats, got {}", with_splats.size()));
  }
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  std::size_t steps = 0;
  for (std::size_t n = with_splats.empty() ? nodes.size() : with_splats[0]; n < nodes.size(); n = parents[n]) {
    if (++steps > nodes.size()) file.fail("expected nodes without a loop among their parents");
    matrix = matrix_of(nodes[n]) * matrix;
  }
  return similarity_of(matrix, file);
}

bool is_allowed(GlbPart part, int type, bool normalized) {
  constexpr int kByte = 5120;
  constexpr int kUnsignedByte = 5121;
  constexpr int kShort = 5122;
  constexpr int kUnsignedShort = 5123;
  constexpr int kFloat = 5126;
  if (type == kFloat) return !normalized;
  const bool is_signed = type == kByte || type == kShort;
  const bool is_unsigned = type == kUnsignedByte || type == kUnsignedShort;
  switch (part) {
    case GlbPart::kPosition:
      return is_signed || is_unsigned;  // KHR_mesh_quantization
    case GlbPart::kRotation:
      return is_signed && normalized;
    case GlbPart::kScale:
      return is_unsigned;
    case GlbPart::kOpacity:
      return is_unsigned && normalized;
    case GlbPart::kHarmonics:
      return false;
  }
  return false;
}

GlbColumn column_of(const JsonReader& root, const JsonReader& index, const GlbAttribute& attribute,
                    const Chunks& chunks, std::uint64_t& count) {
  const JsonReader accessor = referred(root, "accessors", index);
  GlbColumn column{attribute, accessor.at("componentType").integer(0, 1 << 20), false, 0, 0, 0};
  if (const auto normalized = accessor.find("normalized")) column.normalized = normalized->boolean();
  if (!is_allowed(attribute.part, column.component_type, column.normalized)) {
    accessor.expected(fmt::format("a component type that {} may have, such as 5126 (float)", attribute.name));
  }
  if (accessor.at("type").text() != glb_type(attribute.components)) {
    accessor.expected(fmt::format("the type {} for {}", glb_type(attribute.components), attribute.name));
  }
  if (accessor.find("sparse")) accessor.expected("an accessor that is not sparse");
  count = whole(accessor.at("count"));
  const JsonReader view = referred(root, "bufferViews", accessor.at("bufferView"));
  if (whole(view.at("buffer")) != 0 || root.items("buffers").empty() || root.items("buffers")[0].find("uri")) {
    view.expected("the buffer 0, which is the binary chunk of this file");
  }
  const std::uint64_t view_offset = whole_or(view, "byteOffset", 0);
  const std::uint64_t view_size = whole(view.at("byteLength"));
  const std::uint64_t offset = whole_or(accessor, "byteOffset", 0);
  column.size = attribute.components * size_of_component(column.component_type);
  column.stride = whole_or(view, "byteStride", column.size);
  column.offset = chunks.binary + view_offset + offset;
  constexpr std::size_t kLargestStride = 252;
  const bool fits = column.stride >= column.size && column.stride <= kLargestStride &&
                    (count == 0 || offset + (count - 1) * column.stride + column.size <= view_size) &&
                    view_offset + view_size <= chunks.binary_size;
  if (!fits) {
    accessor.expected(fmt::format("{} splats of {} within its view and the binary chunk", count, attribute.name));
  }
  return column;
}

void read_attributes(const JsonReader& root, const JsonReader& primitive, const Chunks& chunks, const InputFile& file,
                     GlbDocument& document) {
  const JsonReader attributes = primitive.at("attributes");
  while (document.degree < kHighestGlbDegree &&
         attributes.find(glb_attributes(document.degree + 1).at(4 + splat_bands_squared(document.degree)).name)) {
    ++document.degree;
  }
  const std::vector<GlbAttribute> wanted = glb_attributes(document.degree);
  for (const GlbAttribute& attribute : wanted) {
    const auto index = attributes.find(attribute.name);
    if (!index) file.fail(fmt::format("expected the attribute {}, which is missing", attribute.name));
    std::uint64_t count = 0;
    document.columns.push_back(column_of(root, *index, attribute, chunks, count));
    if (document.columns.size() == 1) document.count = count;
    if (count != document.count) {
      index->expected(fmt::format("an accessor of {} splats, as POSITION has, not of {}", document.count, count));
    }
  }
  for (const auto& member : attributes.members()) {
    const std::string& name = member.first;
    const bool is_known = std::any_of(wanted.begin(), wanted.end(), [&](const auto& a) { return a.name == name; });
    if (!is_known && name.starts_with(kSplatExtension)) {
      file.fail(
          fmt::format("the attribute {} does not belong to splats of degree {}; expected all coefficients of a "
                      "degree, and all lower degrees, to degree {}",
                      output::printable(name), document.degree, kHighestGlbDegree));
    }
    if (!is_known && name != "COLOR_0") {
      document.other_attributes += (document.other_attributes.empty() ? "" : ", ") + name;
    }
  }
}

std::string text_or(const JsonReader& object, std::string_view key, std::string otherwise) {
  const auto value = object.find(key);
  return value ? value->text() : std::move(otherwise);
}

}  // namespace

std::size_t size_of_component(int component_type) {
  switch (component_type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

GlbDocument read_glb_document(const InputFile& file) {
  const Chunks chunks = read_chunks(file);
  nlohmann::json json;
  try {
    json = output::parse_json<nlohmann::json>(chunks.json);
  } catch (const std::runtime_error& error) {
    file.fail(error.what());
  }
  const JsonReader root(file.path(), json);
  const Primitive primitive = find_primitive(root, file);
  const JsonReader extension = primitive.json.at("extensions").at(kSplatExtension);
  if (const auto more = extension.find("extensions")) {
    for (const auto& [name, value] : more->members()) {
      file.fail(fmt::format("the splats need {}; expected none of its extensions", output::printable(name)));
    }
  }
  GlbDocument document;
  document.kernel = text_or(extension, "kernel", "ellipse");
  document.color_space = text_or(extension, "colorSpace", "");
  document.generator = text_or(root.at("asset"), "generator", "");
  if (document.kernel != "ellipse") extension.at("kernel").expected("the kernel `ellipse`");
  if (whole_or(primitive.json, "mode", 4) != 0) primitive.json.expected("points (mode 0)");
  read_attributes(root, primitive.json, chunks, file, document);
  document.placement = placement_of(root, primitive.mesh, file);
  return document;
}

}  // namespace sh::prt
