// What plans promise: the stated error is at least the one measured with 16 times the directions over eight turns of the
// light, at most 4 times it (with bounces 6 times), and within the limit; the printed rays are those that a bake traces.
// `plan_bench` measures the same on large scenes.
#include "tests/prt/plan_promise.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "prt/plan/plan.hpp"
#include "tests/prt/glossy_meshes.hpp"

namespace sh::prt::test {
namespace {

constexpr int kMoreDirections = 16;

Mesh colored(Mesh mesh, const Eigen::Vector3f& albedo) {
  paint(mesh, albedo);
  return mesh;
}

/// Things on a ground, and a box through it: some of the ground's vertices are inside, others are covered.
Mesh things_on_ground() {
  Mesh mesh = colored(primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(4.0F))), {0.5F, 0.4F, 0.3F});
  refine(mesh, 0.2F);
  append(mesh, colored(primitive_mesh("torus", 24, Eigen::Affine3f(Eigen::Translation3f(0.8F, 0.3F, 0.2F))),
                       {0.6F, 0.2F, 0.1F}));
  append(mesh, colored(primitive_mesh("box", 24, Eigen::Translation3f(-0.7F, -0.5F, 0.3F) * Eigen::Scaling(0.9F)),
                       {0.3F, 0.5F, 0.7F}));
  return mesh;
}

/// A room of white and colored walls, open in front, with a box in it.
Mesh small_room(float white, float longest = 0.12F) {
  const Eigen::Vector3f plain = Eigen::Vector3f::Constant(white);
  Mesh mesh = primitive_mesh("box");
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t v) { return mesh.positions[v].y() < -0.4F; });
  });
  turn_inside_out(mesh);
  paint(mesh, plain);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (std::abs(mesh.normals[v].x()) > 0.9F) mesh.albedo[v] = {0.7F, 0.1F, 0.1F};
  }
  append(mesh,
         colored(primitive_mesh("box", 24, Eigen::Translation3f(0.1F, 0.1F, -0.3F) * Eigen::Scaling(0.39F)), plain));
  refine(mesh, longest);
  return mesh;
}

/// A wide open ground, and far off one small square under slats: only that square needs many directions.
Mesh rare_square() {
  Mesh mesh = primitive_mesh("plane", 24, Eigen::Affine3f(Eigen::Scaling(4.0F)));
  refine(mesh, 0.1F);
  const auto patch = [&](float x, float z, float width, float length) {
    append(mesh,
           primitive_mesh("plane", 24, Eigen::Translation3f(20.0F + x, 0.0F, z) * Eigen::Scaling(width, length, 1.0F)));
  };
  patch(0.0F, 0.0F, 0.2F, 0.2F);
  for (int i = -4; i <= 4; ++i) patch(0.1F * static_cast<float>(i), 0.2F, 0.05F, 2.0F);
  return mesh;
}

/// Things on a ground, before a sphere that is a mirror in each channel by `reflectance`, and else black.
Mesh things_and_mirror(const Eigen::Vector3f& reflectance) {
  Mesh mesh = things_on_ground();
  const std::size_t things = mesh.positions.size();
  append(mesh, colored(primitive_mesh("sphere", 24, Eigen::Affine3f(Eigen::Translation3f(0.0F, -1.2F, 0.6F))),
                       Eigen::Vector3f::Zero()));
  mesh.mirror.assign(things, Eigen::Vector3f::Zero());
  mesh.mirror.resize(mesh.positions.size(), reflectance);
  return mesh;
}

/// Things of several finishes on a ground: dull and shiny lobes, and a rough metal.
Mesh finished_things() {
  Mesh mesh = finished(things_on_ground(), {0.3F, 0.2F, 0.1F}, {0.4F, 0.5F, 0.6F}, 12.0F);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 2) mesh.exponent[v] = 3.0F;
  return mesh;
}

/// The small room, with walls that shine a little.
Mesh finished_room(float specular) {
  Mesh mesh = small_room(0.5F, 0.3F);
  mesh.specular.assign(mesh.positions.size(), Eigen::Vector3f::Constant(specular));
  mesh.exponent.assign(mesh.positions.size(), 8.0F);
  return mesh;
}

LightSpec sun(double elevation) {
  const double angle = elevation * std::numbers::pi / 180.0;
  return {.type = LightType::kCap,
          .radiance = {9.0F, 8.0F, 6.0F},
          .direction = Eigen::Vector3d(std::cos(angle), 0.0, std::sin(angle)),
          .one_minus_cos = 0.02};
}

Scene lit(Mesh mesh, const TransferKind* kind, std::vector<LightSpec> lights, Sampler sampler = Sampler::kFibonacci) {
  Scene scene = scene_of(std::move(mesh), kind, 1024, 3);
  scene.lights = std::move(lights);
  scene.bake.sampler = sampler;
  return scene;
}

struct Case {
  const char* name;
  Scene scene;
  LightTurns turns;
};

std::vector<Case> cases() {
  const LightSpec sky;
  return {
      {"overcast", lit(things_on_ground(), &kShadowed, {sky}), LightTurns::kAboutZ},
      {"sunny", lit(things_on_ground(), &kShadowed, {sky, sun(40.0)}), LightTurns::kAboutZ},
      {"any turn, cosine", lit(things_on_ground(), &kShadowed, {sky, sun(40.0)}, Sampler::kCosine), LightTurns::kAny},
      {"rare", lit(rare_square(), &kShadowed, {sky, sun(60.0)}), LightTurns::kAboutZ},
      {"no turn, sobol", lit(rare_square(), &kShadowed, {sun(60.0)}, Sampler::kSobol), LightTurns::kNone},
      {"room", lit(small_room(0.7F), &kInterreflected, {sky, sun(20.0)}), LightTurns::kAboutZ},
      {"bright room", lit(small_room(0.95F), &kInterreflected, {sky}), LightTurns::kAboutZ},
      {"bounces outside", lit(things_on_ground(), &kInterreflected, {sky, sun(30.0)}), LightTurns::kNone},
      {"mirror", lit(things_and_mirror({0.8F, 0.8F, 0.8F}), &kShadowed, {sky, sun(40.0)}), LightTurns::kAboutZ},
      {"mirror of a color", lit(things_and_mirror({0.9F, 0.6F, 0.2F}), &kInterreflected, {sky, sun(40.0)}),
       LightTurns::kAboutZ},
      {"glossy", lit(finished_things(), &kGlossyShadowed, {sky, sun(40.0)}), LightTurns::kAboutZ},
      {"glossy, any turn", lit(finished_things(), &kGlossyShadowed, {sky, sun(40.0)}, Sampler::kSobol),
       LightTurns::kAny},
      {"glossy room", lit(finished_room(0.3F), &kGlossyInterreflected, {sky, sun(20.0)}), LightTurns::kAboutZ}};
}

TEST(PlanPromise, IsKeptAndNotFarFromTheTruth) {
  for (const Case& c : cases()) {
    testing::internal::CaptureStderr();
    const Transfer reference = full_bake(c.scene, kMoreDirections * c.scene.bake.directions);
    const double loosest = c.scene.bake.kind->has_bounces() ? 6.0 : 4.0;
    std::string said;
    for (const double error : {0.1, 0.01}) {
      const PlanOptions options{.mode = PlanMode::kLossy, .error = error, .turns = c.turns};
      const BakeJob job = planned_as(c.scene, options);
      const double stated = job.plan->record.error;
      const Transfer planned = stored(bake(job));
      const double measured = measured_error(c.scene, planned, reference, c.turns, *job.plan);
      said += std::string(c.name) + " " + std::to_string(error) + ": stated " + std::to_string(stated) + ", measured " +
              std::to_string(measured) + ", degree " + std::to_string(planned.degree()) + ", " +
              std::to_string(planned.directions) + " directions\n";
      EXPECT_LE(measured, stated) << c.name << " " << error;
      EXPECT_LE(stated, loosest * measured) << c.name << " " << error;
      EXPECT_LE(stated, error) << c.name;
    }
    testing::internal::GetCapturedStderr();
    RecordProperty(c.name, said);
  }
}

TEST(PlannedRays, AreThoseThatABakeTraces) {
  const Mesh gray = things_and_mirror({0.8F, 0.8F, 0.8F}), colored = things_and_mirror({0.9F, 0.6F, 0.2F});
  const LightSpec sky;
  for (const Scene& scene :
       {lit(things_on_ground(), &kShadowed, {sky}), lit(things_on_ground(), &kShadowed, {sky}, Sampler::kCosine),
        lit(small_room(0.7F), &kInterreflected, {sky}),
        lit(small_room(0.7F), &kInterreflected, {sky}, Sampler::kCosine), lit(gray, &kShadowed, {sky}),
        lit(gray, &kInterreflected, {sky}), lit(colored, &kInterreflected, {sky})}) {
    testing::internal::CaptureStderr();
    const BakeJob job = planned_as(scene, {.mode = PlanMode::kLossy, .error = 0.05, .without = {"bounces"}});
    BakeReport report;
    bake(job, &report);
    testing::internal::GetCapturedStderr();
    EXPECT_NEAR(static_cast<double>(job.plan->planned.rays) / static_cast<double>(report.rays), 1.0, 0.03)
        << scene.bake.kind->word << ", " << name_of(scene.bake.sampler);
  }
}

TEST(PlanText, SaysAtMostOnlyOfBoundsAndGivesMeasuredErrorsAConfidence) {
  const Scene scene = lit(small_room(0.5F), &kInterreflected, {LightSpec{}});
  const auto text_of = [&](const PlanOptions& options) {
    const BakeJob job = planned_as(scene, options);
    return plan_text(*job.plan, job.scene);
  };
  const std::string measured = text_of({.mode = PlanMode::kLossy, .error = 0.05});
  EXPECT_EQ(measured.find("error at most"), std::string::npos) << measured;
  EXPECT_EQ(measured.find("heuristic"), std::string::npos) << measured;
  EXPECT_NE(measured.find("99 % confidence"), std::string::npos) << measured;
  const std::string bound =
      text_of({.mode = PlanMode::kLossy,
               .error = 0.05,
               .without = {"receivers", "analytic", "bounces", "bands", "symmetry", "hits", "directions"}});
  EXPECT_NE(bound.find("error at most"), std::string::npos) << bound;
  EXPECT_EQ(bound.find("confidence"), std::string::npos) << bound;
}

}  // namespace
}  // namespace sh::prt::test
