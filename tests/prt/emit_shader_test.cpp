// Emitted vertex shaders, run by Mesa, against the relighting of the library.
#include "numeric/glsl/egl_context.hpp"
#include "tests/prt/coated_cases.hpp"
#include "tests/prt/emitted_shaders.hpp"

namespace sh::prt::test {
namespace {

std::vector<Eigen::Vector3f> run(const EmittedCase& one, bool es) {
  const numeric::EglContext context(es ? numeric::GlslLanguage::kEs300 : numeric::GlslLanguage::kCore450);
  const EmittedShaders shaders(one, es, false);
  shaders.use(linked(shaders.file("relight.vert")), one);
  return captured_radiance(one.transfer.mesh.positions.size());
}

class EmittedGlsl : public testing::TestWithParam<bool> {};

void expect_radiance_of_relighting(const std::vector<EmittedCase>& all, bool es) {
  for (const EmittedCase& one : all) expect_near(run(one, es), expected(one), one.name);
}

TEST_P(EmittedGlsl, GivesTheRadianceOfRelighting) { expect_radiance_of_relighting(emitted_cases(), GetParam()); }

TEST_P(EmittedGlsl, GivesTheRadianceOfRowsInClusters) { expect_radiance_of_relighting(clustered_cases(), GetParam()); }

TEST_P(EmittedGlsl, GivesTheRadianceOfBrdfs) { expect_radiance_of_relighting(coated_cases(), GetParam()); }

TEST_P(EmittedGlsl, GivesTheRadianceOfTheHighestDegree) { expect_radiance_of_relighting(highest_cases(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Es, EmittedGlsl, testing::Bool());

}  // namespace
}  // namespace sh::prt::test
