// Emitted fragment shaders, drawn by Mesa, against the pictures of the library at the same places.
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "numeric/glsl/egl_context.hpp"
#include "prt/material/normal_map.hpp"
#include "tests/prt/coated_cases.hpp"
#include "tests/prt/emitted_shaders.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// The picture: cells of 12 x 10 pixels, whose diagonals meet no center of a pixel.
constexpr int kColumns = 4;
constexpr int kRows = 4;
constexpr int kCellWidth = 12;
constexpr int kCellHeight = 10;
constexpr int kWidth = kColumns * kCellWidth;
constexpr int kHeight = kRows * kCellHeight;

// A camera at kEye that looks at the origin, with window coordinates that grow to the right and up.
struct Window {
  Eigen::Vector3d forward = -kEye.normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Vector3d up = right.cross(forward);

  // At distance 1 along the view.
  [[nodiscard]] Eigen::Vector3d direction(double x, double y) const {
    constexpr double kTangent = 0.5;
    constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
    return forward + kTangent * kAspect * (2.0 * x / kWidth - 1.0) * right + kTangent * (2.0 * y / kHeight - 1.0) * up;
  }
  [[nodiscard]] Eigen::Matrix4f to_clip() const {
    constexpr double kTangent = 0.5;
    constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
    constexpr double kNear = 0.5;
    constexpr double kFar = 20.0;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    clip.row(0).head<3>() = right / (kTangent * kAspect);
    clip.row(1).head<3>() = up / kTangent;
    clip.row(2).head<3>() = forward * (kFar + kNear) / (kFar - kNear);
    clip.row(3).head<3>() = forward;
    clip.col(3).head<4>() = -clip.leftCols<3>() * kEye;
    clip(2, 3) -= 2.0 * kFar * kNear / (kFar - kNear);
    return clip.cast<float>();
  }
};

// Two sheets side by side, each of 2 x 4 cells, whose vertices lie on corners of pixels at many depths: the rasterizer then
// rounds none of them. Normals point everywhere towards the eye and beside it; the second sheet is seen from behind.
Mesh sheets() {
  const Window window;
  const std::vector<float> random = random_values(1000, 5);
  std::size_t next = 0;
  const auto number = [&] { return random[next++ % random.size()]; };
  Mesh mesh;
  for (int sheet = 0; sheet < 2; ++sheet) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= kRows; ++row) {
      for (int column = 0; column <= kColumns / 2; ++column) {
        const double depth = 4.0 + static_cast<double>(number());
        const int cell = sheet * kColumns / 2 + column;
        const Eigen::Vector3d along = window.direction(cell * kCellWidth, row * kCellHeight);
        mesh.positions.emplace_back((kEye + depth * along).cast<float>());
        const Eigen::Vector3f normal =
            (Eigen::Vector3f(number(), number(), number()) - along.cast<float>().normalized()).normalized();
        mesh.normals.push_back(normal);
        mesh.albedo.emplace_back(Eigen::Vector3f(number(), number(), number()).cwiseAbs());
      }
    }
    constexpr std::uint32_t kAcross = kColumns / 2 + 1;
    for (std::uint32_t row = 0; row < kRows; ++row) {
      for (std::uint32_t column = 0; column + 1 < kAcross; ++column) {
        const std::uint32_t v = first + row * kAcross + column;
        mesh.faces.push_back({v, v + 1, v + 1 + kAcross});
        mesh.faces.push_back({v, v + 1 + kAcross, v + kAcross});
        if (sheet == 0) continue;
        for (Face* face : {&mesh.faces.back(), &mesh.faces.back() - 1}) std::swap((*face)[1], (*face)[2]);
      }
    }
  }
  mesh.geometric_normals = mesh.normals;
  return mesh;
}

constexpr std::size_t kSheet = (kColumns / 2 + 1) * (kRows + 1);  // vertices

// A lobe for each sheet.
void polish(Mesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.specular.emplace_back(0.5F * mesh.albedo[v].reverse());
    mesh.exponent.push_back(v < kSheet ? 7.0F : 60.0F);
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {  // one reflectance a face, too
    mesh.specular[v] = mesh.specular[v < kSheet ? 0 : kSheet];
  }
}

Transfer transfer_on(const TransferKind& kind, int degree, Mesh mesh, const TransferShape& indirect = {}) {
  Transfer transfer = Transfer::of(kind, degree);
  transfer.mesh = std::move(mesh);
  const std::size_t vertices = transfer.mesh.positions.size();
  transfer.coefficients = random_values(vertices * transfer.shape.length(), 17);
  if (kind.indirect != nullptr) {
    transfer.indirect_shape = indirect;
    transfer.indirect = random_values(vertices * indirect.length(), 91);
    transfer.indirect = decode(encode(transfer.indirect, indirect), indirect);
  }
  return transfer;
}

Mesh polished_sheets() {
  Mesh mesh = sheets();
  polish(mesh);
  return mesh;
}

NormalMap map_of(std::string name, int width, int height, unsigned seed) {
  Image image{width, height, {}, 0};
  const std::vector<float> random = random_values(static_cast<std::size_t>(3 * width * height), seed);
  for (int i = 0; i < width * height; ++i) {
    image.pixels.emplace_back(0.5F + 0.3F * random[3 * i], 0.5F + 0.3F * random[3 * i + 1], 0.9F);
  }
  return normal_map_of(std::move(name), image);
}

// Maps of two sizes; coordinates that leave the picture, turn, are mirrored, and have no area on one cell.
Mesh dented(Mesh mesh) {
  mesh.normal_maps.number_of(map_of("small", 3, 2, 1));
  mesh.normal_maps.number_of(map_of("large", 16, 9, 2));
  const std::vector<float> random = random_values(2 * mesh.positions.size(), 3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto column = static_cast<float>(v % kSheet % 3);
    const std::size_t third = v % kSheet / 3;
    const auto row = static_cast<float>(third);
    const float turned = column < 2.0F ? column : 0.2F;  // the second column of cells mirrors the picture
    mesh.texture.emplace_back(0.4F * turned - 0.3F + 0.05F * random[2 * v],
                              0.5F * row - 0.7F + 0.05F * random[2 * v + 1]);
    mesh.normal_map.push_back(v < kSheet ? 2 : 1);
  }
  for (const std::size_t v : {0, 1, 3, 4}) mesh.texture[v].setConstant(0.25F);
  return mesh;
}

Transfer coated_sheets(Transfer transfer, std::uint16_t first, std::uint16_t second) {
  std::vector<std::uint16_t> numbers(transfer.mesh.positions.size(), first);
  std::fill(numbers.begin() + kSheet, numbers.end(), second);
  const Mesh mesh = transfer.mesh;
  transfer = coated(std::move(transfer), numbers);
  transfer.mesh.positions = mesh.positions;  // not the special places of `coated`
  transfer.mesh.normals = mesh.normals;
  return transfer;
}

std::vector<EmittedCase> pixel_cases() {
  std::vector<EmittedCase> all;
  all.push_back({"lobes", transfer_on(kGlossyShadowed, 4, polished_sheets())});
  all.push_back({"dull", transfer_on(kGlossyShadowed, 2, sheets())});
  all.push_back({"constant", transfer_on(kGlossyShadowed, 0, polished_sheets())});
  all.push_back({"half_zonal", stored(transfer_on(kGlossyShadowed, 3, polished_sheets()), Element::kHalf), {0, 2, 6}});
  all.push_back({"unshadowed", transfer_on(kGlossyUnshadowed, kMaxDegree, polished_sheets())});
  Transfer emitting = transfer_on(kGlossyInterreflected, 2, polished_sheets(), matrices(2, 3, Element::kHalf));
  emitting.emitted = emitting.mesh.albedo;
  all.push_back({"emitting_bounces", emitting});
  all.push_back({"clusters", in_clusters(transfer_on(kGlossyShadowed, 2, polished_sheets()), {2, 8})});
  all.push_back({"coated", coated_sheets(transfer_on(kGlossyShadowed, 3, sheets()), 1, 2)});
  all.push_back({"coated_beside_lobes", coated_sheets(transfer_on(kGlossyShadowed, 2, polished_sheets()), 0, 2)});
  all.push_back({"coated_unshadowed", coated_sheets(transfer_on(kGlossyUnshadowed, 5, sheets()), 3, 1)});
  all.push_back({"dents", transfer_on(kGlossyShadowed, 3, dented(polished_sheets()))});
  all.push_back({"dents_dull", transfer_on(kGlossyUnshadowed, 4, dented(sheets()))});
  Transfer half_dented = transfer_on(kGlossyShadowed, 2, dented(polished_sheets()));
  std::fill_n(half_dented.mesh.normal_map.begin(), kSheet, std::uint16_t{0});
  all.push_back({"dents_on_one", half_dented});
  all.push_back({"dents_coated", coated_sheets(transfer_on(kGlossyShadowed, 2, dented(sheets())), 2, 1)});
  return all;
}

// (kHeight, kWidth), bottom row first.
std::vector<Eigen::Vector3f> drawn(const EmittedCase& one, bool es) {
  const numeric::EglContext context(es ? numeric::GlslLanguage::kEs300 : numeric::GlslLanguage::kCore450);
  const EmittedShaders shaders(one, es, true);
  GLint vectors = 0;
  glGetIntegerv(GL_MAX_VARYING_VECTORS, &vectors);
  EXPECT_LE(shaders.json["between"]["vectors"], vectors);
  const GLuint program = linked(shaders.file("relight.vert"), shaders.file("relight.frag"), nullptr);
  GLuint framebuffer = 0;
  GLuint target = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &target);
  glBindRenderbuffer(GL_RENDERBUFFER, target);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kWidth, kHeight);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  glViewport(0, 0, kWidth, kHeight);
  shaders.use(program, one);
  const Eigen::Matrix4f clip = Window().to_clip();
  glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, clip.data());
  GLuint indices = 0;
  glGenBuffers(1, &indices);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  const std::size_t faces = shaders.json["faces"]["count"];
  EXPECT_EQ(faces, one.transfer.mesh.faces.size());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(faces * sizeof(Face)),
               shaders.bytes.data() + shaders.json["faces"]["offset"].get<std::size_t>(), GL_STATIC_DRAW);
  glDisable(GL_RASTERIZER_DISCARD);  // which clusters leave enabled
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * faces), GL_UNSIGNED_INT, nullptr);
  std::vector<float> rgba(4 * static_cast<std::size_t>(kWidth * kHeight));
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT, rgba.data());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  std::vector<Eigen::Vector3f> radiance;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    radiance.emplace_back(rgba[i], rgba[i + 1], rgba[i + 2]);
    EXPECT_EQ(rgba[i + 3], 1.0F) << one.name << ": pixel " << i / 4;
  }
  return radiance;
}

// What the library shows at the centers of the pixels.
std::vector<Eigen::Vector3f> rendered(const EmittedCase& one) {
  const Mesh& mesh = one.transfer.mesh;
  const Surface surface = glossy_surface(one.transfer, TransferredRadiance(one.transfer, light_of(one)), mesh.albedo);
  std::vector<Eigen::Vector3f> radiance;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const Eigen::Vector3d along = Window().direction(column + 0.5, row + 0.5);
      for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        std::array<Eigen::Vector3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[mesh.faces[f][k]].cast<double>();
        Eigen::Matrix3d edges;
        edges << p[1] - p[0], p[2] - p[0], -along;
        const Eigen::Vector3d uvt = edges.partialPivLu().solve(kEye - p[0]);
        if (uvt.x() < 0.0 || uvt.y() < 0.0 || uvt.x() + uvt.y() > 1.0) continue;
        const Hit hit{f, static_cast<float>(uvt.x()), static_cast<float>(uvt.y()), static_cast<float>(uvt.z())};
        radiance.push_back(surface(hit, along.normalized().cast<float>()));
        break;
      }
    }
  }
  return radiance;
}

class EmittedPixels : public testing::TestWithParam<bool> {};

TEST_P(EmittedPixels, ShowTheRadianceOfPictures) {
  for (const EmittedCase& one : pixel_cases()) {
    const std::vector<Eigen::Vector3f> wanted = rendered(one);
    const std::vector<Eigen::Vector3f> got = drawn(one, GetParam());
    ASSERT_EQ(wanted.size(), got.size()) << one.name;
    float largest = 0.0F;
    float error = 0.0F;
    for (const Eigen::Vector3f& value : wanted) largest = std::max(largest, value.cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < got.size(); ++i) error = std::max(error, (got[i] - wanted[i]).cwiseAbs().maxCoeff());
    EXPECT_LT(error, 1e-4F * largest) << one.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Es, EmittedPixels, testing::Bool());

std::string refusal(const Transfer& transfer) {
  return message_of([&] { emit_glsl(transfer, {"refused", {}, true}, false); });
}

TEST(EmittedPixels, RefuseWhatTheyCannotShow) {
  EXPECT_NE(refusal(random_transfer(kShadowed, 2, 5)).find("kind DS"), std::string::npos);
  Transfer mixed = transfer_on(kGlossyShadowed, 2, polished_sheets());
  mixed.mesh.exponent[1] += 1.0F;
  EXPECT_NE(refusal(mixed).find("several BRDFs or lobes"), std::string::npos) << refusal(mixed);
  Transfer texels = transfer_on(kGlossyShadowed, 2, sheets());
  texels.mesh.atlases.heads.push_back({1, 1, 0, 1});
  EXPECT_NE(refusal(texels).find("texels of an atlas"), std::string::npos) << refusal(texels);
  const std::string large = refusal(transfer_on(kGlossyShadowed, 5, sheets()));
  EXPECT_NE(large.find("33 4-vectors"), std::string::npos) << large;
  EXPECT_NE(message_of([] {
              emit_cpp(transfer_on(kGlossyShadowed, 1, sheets()), {"cpp", {}, true});
            }).find("pixels"),
            std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
