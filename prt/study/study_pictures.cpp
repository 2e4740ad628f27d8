// The error fields from bakes of the whole mesh.
#include <fmt/core.h>

#include <algorithm>

#include "prt/bake/bake.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/study/study_setup.hpp"

namespace sh::prt {

namespace {

Radiances shaded(const Transfer& transfer, const LightCoefficients& light, int degree) {
  Radiances radiances;
  for (const Eigen::Vector3f& radiance : relight(transfer, first_bands(light, degree))) {
    radiances.push_back(radiance.cast<double>());
  }
  return radiances;
}

Transfer shadowed(const StudySetup& setup, int degree, int directions) {
  Scene scene = setup.scene;
  scene.mesh.emission.clear();  // the lights' error only
  scene.bake.kind = &kShadowed;
  scene.plan.mode = PlanMode::kNone;
  scene.bake.degree = degree;
  scene.bake.directions = directions;
  BakeSettings settings;
  settings.instruction_set = setup.options.instruction_set;
  return bake({std::move(scene), settings});
}

}  // namespace

StudyPart study_pictures(const StudySetup& setup) {
  const int degree = setup.scene.bake.degree;
  const int few = setup.options.bounce_directions;
  const int many = setup.options.picture_reference;
  const Transfer reference = shadowed(setup, kMaxDegree, many);
  const Radiances cut = shaded(reference, setup.light, degree);
  StudyPart part;
  part.name = "pictures";
  part.reference = fmt::format("{} directions, degree {}", many, kMaxDegree);
  part.fields.push_back(field_of(setup, "directions", fmt::format("{} directions against {}", few, many),
                                 shaded(shadowed(setup, degree, few), setup.light, degree), cut));
  if (degree < kMaxDegree) {
    part.fields.push_back(field_of(setup, "degrees", fmt::format("degree {} against degree {}", degree, kMaxDegree),
                                   cut, shaded(reference, setup.light, kMaxDegree)));
  }
  return part;
}

}  // namespace sh::prt
