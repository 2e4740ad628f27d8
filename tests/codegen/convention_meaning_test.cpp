// Every family, convention, language and scalar: the emitted text means what the convention's definition says.
//
// The check runs the text (printed_code.hpp) on definitions that share nothing with the code that lays arrays out
// (convention_definitions.hpp). Faults that are put into the emitted code show that it sees them.
#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <set>

#include "codegen/ir/literal.hpp"
#include "symbolic/convention/convention.hpp"
#include "tests/codegen/emitted_call.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using print::Scalar;
using test::Definition;
using test::Mutation;
using test::Target;
using test::World;

// Axes that differ from their inverse, mirrored ones, and the worlds of engines.
constexpr const char* kAxes[] = {"y,z,x", "x,z,-y", "-z,x,y", "x,z,y", "y,x,z", "y,-x,z", "-y,-z,-x"};

bool is_refused(const std::string& family, const World& world) {
  const bool doubles = family == "product_full" || family.starts_with("transfer_");
  return (world.definition.convolved && test::needs_radiance(family)) ||
         (doubles ? 2 : 1) * world.degree > world.definition.largest;
}

World world_of(const std::string& family, const Definition& definition, const std::string& axes, int degree = 2) {
  return {definition, axes, test::degree_of(family, degree)};
}

TEST(ConventionMeaning, HasADefinitionOfEveryRealPresetAndAMeaningOfEveryFamily) {
  std::set<std::string> presets;
  for (const symbolic::Preset& preset : symbolic::presets()) {
    if (!preset.convention.complex) presets.insert(preset.name);
  }
  std::set<std::string> defined;
  for (const Definition& definition : test::definitions()) defined.insert(definition.preset);
  EXPECT_EQ(defined, presets);
  std::set<std::string> names;
  for (const Family& family : families()) names.insert(family.name);
  const auto meanings = test::families_with_meaning();
  EXPECT_EQ(std::set<std::string>(meanings.begin(), meanings.end()), names);
}

class EmittedFamily : public testing::TestWithParam<std::string> {};

TEST_P(EmittedFamily, MeansTheSameInEveryConventionLanguageAndScalar) {
  const std::string& family = GetParam();
  std::size_t turn = family.size();
  for (const Definition& definition : test::definitions()) {
    for (const std::string axes : {"x,y,z", kAxes[turn++ % std::size(kAxes)]}) {
      const World world = world_of(family, definition, axes);
      if (is_refused(family, world)) continue;
      for (const Target& target : test::targets()) {
        EXPECT_LE(test::deviation(family, world, test::emitted_call(world, target)), test::tolerance(target.scalar))
            << family << " " << definition.preset << " " << axes << " " << test::name_of(target);
      }
    }
  }
}

TEST_P(EmittedFamily, MeansTheSameAtOtherDegrees) {
  const std::string& family = GetParam();
  std::size_t turn = family.size() + 1;
  for (const int degree : {0, 1, 3}) {
    for (const Definition& definition : test::definitions()) {
      const World world = world_of(family, definition, kAxes[turn++ % std::size(kAxes)], degree);
      if (world.degree != degree || is_refused(family, world)) continue;
      EXPECT_LE(test::deviation(family, world, test::emitted_call(world, {"c99", Scalar::kDouble})),
                test::tolerance(Scalar::kDouble))
          << family << " " << definition.preset << " " << world.axes << " degree " << degree;
    }
  }
}

TEST_P(EmittedFamily, RefusesAConventionThatItCannotMeanAndOptionsWithoutEffect) {
  const std::string& family = GetParam();
  const int degree = test::degree_of(family, 2);
  for (const Definition& definition : test::definitions()) {
    for (const bool with_axes : {false, true}) {
      const ConventionOptions options{definition.preset, with_axes ? "y,z,x" : ""};
      const bool refused = is_refused(family, {definition, "", degree}) || test::is_shared(family, definition) ||
                           (test::has_no_axes(family) && with_axes);
      try {
        test::emitted_kernel(family, degree, options);
        EXPECT_FALSE(refused) << family << options.arguments();
      } catch (const std::invalid_argument& error) {
        EXPECT_TRUE(refused) << family << options.arguments() << ": " << error.what();
        EXPECT_EQ(test::lines(error.what()), 0) << error.what();
        EXPECT_TRUE(test::contains(error.what(), ": expected ")) << error.what();
        EXPECT_TRUE(test::contains(error.what(), ", got ")) << error.what();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EmittedFamily, testing::ValuesIn(test::families_with_meaning()),
                         [](const auto& family) { return family.param; });

TEST(ConventionMeaning, ConvolvesAnOvercastSkyOnce) {
  // Radiance (1 + 2 z) / 3 above the horizon: bands 0 to 2 of irradiance / pi at the zenith are 1/3, 7/18, 5/96.
  for (const char* preset : {"unity", "filament"}) {
    std::vector<double> c(9, 0);
    c[0] = 1.0 / 3;
    c[2] = 7.0 / 18;
    c[6] = 5.0 / 192;  // times 3 z^2 - 1
    const World world = world_of("irradiance_evaluate", test::definition_of(preset), "x,y,z");
    const auto call = test::emitted_call(world, {"c99", Scalar::kDouble});
    const auto arrays = call("irradiance_evaluate", {{"c", c}, {"x", {0}}, {"y", {0}}, {"z", {1}}});
    EXPECT_NEAR(arrays.at("irradiance")[0], 2.43255, 5e-6) << preset;
  }
}

TEST(ConventionMeaning, HeadsSpeakOfOneConvention) {
  for (const Family& family : families()) {
    const int degree = test::degree_of(family.name, 2);
    for (const Definition& definition : test::definitions()) {
      if (is_refused(family.name, {definition, "", degree}) || test::is_shared(family.name, definition)) continue;
      const Kernel& kernel = test::emitted_kernel(family.name, degree, {definition.preset, ""}).kernel;
      EXPECT_EQ(kernel.domain.find("in this project's own convention: "), 0U) << kernel.name;
      EXPECT_EQ(kernel.result.find("arrays as " + definition.preset + " has them"), 0U) << kernel.name;
      EXPECT_TRUE(test::contains(kernel.result, "; in this project's own convention: ")) << kernel.name;
    }
  }
}

// --- faults

std::string replaced(const std::string& text, const std::regex& pattern,
                     const std::function<std::string(const std::smatch&)>& by) {
  std::string result;
  auto from = text.begin();
  for (std::sregex_iterator it(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) {
    result.append(from, (*it)[0].first);
    result += by(*it);
    from = (*it)[0].second;
  }
  return result.append(from, text.end());
}

const std::regex kLiteral(R"((\s|\(|-)(\d+\.\d+(e-?\d+)?)(lf|L|f)?(?=[;,) ]))");

// The body only, so that the comment at the head stays.
std::string in_body(const std::string& text, const std::function<std::string(const std::string&)>& change) {
  const std::size_t start = text.find(") {\n");
  return text.substr(0, start) + change(text.substr(start));
}

Mutation text_mutation(const std::regex& pattern, const std::function<std::string(const std::smatch&)>& by) {
  return {.text = [=](const std::string& text) {
    return in_body(text, [&](const std::string& body) { return replaced(body, pattern, by); });
  }};
}

Mutation rounded_to_float() {
  return text_mutation(kLiteral, [](const std::smatch& match) {
    return match[1].str() + decimal(static_cast<double>(std::stof(match[2]))) + match[4].str();
  });
}

// The sign of one named constant changes, unless it is zero or `other`, which divides zeros only.
Mutation negated_constant(int which) {
  const auto seen = std::make_shared<int>();
  return {.text = [=](const std::string& text) {
    *seen = 0;
    return in_body(text, [&](const std::string& body) {
      return replaced(body, std::regex(R"((\w+ *)= (-?)((?!0\.0\D)\d[^;]*);)"), [&](const std::smatch& match) {
        if (match[1].str().starts_with("other")) return match.str();
        const bool chosen = (*seen)++ == which;
        return match[1].str() + "= " + std::string(chosen == (match[2].length() > 0) ? "" : "-") + match[3].str() + ";";
      });
    });
  }};
}

// Every element of every coefficient array of the parameters times the square of what it should be.
Mutation without_inverse(const std::string& preset) {
  return {.kernel = [preset](const Kernel& kernel) {
    const symbolic::Convention convention = symbolic::find_preset(preset).convention;
    const auto factors = [&](const std::vector<Parameter>& arrays) {
      std::vector<symbolic::Surd> list;
      for (const Parameter& array : arrays) {
        const bool stored = holds_coefficients(array.role) || array.role == Role::kBasisValues;
        for (int i = 0; i < array.size(); ++i) {
          symbolic::Surd factor(1);
          for (int l = 0; stored && l <= array.degree; ++l) {
            for (int m = -l; m <= l; ++m) {
              const bool zonal = array.role == Role::kZonalCoefficients;
              const int place = zonal ? (m == 0 ? l : -1) : storage_position(convention.order, array.degree, l, m);
              if (place != i % array.shape.back()) continue;
              const symbolic::Surd scale =
                  convention_factor(convention, l, m) / convention_factor(symbolic::Convention{}, l, m);
              factor = array.role == Role::kBasisValues ? (scale * scale).inverse() : scale * scale;
            }
          }
          list.push_back(factor);
        }
      }
      return list;
    };
    return with_gauges(kernel, factors(kernel.parameters), factors(kernel.results));
  }};
}

Mutation transposed_axes() {
  return {.options = [](ConventionOptions options) {
    if (!options.axes.empty()) options.axes = symbolic::SignedPermutation(options.axes).inverse().to_string();
    return options;
  }};
}

// The deviation of faulty code is far beyond rounding.
bool is_refuted(const std::string& family, const World& world, const Target& target, const Mutation& mutation) {
  const double seen = test::deviation(family, world, test::emitted_call(world, target, mutation));
  return !(seen <= 10 * test::tolerance(target.scalar));
}

std::string text_of(const std::string& family, const World& world, const Target& target) {
  const ConventionOptions options{test::is_shared(family, world.definition) ? "" : world.definition.preset, ""};
  return find_language(target.language)
      .print_kernel(test::emitted_kernel(family, world.degree, options), target.scalar);
}

TEST(ConventionMeaning, SeesDoublesRoundedToFloat) {
  const Target target{"c99", Scalar::kDouble};
  int changed = 0;
  for (const std::string& family : test::families_with_meaning()) {
    const World world = world_of(family, test::definition_of("directxmath"), "x,y,z");
    const std::string text = text_of(family, world, target);
    if (rounded_to_float().text(text) == text) continue;
    ++changed;
    EXPECT_TRUE(is_refuted(family, world, target, rounded_to_float())) << family;
  }
  EXPECT_GE(changed, 25);
}

TEST(ConventionMeaning, SeesTheSignOfEveryConstant) {
  int changed = 0;
  for (const Target& target : {Target{"hlsl", Scalar::kDouble}, Target{"glsl", Scalar::kDouble}}) {
    for (const std::string& family : test::families_with_meaning()) {
      const World world = world_of(family, test::definition_of("ambix"), "x,y,z");
      const std::string text = text_of(family, world, target);
      for (int i = 0; negated_constant(i).text(text) != text; ++i) {
        ++changed;
        EXPECT_TRUE(is_refuted(family, world, target, negated_constant(i)))
            << family << " " << test::name_of(target) << ", constant " << i;
      }
    }
  }
  EXPECT_GT(changed, 200);
}

TEST(ConventionMeaning, SeesFactorsWithoutTheirInverse) {
  for (const std::string& family : test::families_with_meaning()) {
    // Factors commute with windows and convolution, and these kernels have none.
    const bool commutes = family.find("window") == 0 || family == "irradiance";
    if (commutes || test::has_no_functions(family) || family == "rotate_build") continue;
    // A factor of a band commutes with a rotation and a turned axis, so these take factors of each function.
    const std::string preset = family.find("rotate") == 0 || family == "zonal" ? "unity" : "ambix";
    const World world = world_of(family, test::definition_of(preset), "x,y,z");
    EXPECT_TRUE(is_refuted(family, world, {"hlsl", Scalar::kDouble}, without_inverse(preset))) << family;
  }
}

TEST(ConventionMeaning, SeesTransposedAxes) {
  for (const std::string& family : test::families_with_meaning()) {
    if (test::has_no_axes(family)) continue;
    const World world = world_of(family, test::definition_of("unreal"), "y,z,x");
    EXPECT_TRUE(is_refuted(family, world, {"glsl", Scalar::kDouble}, transposed_axes())) << family;
  }
}

TEST(ConventionMeaning, ToolRefusesWithOneLine) {
  test::expect_refused("emit irradiance --degree 2 --lang c99 --convention unity", "include a clamped cosine");
  test::expect_refused("emit evaluate_prepared --degree 2 --lang cpp --convention directxmath",
                       "the same in every convention");
  test::expect_refused("emit square --degree 2 --lang hlsl --axes y,z,x", "the same for all axes");
}

}  // namespace
}  // namespace sh::codegen
