// The reader of JSON values: the limits of every kind of value, and messages that name the place.
#include "prt/scene/json_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

using nlohmann::json;

constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
constexpr double kLeastNormal = static_cast<double>(std::numeric_limits<float>::min());
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double above(double value) { return std::nextafter(value, kInfinity); }
double below(double value) { return std::nextafter(value, -kInfinity); }

// What reading `value` says after the name of the file; empty: it is accepted.
template <class Read>
std::string refusal(const json& value, const Read& read) {
  const std::string file = "a.json";
  std::string said = message_of([&] { read(JsonReader(file, value)); });
  if (said.empty()) return said;
  EXPECT_EQ(said.rfind("a.json: ", 0), 0U) << said;
  return said.substr(8);
}

TEST(JsonValues, AreQuotedUpToSixtyCharacters) {
  const auto number = [](const JsonReader& value) { return value.real(); };
  const std::string start = "/: expected a number, got ";
  for (const std::size_t letters : {57U, 58U}) {
    EXPECT_EQ(refusal(std::string(letters, 'a'), number), start + '"' + std::string(letters, 'a') + '"');
  }
  EXPECT_EQ(refusal(std::string(59, 'a'), number), start + '"' + std::string(56, 'a') + "...");
  EXPECT_EQ(refusal("\xff\n", number), start + R"("\ufffd\n")") << "one line, whatever the bytes";
}

TEST(JsonValues, NameTheirPlaceHoweverDeepItIs) {
  const json value = json::parse(R"({"a": [{"b": "x"}, 7], "c": {"d": 1}})");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.at("a").items()[0].at("b").real(); }),
            R"(/a/0/b: expected a number, got "x")");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.items("a")[1].text(); }),
            "/a/1: expected a string that is not empty, got 7");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.at("c").members()[0].second.boolean(); }),
            "/c/d: expected true or false, got 1");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.at("c").at("e"); }), "/c: the key `e` is missing");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.at("z"); }), "/: the key `z` is missing");
  EXPECT_EQ(refusal(value,
                    [](const JsonReader& v) {
                      v.at("c").allow({"x", "y"});
                    }),
            "/c/d: unknown key, expected one of x, y");
  EXPECT_EQ(refusal(value, [](const JsonReader& v) { v.at("c").allow({"x", "d"}); }), "");
}

TEST(JsonValues, OfAnotherTypeAreRefused) {
  const std::string file = "a.json";
  for (const json& value : {json(1), json(true), json("x"), json(nullptr)}) {
    const std::string got = ", got " + value.dump();
    EXPECT_EQ(refusal(value, [](const JsonReader& v) { v.allow({}); }), "/: expected an object" + got);
    EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.at("a"); }), "/: expected an object" + got);
    EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.members(); }), "/: expected an object" + got);
    EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.items(); }), "/: expected an array" + got);
    EXPECT_EQ(refusal(value, [](const JsonReader& v) { return v.vector(); }), "/: expected three numbers" + got);
    EXPECT_FALSE(JsonReader(file, value).is("array"));
  }
  EXPECT_TRUE(JsonReader(file, json::array()).is("array"));
  EXPECT_TRUE(JsonReader(file, json::array()).items().empty());
  EXPECT_TRUE(JsonReader(file, json::object()).items("a").empty()) << "none without the key";
  EXPECT_EQ(refusal(json::array({1}), [](const JsonReader& v) { return v.members(); }),
            "/: expected an object, got [1]");
  EXPECT_EQ(refusal("", [](const JsonReader& v) { return v.text(); }),
            R"(/: expected a string that is not empty, got "")");
  const auto word = [](const JsonReader& v) { return v.one_of({"x", "y"}); };
  EXPECT_EQ(refusal("y", word), "");
  for (const json& value : {json("z"), json(1), json(nullptr)}) {
    EXPECT_EQ(refusal(value, word), "/: expected one of x, y, got " + value.dump());
  }
}

TEST(JsonNumbers, IncludeTheirLimitsAndNothingBeyond) {
  const auto expect_limits = [](double least, double most, const auto& read, const std::string& what) {
    EXPECT_EQ(refusal(least, read), "") << least;
    EXPECT_EQ(refusal(most, read), "") << most;
    EXPECT_EQ(refusal(below(least), read), "/: expected " + what + ", got " + json(below(least)).dump());
    EXPECT_EQ(refusal(above(most), read), "/: expected " + what + ", got " + json(above(most)).dump());
    EXPECT_NE(refusal("1", read), "");
    EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN(), read), "");
  };
  expect_limits(
      -2.0, 5.0, [](const JsonReader& v) { return v.number(-2.0, 5.0, "this"); }, "this");
  expect_limits(
      -kLargest, kLargest, [](const JsonReader& v) { return v.finite(); }, "a number");
  expect_limits(
      -kLargest, kLargest, [](const JsonReader& v) { return v.real(); }, "a number");
  expect_limits(
      kLeastNormal, kLargest, [](const JsonReader& v) { return v.positive(); }, "a positive number");
  expect_limits(
      -7.0, 50.0, [](const JsonReader& v) { return v.degrees(-7.0, 50.0); }, "degrees from -7 to 50");
}

TEST(JsonNumbers, ThatAreWholeAreWrittenSo) {
  const auto integer = [](const JsonReader& v) { return v.integer(-3, 4); };
  for (const int good : {-3, 0, 4}) EXPECT_EQ(refusal(good, integer), "");
  for (const json& bad : {json(-4), json(5), json(1.5), json(1.0), json("1"), json(std::int64_t{1} << 40)}) {
    EXPECT_EQ(refusal(bad, integer), "/: expected an integer from -3 to 4, got " + bad.dump());
  }
}

TEST(JsonNumbers, ComeInThreesForVectors) {
  const auto point = [](const JsonReader& v) { return v.point(); };
  const auto part = [](const JsonReader& v) { return v.vector_within(0.0F, 1.0F); };
  const auto amount = [](const JsonReader& v) { return v.vector_within(0.0F, std::numeric_limits<float>::max()); };
  for (const json& bad : {json({1, 2}), json({1, 2, 3, 4}), json::array(), json(1)}) {
    EXPECT_EQ(refusal(bad, point), "/: expected three numbers, got " + bad.dump());
    EXPECT_EQ(refusal(bad, part), "/: expected three numbers from 0 to 1, got " + bad.dump());
    EXPECT_EQ(refusal(bad, amount), "/: expected three numbers of 0 or more, got " + bad.dump());
  }
  EXPECT_EQ(refusal({1, 2, "x"}, point), R"(/2: expected a number, got "x")");
  EXPECT_EQ(refusal({1, above(1.0), 0}, part),
            "/1: expected three numbers from 0 to 1, got " + json(above(1.0)).dump());
  EXPECT_EQ(refusal({-1, 0, 0}, amount), "/0: expected three numbers of 0 or more, got -1");
  for (const double limit : {-kLargest, kLargest}) EXPECT_EQ(refusal({limit, 0, 0}, point), "");
  const std::string file = "a.json";
  const json value = {1.5, -2.5, 1e-30};
  EXPECT_EQ(JsonReader(file, value).point(), Eigen::Vector3d(1.5, -2.5, 1e-30));
  EXPECT_EQ(JsonReader(file, value).vector(), Eigen::Vector3f(1.5F, -2.5F, 1e-30F));
}

// Radians are refused from pi / 12 to 2 pi, to about four digits.
TEST(JsonNumbers, ThatLookLikeRadiansAreNoDegrees) {
  constexpr double kTwelfth = std::numbers::pi / 12.0;
  const auto degrees = [](const JsonReader& v) { return v.degrees(-360.0, 360.0); };
  for (int i = 1; i <= 24; ++i) {
    for (const int sign : {-1, 1}) {
      const std::string whole = std::to_string(sign * i);
      const std::string expected = "/: expected degrees; this looks like " + whole + "/12 pi radians, which are " +
                                   std::to_string(sign * i * 15) + " degrees, got ";
      for (const double off : {-0.9e-3, 0.0, 0.9e-3}) {
        const std::string said = refusal(sign * (i + off) * kTwelfth, degrees);
        EXPECT_EQ(said.substr(0, expected.size()), expected);
      }
      for (const double off : {-1.1e-3, 1.1e-3, 0.5}) EXPECT_EQ(refusal(sign * (i + off) * kTwelfth, degrees), "");
    }
  }
  for (const double other : {0.0, 1e-4, 25.0 * kTwelfth, 26.0 * kTwelfth, -25.0 * kTwelfth, 90.0, 360.0}) {
    EXPECT_EQ(refusal(other, degrees), "") << other;
  }
}

TEST(JsonFiles, SayWhatIsWrongWithThem) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.json");
  EXPECT_EQ(message_of([&] { read_json(file); }), file + ": cannot read: No such file or directory");
  write_all(file, "{,}");
  EXPECT_EQ(message_of([&] { read_json(file); }).rfind(file + ": not JSON: ", 0), 0U);
  write_all(file, R"({"a": 1})");
  EXPECT_EQ(read_json(file), json({{"a", 1}}));
}

}  // namespace
}  // namespace sh::prt::test
