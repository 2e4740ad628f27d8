// Conventions are named from values alone; a single wrong coefficient is found, with the reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "numeric/sampling/random.hpp"
#include "tests/numeric/identify_data.hpp"

namespace sh::numeric::identify {
namespace {

bool names_preset(const Identification& result, const std::string& name) {
  return std::any_of(result.readings.begin(), result.readings.end(),
                     [&](const Reading& r) { return holds(r.presets.own, name); });
}

bool names_world_preset(const Identification& result, const std::string& name) {
  return std::any_of(result.readings.begin(), result.readings.end(),
                     [&](const Reading& r) { return holds(r.presets.world, name); });
}

Convention in_world(const Preset& preset) {
  Convention convention = preset.convention;
  convention.axes = preset.world;
  return convention;
}

TEST(Identify, NamesEveryPresetFromItsFunctions) {
  for (const Preset& preset : presets()) {
    for (int degree = 0; degree <= std::min(4, largest_degree(preset.convention)); ++degree) {
      const auto result = identify_values(preset.convention, degree);
      EXPECT_TRUE(result.recognized()) << preset.name << degree;
      EXPECT_TRUE(names_preset(result, preset.name)) << preset.name << degree;
      EXPECT_GT(result.digits(), 15) << preset.name << degree;
    }
  }
}

TEST(Identify, NamesEveryPresetFromFloatsInWorldAxes) {
  for (const Preset& preset : presets()) {
    if (preset.world == preset.convention.axes) continue;
    for (int degree = 0; degree <= std::min(4, largest_degree(preset.convention)); ++degree) {
      const auto result = identify_values(in_world(preset), degree, round_to_float);
      EXPECT_TRUE(result.recognized()) << preset.name << degree;
      EXPECT_TRUE(names_world_preset(result, preset.name)) << preset.name << degree;
      EXPECT_GT(result.digits(), 6.5) << preset.name << degree;
      EXPECT_LT(result.digits(), 17.1) << preset.name << degree;
    }
  }
}

TEST(Identify, FindsTheOneCoefficientWhoseSignIsFlipped) {
  for (const char* name : {"shforge", "directxmath", "unity", "ambix", "scipy", "shtools"}) {  // the rest are equal
    const Preset& preset = preset_named(name);
    for (int degree = 0; degree <= 4; ++degree) {
      const auto functions = functions_in_order(preset.convention.order, degree);
      for (std::size_t j = 0; j < functions.size(); ++j) {
        if (functions[j].is_hole()) continue;
        const auto result = identify_values(preset.convention, degree, [j](Values& v) { v[j] = -v[j]; });
        const auto wrong = wrong_for(result, preset.name);
        EXPECT_FALSE(result.recognized()) << preset.name << degree << " " << j;
        ASSERT_EQ(wrong.size(), 1) << preset.name << degree << " " << j;
        EXPECT_EQ(wrong[0].index, static_cast<int>(j)) << preset.name << degree;
        EXPECT_EQ(wrong[0].function.degree, functions[j].degree);
        EXPECT_EQ(wrong[0].function.order, functions[j].order);
        EXPECT_EQ(wrong[0].reason, "sign flipped") << preset.name << degree << " " << j;
      }
    }
  }
}

TEST(Identify, FindsTheOneConstantThatIsMistyped) {
  const Convention convention = presets().front().convention;
  for (std::size_t j = 0; j < 16; ++j) {
    const auto result = identify_values(convention, 3, [j](Values& v) { v[j] *= 1.08; });
    ASSERT_NE(result.first_wrong(), nullptr);
    EXPECT_EQ(result.first_wrong()->index, static_cast<int>(j));
    EXPECT_NE(result.first_wrong()->reason.find("mistyped? 1.08 times"), std::string::npos)
        << result.first_wrong()->reason;
  }
}

TEST(Identify, FindsAMistypedDigitThatRoundingDoesNotExplain) {
  const auto result = identify_values({}, 2, [](Values& v) { v[6] *= 0.315931 / 0.3153915652525; });
  ASSERT_NE(result.first_wrong(), nullptr);
  EXPECT_EQ(result.first_wrong()->index, 6);
  EXPECT_NE(result.first_wrong()->reason.find("(0.315931 for 0.3153916)"), std::string::npos)
      << result.first_wrong()->reason;
}

TEST(Identify, FindsTwoSwappedColumns) {
  for (const Preset& preset : presets()) {
    for (const auto& [a, b] : {std::pair{6, 7}, std::pair{1, 5}, std::pair{0, 3}}) {
      if (preset.convention.order == IndexOrder::kCosineSineArray) continue;
      const auto result = identify_values(preset.convention, 3, [a = a, b = b](Values& v) { std::swap(v[a], v[b]); });
      const auto wrong = wrong_for(result, preset.name);
      ASSERT_EQ(wrong.size(), 2) << preset.name << a;
      EXPECT_EQ(wrong[0].reason, "swapped with coefficient " + std::to_string(b)) << preset.name;
      EXPECT_EQ(wrong[1].reason, "swapped with coefficient " + std::to_string(a)) << preset.name;
    }
  }
}

struct Spoiled {
  const char* reason;
  Convention convention;
  Change change;
};

TEST(Identify, SaysWhatIsWrongWithACoefficient) {
  const Convention ours;
  const Convention scipy = preset_named("scipy").convention;
  const Convention shtools = preset_named("shtools").convention;
  int calls = 0;
  const std::vector<Spoiled> all = {
      {"too large by the factor sqrt 2", ours, [](Values& v) { v[5] *= std::sqrt(2.0); }},
      {"too small by the factor 2, sign flipped", ours, [](Values& v) { v[5] /= -2; }},
      {"is zero everywhere", ours, [](Values& v) { v[5] = 0; }},
      {"holds the function of coefficient 7, sign flipped", ours, [](Values& v) { v[5] = -v[7]; }},
      {"conjugate: the imaginary part has the wrong sign", scipy, [](Values& v) { v[5] = std::conj(v[5]); }},
      {"multiplied by the complex number 0 + 1i", scipy, [](Values& v) { v[5] *= std::complex<double>(0, 1); }},
      {"a hole of the array; it should hold zero", shtools, [](Values& v) { v[1] = 0.5; }},
      {"differs on 1 of 28 lines only: 11", ours, [&calls](Values& v) { v[5] += ++calls == 10 ? 0.1 : 0; }},
      {"is not a multiple of its function but (1) x coefficient 5's + (0.5) x coefficient 7's", ours,
       [](Values& v) { v[5] += 0.5 * v[7]; }},
      {"is no sum of functions up to this degree", ours, [](Values& v) { v[5] = std::pow(v[5].real(), 3); }},
  };
  for (const Spoiled& spoiled : all) {
    const auto result = identify_values(spoiled.convention, 3, spoiled.change);
    ASSERT_NE(result.first_wrong(), nullptr) << spoiled.reason;
    EXPECT_EQ(result.first_wrong()->reason, spoiled.reason);
  }
}

TEST(Identify, RanksByWhatNoConstantExplainsToo) {
  const auto result = identify_values({}, 2, [](Values& v) { v[5] += 0.01 * v[7]; });
  ASSERT_EQ(ranked_candidates(result.samples).front().wrong, 1);
  ASSERT_NE(result.first_wrong(), nullptr);
  EXPECT_EQ(result.first_wrong()->index, 5);
}

TEST(Identify, TellsConventionsApartThatNoPresetHas) {
  Random random(5);
  const auto pick = [&](std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>((random.next() + 1) / 2 * static_cast<double>(count)));
  };
  for (int i = 0; i < 60; ++i) {
    Convention c;
    c.complex = pick(2) == 1;
    c.normalization = static_cast<Normalization>(pick(c.complex ? 4 : 6));
    c.condon_shortley = pick(2) == 1;
    c.order = static_cast<IndexOrder>(pick(4));
    c.axes = all_axes()[pick(48)];
    c.folded = static_cast<Folded>(pick(3));
    const auto result = identify_values(c, 3);
    EXPECT_TRUE(result.recognized()) << describe(c);
    EXPECT_LE(result.readings.size(), c.complex ? 4 : 2) << describe(c);
    EXPECT_TRUE(
        std::any_of(result.readings.begin(), result.readings.end(), [&](const auto& r) { return r.convention == c; }))
        << describe(c) << " is called " << describe(result.readings.front().convention);
  }
}

TEST(Identify, ReadsTheHighestDegree) {
  for (const char* name : {"unity", "scipy"}) {
    const auto result = identify_values(preset_named(name).convention, kMaxDegree, round_to_float);
    EXPECT_TRUE(result.recognized() && names_preset(result, name)) << name;
  }
}

TEST(Identify, RecognizesRoundedConstantsWithAWarning) {
  const auto result = identify_values({}, 2, [](Values& v) {
    v[0] *= 0.282 / 0.28209479177387814;
    for (const std::size_t j : {4U, 5U, 7U}) v[j] *= 1.0925 / 1.0925484305920792;
  });
  EXPECT_TRUE(result.recognized());
  EXPECT_EQ(result.coefficients[0].reason, "constant 0.282 for 0.2820947918, rounded to 3 digits");
  EXPECT_EQ(result.coefficients[4].reason, "constant 1.0925 for 1.092548431, rounded to 5 digits");
  EXPECT_EQ(result.coefficients[6].reason, "");
  EXPECT_NEAR(result.coefficients[0].ratio.real(), 1 - 3.36e-4, 1e-6);
  EXPECT_NEAR(result.digits(), 3.47, 0.1);
  EXPECT_NE(format_text(result, false).find("warning: coefficient 0 (l=0, m=0): constant 0.282"), std::string::npos);
}

TEST(Identify, ReportsTheSameInTextAndJson) {
  const auto result = identify_values({}, 2, [](Values& v) { v[6] = -v[6]; });
  const auto text = format_text(result, false);
  EXPECT_NE(text.find("first wrong: coefficient 6 (l=2, m=0): sign flipped; on line "), std::string::npos) << text;
  const auto json = nlohmann::json::parse(format_json(result));
  EXPECT_EQ(json.at("recognised"), false);
  EXPECT_EQ(json.at("first_wrong").at("index"), 6);
  EXPECT_EQ(json.at("first_wrong").at("order"), 0);
  EXPECT_EQ(json.at("readings").at(0).at("presets").at(0), "shforge");
  EXPECT_EQ(json.at("coefficients").size(), 9);
}

TEST(Identify, DoubtsMirroredAxesAtDegreeOneWhereAPresetIsNear) {
  const auto result = identify_values({}, 1, [](Values& v) { v[3] = -v[3]; });
  EXPECT_TRUE(result.fits());
  EXPECT_FALSE(result.recognized());
  EXPECT_EQ(result.readings.front().convention.axes.determinant(), -1);
  const auto text = format_text(result, false);
  EXPECT_NE(text.find("degree 1 cannot tell it from a wrong coefficient"), std::string::npos) << text;
}

// --- mistakes that concern the whole table, bad lines, noise

using Direction3 = std::array<double, 3>;

// The values at other directions than the table says.
Samples called_at(const Preset& preset, int degree, const std::function<Direction3(const Direction3&)>& other) {
  Samples samples = make_samples(preset.convention, degree);
  for (std::size_t row = 0; row < samples.directions.size(); ++row) {
    const auto values = convention_values(preset.convention, degree, other(samples.directions[row]));
    for (std::size_t j = 0; j < values.size(); ++j) samples.columns[j][row] = values[j];
  }
  return samples;
}

void expect_mistake(const Samples& samples, const std::string& mistake, const std::string& preset) {
  const auto result = identify({samples});
  EXPECT_FALSE(result.recognized()) << preset << samples.degree;
  EXPECT_EQ(result.mistake, mistake) << preset << samples.degree;
  EXPECT_TRUE(names_preset(result, preset)) << preset << samples.degree;
  EXPECT_NE(format_text(result, false).find("with this mistake: " + mistake), std::string::npos) << preset;
}

TEST(Identify, NamesThetaAndPhiExchanged) {
  // theta becomes a longitude: functions that take its sine from a root lose the sign.
  for (const bool by_root : {false, true}) {
    const auto exchanged = [by_root](const Direction3& d) {
      const double phi = std::atan2(d[1], d[0]);
      const double theta = std::acos(d[2]);
      const double sine = by_root ? std::abs(std::sin(phi)) : std::sin(phi);
      return Direction3{sine * std::cos(theta), sine * std::sin(theta), std::cos(phi)};
    };
    for (const char* preset : {"shforge", "unity", "fuma", "scipy", "shtools"})
      expect_mistake(called_at(preset_named(preset), by_root ? 2 : 3, exchanged), "theta and phi exchanged", preset);
  }
}

TEST(Identify, NamesSineAndCosineOfThetaExchanged) {
  const auto by_latitude = [](const Direction3& d) {
    const double phi = std::atan2(d[1], d[0]);
    const double across = std::hypot(d[0], d[1]);
    return Direction3{d[2] * std::cos(phi), d[2] * std::sin(phi), across};
  };
  for (const char* preset : {"shforge", "directxmath", "scipy", "shtools"})
    expect_mistake(called_at(preset_named(preset), 3, by_latitude),
                   "sine and cosine of theta exchanged (latitude for theta)", preset);
}

TEST(Identify, NamesSineAndCosineOfMPhiExchanged) {
  for (const char* preset : {"shforge", "directxmath", "unity", "ambix-w1", "fuma", "shtools"}) {
    const Convention& convention = preset_named(preset).convention;
    Samples samples = make_samples(convention, 3);
    Samples changed = samples;
    const auto at = [&](int l, int m) { return static_cast<std::size_t>(storage_position(convention.order, 3, l, m)); };
    for (int l = 0; l <= 3; ++l) {
      for (int m = -l; m <= l; ++m) {
        if (m != 0 || !samples.is_array) changed.columns[at(l, m)] = samples.columns[at(l, -m)];
      }
    }
    if (samples.is_array) {  // the halves change places
      for (std::size_t j = 0; j < samples.columns.size(); ++j)
        changed.columns[j] = samples.columns[(j + samples.columns.size() / 2) % samples.columns.size()];
    }
    expect_mistake(changed, "sine and cosine of m phi exchanged (m for -m)", preset);
  }
}

TEST(Identify, NamesConjugatedValues) {
  for (const int degree : {1, 2, 4}) {
    const auto conjugate = [](Values& values) {
      for (auto& v : values) v = std::conj(v);
    };
    expect_mistake(make_samples(preset_named("scipy").convention, degree, conjugate), "every value conjugated",
                   "scipy");
  }
}

TEST(Identify, NamesTheBadLinesAmongMany) {
  for (const char* name : {"directxmath", "unity", "e3nn-norm", "scipy", "shtools"}) {
    const Preset& preset = preset_named(name);
    for (const std::vector<std::size_t>& bad : {std::vector<std::size_t>{0}, {27}, {3, 17}}) {
      Samples samples = make_samples(preset.convention, 3);
      for (auto& column : samples.columns) {
        for (const std::size_t row : bad) column[row] = column[row] * 1.3 + 0.2;
      }
      const auto result = identify({samples});
      EXPECT_FALSE(result.recognized());
      EXPECT_TRUE(result.fits() && names_preset(result, preset.name)) << preset.name;
      std::vector<int> lines;
      for (const std::size_t row : bad) lines.push_back(samples.lines[row]);
      EXPECT_EQ(result.bad_lines, lines) << preset.name;
    }
  }
}

TEST(Identify, RecognizesNoisyValuesAndSaysHowNoisy) {
  for (const Preset& preset : presets()) {
    for (const int degree : {2, 3}) {
      Random random(11);
      const bool complex = preset.convention.complex;
      const auto noise = [&](Values& values) {
        // The sum of twelve numbers in -1 .. 1 has the variance 4.
        const auto normal = [&] {
          double sum = 0;
          for (int i = 0; i < 12; ++i) sum += random.next();
          return 1e-3 * sum / 2;
        };
        for (auto& v : values) {
          if (v != std::complex<double>(0)) v += std::complex<double>(normal(), complex ? normal() : 0);
        }
      };
      const auto result = identify_values(preset.convention, degree, noise);
      EXPECT_TRUE(result.recognized()) << preset.name << degree;
      EXPECT_TRUE(names_preset(result, preset.name)) << preset.name << degree;
      EXPECT_GT(result.noise, 0.5e-3) << preset.name << degree;
      EXPECT_LT(result.noise, 2e-3) << preset.name << degree;
      EXPECT_NE(format_text(result, false).find("warning: the values carry noise"), std::string::npos);
      const auto flipped = identify_values(preset.convention, degree, [&](Values& values) {
        noise(values);
        for (std::size_t j = 0; j < values.size(); ++j) values[j] *= j == 6 ? -1 : 1;
      });
      if (preset.convention.order == IndexOrder::kCosineSineArray) continue;  // 6 is a hole
      const auto wrong = wrong_for(flipped, preset.name);
      ASSERT_EQ(wrong.size(), 1) << preset.name << degree;
      EXPECT_EQ(wrong[0].reason, "sign flipped") << preset.name;
    }
  }
}

}  // namespace
}  // namespace sh::numeric::identify
