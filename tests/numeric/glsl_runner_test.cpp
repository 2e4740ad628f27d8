// The GLSL runner in both languages: scalars, arrays and return values go in and come out in place; failures are one
// line.
#include "numeric/glsl/glsl_runner.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sh::numeric {
namespace {

constexpr const char* kPrecision = "#ifdef GL_ES\nprecision highp float;\n#endif\n";

class GlslRun : public testing::TestWithParam<GlslLanguage> {
 protected:
  static std::vector<float> run(const std::string& source, const GlslFunction& function,
                                const std::vector<float>& inputs) {
    return GlslRunner(GetParam()).run("test.glsl", kPrecision + source, function, inputs);
  }
};

TEST_P(GlslRun, PassesScalarsArraysAndReturnValues) {
  const Parameter t{"t", 0, Access::kOut};
  const GlslFunction function{"mix_up",
                              {{in_array("a", 2), in_out_array("c", 2), scalar("s"), out_array("b", 3), t}, true}};
  EXPECT_EQ(function.signature.input_count(), 5);
  EXPECT_EQ(function.signature.output_count(), 7);
  const auto out =
      run("float mix_up(float a[2], inout float c[2], float s, out float b[3], out float t) {\n"
          "  b[0] = a[1]; b[1] = a[0]; b[2] = 2.0 * s; t = -s; c[0] += c[1]; return a[0] + a[1] + s; }\n",
          function, {1, 2, 7, 8, 3, 10, 20, 70, 80, 30});
  EXPECT_EQ(out, (std::vector<float>{6, 15, 8, 2, 1, 6, -3, 60, 150, 80, 20, 10, 60, -30}));
}

// More than one work group, more than one row of texels, and an output that does not fill its last texel.
TEST_P(GlslRun, KeepsTheOrderOfManyItems) {
  std::vector<float> inputs;
  inputs.reserve(10001);
  for (int i = 0; i < 10001; ++i) inputs.push_back(static_cast<float>(i));
  const auto out = run("void f(float a, out float b[5]) { for (int i = 0; i < 5; ++i) b[i] = a + float(i) * 0.125; }\n",
                       {"f", {{scalar("a"), out_array("b", 5)}}}, inputs);
  ASSERT_EQ(out.size(), 5 * inputs.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(out[i], inputs[i / 5] + static_cast<float>(i % 5) * 0.125F) << i;
  }
}

std::string message_of(GlslLanguage language, const std::string& source, const std::vector<float>& inputs) {
  try {
    GlslRunner(language).run("test.glsl", kPrecision + source, {"f", {{in_array("a", 2), {"b", 0, Access::kOut}}}},
                             inputs);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST_P(GlslRun, SaysInOneLineWhatIsWrong) {
  const auto wrong = message_of(GetParam(), "void f(float a[2], out float b) { b = q; }\n", {1, 2});
  EXPECT_EQ(wrong.find("test.glsl: does not compile as GLSL: "), 0) << wrong;
  EXPECT_NE(wrong.find("`q' undeclared"), std::string::npos) << wrong;
  EXPECT_EQ(wrong.find('\n'), std::string::npos);
  EXPECT_EQ(message_of(GetParam(), "void f(float a[2], out float b) { b = a[0]; }\n", {1, 2, 3}),
            "test.glsl: expected a positive multiple of 2 inputs, got 3");
  EXPECT_EQ(message_of(GetParam(), "void f(float a[2], out float b) { b = a[0]; }\n", {1, 2}), "nothing thrown");
}

// A file without a default precision is valid in GLSL 4.50 only; the runner must not hide that.
TEST_P(GlslRun, DoesNotSupplyAPrecision) {
  GlslRunner runner(GetParam());
  const auto call = [&] {
    return runner.run("test.glsl", "float f(float a) { return a; }\n", {"f", {{scalar("a")}, true}}, {1});
  };
  if (GetParam() == GlslLanguage::kEs300) {
    EXPECT_THROW(call(), std::runtime_error);
  } else {
    EXPECT_EQ(call(), std::vector<float>{1});
  }
}

TEST_P(GlslRun, UsesTheSoftwareRasterizer) {
  EXPECT_NE(GlslRunner(GetParam()).renderer().find("llvmpipe"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Languages, GlslRun, testing::Values(GlslLanguage::kCore450, GlslLanguage::kEs300),
                         [](const auto& language) {
                           return language.param == GlslLanguage::kCore450 ? "Core450" : "Es300";
                         });

}  // namespace
}  // namespace sh::numeric
