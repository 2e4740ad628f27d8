#include "prt/mesh/import_mesh.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "numeric/output/srgb.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/mesh/model_pictures.hpp"

namespace sh::prt {

namespace {

constexpr int kMostHeaderLines = 1000;
// The pictures of base color (of formats before glTF: diffuse color), and those of roughness and metallic part, as the
// importer names them.
constexpr std::array kColors = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
constexpr std::array kEmission = {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR};
constexpr std::array kFacets = {aiTextureType_UNKNOWN, aiTextureType_METALNESS, aiTextureType_DIFFUSE_ROUGHNESS};
const Eigen::Vector2f kNoCoordinates = Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN());

Eigen::Vector3f to_eigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Eigen::Vector3f to_eigen(const aiColor4D& c) { return {c.r, c.g, c.b}; }

Eigen::Affine3d to_eigen(const aiMatrix4x4& m) {
  return Eigen::Affine3d(Eigen::Map<const Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(&m.a1).cast<double>());
}

// A property of a material, if it has it: material_value<T>(material, AI_MATKEY_...).
template <class T>
std::optional<T> material_value(const aiMaterial* material, const char* key, unsigned type, unsigned index) {
  T value{};
  if (material == nullptr || material->Get(key, type, index, value) != AI_SUCCESS) return std::nullopt;
  return value;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// An importer's message as one line.
std::string one_line(std::string text) {
  text.erase(text.find_last_not_of("\r\n ") + 1);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text.empty() ? "no reason given" : text;
}

class Collector {
 public:
  Collector(const std::string& path, const aiScene& scene, const MaterialChanges& changes)
      : extension_(extension_of(path)),
        scene_(scene),
        changes_(changes),
        pictures_(path, scene),
        is_linear_(extension_ == ".gltf" || extension_ == ".glb") {}

  ImportedMesh collect() {
    visit(*scene_.mRootNode, Eigen::Affine3d::Identity());
    list_unread();
    result_.unread.insert(result_.unread.end(), pictures_.flaws().begin(), pictures_.flaws().end());
    result_.file_vertices = result_.soup.positions.size();
    result_.up = up_axis();
    if (std::all_of(result_.soup.normals.begin(), result_.soup.normals.end(),
                    [](const Eigen::Vector3f& n) { return n.isZero(0.0F); })) {
      result_.soup.normals.clear();
    }
    return std::move(result_);
  }

 private:
  // The importer turns Collada and 3DS to y-up; FBX files state their axis.
  [[nodiscard]] UpAxis up_axis() const {
    int axis = 1;
    if (scene_.mMetaData != nullptr && scene_.mMetaData->Get("UpAxis", axis)) {
      return axis == 2 ? UpAxis::kZ : UpAxis::kY;
    }
    return extension_ == ".stl" || extension_ == ".ply" ? UpAxis::kZ : UpAxis::kY;
  }

  void visit(const aiNode& node, const Eigen::Affine3d& parent) {
    const Eigen::Affine3d map = parent * to_eigen(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], map, node.mName.C_Str());
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], map);
  }

  void add(const aiMesh& mesh, const Eigen::Affine3d& map, const std::string& node) {
    Soup part;
    const aiMaterial* material = material_of(mesh);
    part.nodes = {MeshNode{node, name_of(material)}};
    const MaterialChange change = changes_.of(part.nodes[0].material);
    const Eigen::Vector3f albedo = albedo_of(material, mesh.HasVertexColors(0));
    if (has_unread_textures(material) && !change.reflection) textured_.insert(material);
    const bool has_coordinates = mesh.HasTextureCoords(0);
    if (mesh.HasVertexColors(1)) ++meshes_of_many_colors_;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      part.positions.emplace_back(to_eigen(mesh.mVertices[v]).cast<double>());
      part.normals.push_back(mesh.HasNormals() ? to_eigen(mesh.mNormals[v]) : Eigen::Vector3f::Zero().eval());
      part.texture.push_back(has_coordinates ? to_eigen(mesh.mTextureCoords[0][v]).head<2>() : kNoCoordinates);
      part.chart.push_back(mesh.HasTextureCoords(1) ? to_eigen(mesh.mTextureCoords[1][v]).head<2>()
                                                    : part.texture.back());
      Eigen::Vector3f color = albedo;
      if (mesh.HasVertexColors(0)) color = color.cwiseProduct(linear(mesh.mColors[0][v]));
      part.albedo.push_back(change.reflection ? change.reflection->albedo : color.cwiseMax(0.0F).cwiseMin(1.0F).eval());
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 3) part.faces.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    part.rounding = kSingleRounding * bounding_box(part.positions)
                                          .min()
                                          .cwiseAbs()
                                          .cwiseMax(bounding_box(part.positions).max().cwiseAbs())
                                          .maxCoeff();
    transform(part, map);
    Finish finish = finish_of(material, change);
    take_pictures(material, change, has_coordinates, finish);
    append(part, finish);
  }

  void append(const Soup& part, const Finish& finish) {
    Soup& soup = result_.soup;
    const auto known = std::find(soup.finishes.begin(), soup.finishes.end(), finish);
    const auto index = static_cast<std::uint32_t>(known - soup.finishes.begin());
    if (known == soup.finishes.end()) soup.finishes.push_back(finish);
    soup.finish.insert(soup.finish.end(), part.faces.size(), index);
    soup.node.insert(soup.node.end(), part.faces.size(), static_cast<std::uint32_t>(soup.nodes.size()));
    soup.nodes.push_back(part.nodes[0]);
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    soup.rounding = std::max(soup.rounding, part.rounding);
    soup.positions.insert(soup.positions.end(), part.positions.begin(), part.positions.end());
    soup.normals.insert(soup.normals.end(), part.normals.begin(), part.normals.end());
    soup.albedo.insert(soup.albedo.end(), part.albedo.begin(), part.albedo.end());
    soup.texture.insert(soup.texture.end(), part.texture.begin(), part.texture.end());
    soup.chart.insert(soup.chart.end(), part.chart.begin(), part.chart.end());
    for (const Face& face : part.faces) soup.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  }

  // What the file has and this importer leaves out. A material whose reflection the scene gives needs no texture.
  void list_unread() {
    if (!textured_.empty()) {
      result_.unread.push_back(fmt::format("{} of its materials have textures (not read)", textured_.size()));
    }
    if (meshes_of_many_colors_ > 0) {
      result_.unread.push_back(fmt::format("{} of its meshes have several sets of vertex colors (the first is read)",
                                           meshes_of_many_colors_));
    }
    if (!misplaced_.empty()) {
      result_.unread.push_back(
          fmt::format("{} of its materials have textures without a first set of texture coordinates, or with a "
                      "transform of them (not read)",
                      misplaced_.size()));
    }
  }

  // Besides those that take_pictures() reads.
  [[nodiscard]] bool has_unread_textures(const aiMaterial* material) const {
    if (material == nullptr) return false;
    for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type) {
      const auto is_among = [&](const auto& types) {
        return std::find(types.begin(), types.end(), type) != types.end();
      };
      const bool is_of_gltf = type == aiTextureType_NORMALS || is_among(kFacets) || is_among(kEmission);
      if (is_among(kColors) || (is_linear_ && is_of_gltf)) continue;
      if (material->GetTextureCount(static_cast<aiTextureType>(type)) > 0) return true;
    }
    return false;
  }

  // The first of the types of which the material has a picture.
  template <class Types>
  static std::optional<aiTextureType> type_among(const Types& types, const aiMaterial& material) {
    const auto found = std::find_if(types.begin(), types.end(),
                                    [&](aiTextureType type) { return material.GetTextureCount(type) > 0; });
    return found == types.end() ? std::nullopt : std::optional(*found);
  }

  // Null if the file has no material: for formats without materials the importer invents one.
  [[nodiscard]] const aiMaterial* material_of(const aiMesh& mesh) const {
    if (extension_ == ".ply" || extension_ == ".stl" || extension_ == ".off" ||
        mesh.mMaterialIndex >= scene_.mNumMaterials) {
      return nullptr;
    }
    const aiMaterial* material = scene_.mMaterials[mesh.mMaterialIndex];
    const bool is_made_up = material_value<aiString>(material, AI_MATKEY_NAME) == aiString(AI_DEFAULT_MATERIAL_NAME);
    return is_made_up ? nullptr : material;
  }

  // Also adds the name to the materials of the file.
  std::string name_of(const aiMaterial* material) {
    const auto name = material_value<aiString>(material, AI_MATKEY_NAME);
    if (!name) return {};
    std::vector<std::string>& names = result_.materials;
    if (std::find(names.begin(), names.end(), name->C_Str()) == names.end()) names.emplace_back(name->C_Str());
    return name->C_Str();
  }

  [[nodiscard]] Eigen::Vector3f linear(const aiColor4D& color) const {
    return is_linear_ ? to_eigen(color) : to_eigen(color).unaryExpr(&output::srgb_decode<float>).eval();
  }

  [[nodiscard]] Eigen::Vector3f albedo_of(const aiMaterial* material, bool has_vertex_colors) const {
    if (const auto color = material_value<aiColor4D>(material, AI_MATKEY_COLOR_DIFFUSE)) return linear(*color);
    return Eigen::Vector3f::Constant(material == nullptr && has_vertex_colors ? 1.0F : kDefaultAlbedo);
  }

  // The surface model of glTF. Null where a texture gives its factors: vertices then have their own.
  std::shared_ptr<const Reflectance> brdf_of(const aiMaterial* material) {
    const auto roughness = material_value<float>(material, AI_MATKEY_ROUGHNESS_FACTOR);
    const auto metallic = material_value<float>(material, AI_MATKEY_METALLIC_FACTOR);
    if (!is_linear_ || !roughness || !metallic || type_among(kFacets, *material)) return nullptr;
    const std::pair factors = {std::clamp(*roughness, 0.0F, 1.0F), std::clamp(*metallic, 0.0F, 1.0F)};
    std::shared_ptr<const Reflectance>& known = brdfs_[factors];
    if (known == nullptr) {
      known = std::make_shared<Reflectance>(microfacet_reflectance(factors.first, factors.second));
    }
    return known;
  }

  // The type of the first picture among `types`, if its coordinates are known: those of the first set, as they are.
  template <class Types>
  std::optional<aiTextureType> placed(const Types& types, const aiMaterial& material, bool has_coordinates) {
    const std::optional<aiTextureType> type = type_among(types, material);
    if (!type) return std::nullopt;
    const bool is_moved = material_value<aiUVTransform>(&material, AI_MATKEY_UVTRANSFORM(*type, 0)).has_value();
    const int set = material_value<int>(&material, AI_MATKEY_UVWSRC(*type, 0)).value_or(0);
    if (has_coordinates && !is_moved && set == 0) return type;
    misplaced_.insert(&material);
    return std::nullopt;
  }

  // What the scene changes needs no picture of the file. Other formats than glTF do not say how pictures besides that of
  // the color are to be read.
  void take_pictures(const aiMaterial* material, const MaterialChange& change, bool has_coordinates, Finish& finish) {
    finish.normal_map = change.normal_map;
    if (material == nullptr) return;
    VariedMaterial& varied = finish.varied;
    if (!change.reflection) {
      if (const auto type = placed(kColors, *material, has_coordinates)) {
        varied.albedo = pictures_.picture(*material, *type, ColorSpace::kOfFile);
        varied.shown = pictures_.encoded(*material, *type);
      }
    }
    if (!is_linear_) return;
    if (finish.normal_map == nullptr && placed(std::array{aiTextureType_NORMALS}, *material, has_coordinates)) {
      finish.normal_map = pictures_.normal_map(*material);
    }
    if (!change.emission && !finish.emission.isZero(0.0F)) {
      if (const auto type = placed(kEmission, *material, has_coordinates)) {
        varied.emission = pictures_.picture(*material, *type, ColorSpace::kOfFile);
      }
    }
    if (!change.gloss) {
      if (const auto type = placed(kFacets, *material, has_coordinates)) {
        varied.facets = pictures_.picture(*material, *type, ColorSpace::kLinear);
        varied.roughness = material_value<float>(material, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1.0F);
        varied.metallic = material_value<float>(material, AI_MATKEY_METALLIC_FACTOR).value_or(1.0F);
      }
    }
  }

  [[nodiscard]] Finish finish_of(const aiMaterial* material, const MaterialChange& change) {
    Finish finish;
    if (const auto color = material_value<aiColor4D>(material, AI_MATKEY_COLOR_EMISSIVE)) {
      const float strength = material_value<float>(material, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1.0F);
      const Eigen::Vector3f emission = strength * to_eigen(*color).cwiseMax(0.0F);
      if (emission.allFinite()) finish.emission = emission;
    }
    finish.emission = change.emission.value_or(finish.emission);
    if (change.reflection) finish.mirror = change.reflection->mirror;
    finish.translucence = change.translucence;
    finish.gloss.brdf = brdf_of(material);
    finish.gloss = change.gloss.value_or(finish.gloss);
    finish.is_two_sided =
        !change.translucence &&
        change.is_two_sided.value_or(material_value<int>(material, AI_MATKEY_TWOSIDED).value_or(0) != 0);
    return finish;
  }

  std::string extension_;
  const aiScene& scene_;
  const MaterialChanges& changes_;
  ModelPictures pictures_;
  bool is_linear_;
  std::set<const aiMaterial*> textured_;
  std::set<const aiMaterial*> misplaced_;
  std::size_t meshes_of_many_colors_ = 0;
  std::map<std::pair<float, float>, std::shared_ptr<const Reflectance>> brdfs_;  // by roughness and metallic
  ImportedMesh result_;
};

// Some importers (OFF, glTF) mend an index out of range and only log it. This class keeps the log while it lives.
class Complaints final : public Assimp::LogStream {
 public:
  Complaints() {
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(this, Assimp::Logger::Warn | Assimp::Logger::Err);
  }
  ~Complaints() override {
    Assimp::DefaultLogger::get()->detachStream(this, Assimp::Logger::Warn | Assimp::Logger::Err);
    Assimp::DefaultLogger::kill();
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  void write(const char* message) override {
    const std::string text = message;
    if (text.find("out of range") != std::string::npos || text.find("out-of-range") != std::string::npos) index_ = text;
  }
  [[nodiscard]] const std::string& about_an_index() const { return index_; }

 private:
  std::string index_;
};

// Checks the nodes before any code visits them: the importer of RAW files loses nodes of files with several objects.
void check_nodes(const std::string& path, const aiScene& scene, const aiNode* node) {
  const auto is_known = [&](unsigned mesh) { return mesh < scene.mNumMeshes; };
  if (node == nullptr || !std::all_of(node->mMeshes, node->mMeshes + node->mNumMeshes, is_known)) {
    throw std::runtime_error(
        fmt::format("{}: cannot read the mesh: the importer lost some of its objects; expected one object a file, or "
                    "another format",
                    path));
  }
  for (unsigned i = 0; i < node->mNumChildren; ++i) check_nodes(path, scene, node->mChildren[i]);
}

// Checks the indices before any code uses them.
void check_indices(const std::string& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    if (!mesh.HasPositions() && mesh.mNumVertices > 0) {
      throw std::runtime_error(fmt::format("{}: mesh {} has no positions", path, m));
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      for (unsigned k = 0; k < mesh.mFaces[f].mNumIndices; ++k) {
        if (mesh.mFaces[f].mIndices[k] >= mesh.mNumVertices) {
          throw std::runtime_error(fmt::format("{}: face {} names vertex {}, but there are {} vertices", path, f,
                                               mesh.mFaces[f].mIndices[k], mesh.mNumVertices));
        }
      }
    }
  }
}

// Whether the faces of a PLY file have colors, which the importer ignores: the header lists properties by element.
bool has_face_colors(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  bool in_faces = false;
  std::string line;
  for (int i = 0; i < kMostHeaderLines && std::getline(file, line) && !line.starts_with("end_header"); ++i) {
    if (line.starts_with("element")) in_faces = line.starts_with("element face");
    if (in_faces && line.find(" red") != std::string::npos) return true;
  }
  return false;
}

bool has_polygons(const aiScene& scene) {
  return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, [](const aiMesh* mesh) {
    return std::any_of(mesh->mFaces, mesh->mFaces + mesh->mNumFaces,
                       [](const aiFace& face) { return face.mNumIndices >= 3; });
  });
}

void check_readable(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw std::runtime_error(fmt::format("{}: no such mesh file", path));
  if (!std::filesystem::is_regular_file(status)) {
    throw std::runtime_error(fmt::format("{}: not a file, expected a mesh", path));
  }
  if (std::filesystem::file_size(path, error) == 0) {
    throw std::runtime_error(fmt::format("{}: the file is empty, expected a mesh", path));
  }
}

}  // namespace

bool has_mesh_name(const std::string& path) { return Assimp::Importer().IsExtensionSupported(extension_of(path)); }

ImportedMesh import_mesh(const std::string& path, const MaterialChanges& changes) {
  check_readable(path);
  Complaints complaints;
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(path, 0);
  if (!complaints.about_an_index().empty()) {
    throw std::runtime_error(
        fmt::format("{}: a face names a missing vertex: {}", path, one_line(complaints.about_an_index())));
  }
  if (scene == nullptr) {
    throw std::runtime_error(fmt::format("{}: cannot read the mesh: {}", path, one_line(importer.GetErrorString())));
  }
  check_nodes(path, *scene, scene->mRootNode);
  check_indices(path, *scene);
  if (!has_polygons(*scene)) {
    throw std::runtime_error(fmt::format("{}: the mesh has no faces, expected at least one triangle", path));
  }
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
  if (scene == nullptr) {
    throw std::runtime_error(
        fmt::format("{}: cannot triangulate the mesh: {}", path, one_line(importer.GetErrorString())));
  }
  ImportedMesh mesh = Collector(path, *scene, changes).collect();
  if (!changes.all.reflection && extension_of(path) == ".ply" && has_face_colors(path)) {
    mesh.unread.emplace_back("its faces have colors (not read)");
  }
  return mesh;
}

}  // namespace sh::prt
