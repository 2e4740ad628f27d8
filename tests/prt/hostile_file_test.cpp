// Transfer files with valid checksums and bad content, and JSON of any depth: refused in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "numeric/output/parse_json.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class HostileFile : public testing::Test {
 protected:
  void SetUp() override {
    Transfer transfer = baked(primitive_mesh("plane"), &kInterreflected, 64, 1);
    transfer.mesh.mirror.assign(transfer.mesh.positions.size(), {0.1F, 0.2F, 0.3F});
    transfer.mesh.specular.assign(transfer.mesh.positions.size(), {0.3F, 0.2F, 0.1F});
    transfer.mesh.exponent.assign(transfer.mesh.positions.size(), 20.0F);
    transfer.emitted.assign(transfer.mesh.positions.size(), {0.5F, 0.5F, 0.5F});
    transfer.plan = {0.01, 0.002, "any", {{"storage", "half", "it is enough", 12, 3, 0.002, "bound"}}};
    transfer.missing = {128, 0.001};
    write_transfer(file_, transfer);
    good_ = read_all(file_);
  }

  // What the reader says of these bytes after the name of the file; empty: it accepts them.
  std::string refusal(const std::string& bytes, bool sizes = false) {
    write_all(file_, with_checksums(bytes, sizes));
    std::string said = message_of([&] { read_transfer(file_); });
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    if (said.empty()) return said;
    EXPECT_EQ(said.rfind(file_ + ": ", 0), 0U) << said;
    return said.substr(file_.size() + 2);
  }

  // Its first number of a section replaced.
  template <class Number>
  std::string with_number(std::string_view section, Number number) {
    std::string bytes = good_;
    std::memcpy(bytes.data() + place_of(bytes, section), &number, sizeof number);
    return refusal(bytes);
  }

  // A text of its header replaced by one that is no longer.
  std::string with_header(const std::string& from, std::string to) {
    std::string bytes = good_;
    const std::size_t place = bytes.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    EXPECT_LE(to.size(), from.size());
    to.resize(from.size(), ' ');
    return refusal(bytes.replace(place, from.size(), to));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.transfer");
  std::string good_;
};

TEST_F(HostileFile, IsAcceptedAsItWasWritten) { EXPECT_EQ(refusal(good_), ""); }

TEST_F(HostileFile, IsRefusedWithNumbersThatAreNotWhatTheirSectionHolds) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(with_number("position", bad), "damaged transfer file: a position is not finite");
    EXPECT_EQ(with_number("normal", bad), "damaged transfer file: a normal is not of length 1");
    EXPECT_EQ(with_number("geonorm", bad), "damaged transfer file: a normal is not of length 1");
    EXPECT_EQ(with_number("albedo", bad), "damaged transfer file: an albedo is not from 0 to 1");
    EXPECT_EQ(with_number("mirror", bad), "damaged transfer file: a mirror's reflectance is not from 0 to 1");
    EXPECT_EQ(with_number("specular", bad), "damaged transfer file: a specular reflectance is not from 0 to 1");
    EXPECT_EQ(with_number("exponent", bad), "damaged transfer file: an exponent is not from 0 to 1e6");
    EXPECT_EQ(with_number("emitted", bad), "damaged transfer file: a transfer coefficient is not finite");
    EXPECT_EQ(with_number("transfer", bad), "damaged transfer file: a transfer coefficient is not finite");
  }
  for (const float bad : {-1.0F, 5.0F}) {
    EXPECT_EQ(with_number("albedo", bad), "damaged transfer file: an albedo is not from 0 to 1");
    EXPECT_EQ(with_number("mirror", bad), "damaged transfer file: a mirror's reflectance is not from 0 to 1");
    EXPECT_EQ(with_number("specular", bad), "damaged transfer file: a specular reflectance is not from 0 to 1");
    EXPECT_EQ(with_number("normal", bad), "damaged transfer file: a normal is not of length 1");
  }
  for (const float bad : {-1.0F, 1.1e6F}) {
    EXPECT_EQ(with_number("exponent", bad), "damaged transfer file: an exponent is not from 0 to 1e6");
  }
  EXPECT_EQ(with_number("albedo", 1.0F), "");
  EXPECT_EQ(with_number("position", 1e30F), "");
}

TEST_F(HostileFile, IsAcceptedWithTheLimitsOfItsNumbers) {
  for (const float limit : {0.0F, 1.0F}) {
    EXPECT_EQ(with_number("albedo", limit), "");
    EXPECT_EQ(with_number("mirror", limit), "");
    EXPECT_EQ(with_number("specular", limit), "");
    EXPECT_EQ(with_number("exponent", limit * 1e6F), "");
  }
  EXPECT_EQ(with_number("normal", 0.04F), "") << "of length 1.0008";
  EXPECT_EQ(with_number("normal", 0.05F), "damaged transfer file: a normal is not of length 1") << "of length 1.0012";
}

TEST_F(HostileFile, IsRefusedWhereItNamesAVertexThatIsNotThere) {
  const auto count = static_cast<std::uint32_t>(read_transfer(file_).mesh.positions.size());
  const std::string reason = "damaged transfer file: it names a vertex that is not there";
  for (const char* section : {"face", "remap"}) {
    EXPECT_EQ(with_number(section, count - 1), "") << section;
    EXPECT_EQ(with_number(section, count), reason) << section;
    EXPECT_EQ(with_number(section, kNoVertex - 1), reason) << section;
  }
  EXPECT_EQ(with_number("face", kNoVertex), reason);
  EXPECT_EQ(with_number("remap", kNoVertex), "") << "no face uses it";
}

TEST_F(HostileFile, IsRefusedWithCountsInItsHeaderThatDisagreeWithItsSections) {
  const auto header = nlohmann::json::parse(transfer_header(read_transfer(file_)));
  for (const char* name : {"vertices", "faces", "file_vertices"}) {
    const std::string entry = "\"" + std::string(name) + "\": " + header[name].dump();
    const std::string said = with_header(entry, "\"" + std::string(name) + "\": 7");
    EXPECT_NE(said.find("its JSON header says that `" + std::string(name) + "` is 7"), std::string::npos) << said;
  }
}

TEST_F(HostileFile, IsRefusedWithPartsOfNumbersAndNegativeAmountsInItsHeader) {
  const auto expect_refused = [&](const std::string& from, const std::string& to, const std::string& reason) {
    const std::string said = with_header(from, to);
    EXPECT_NE(said.find(reason), std::string::npos) << to << ": " << said;
  };
  expect_refused("\"degree\": 1,", "\"degree\":.5,", "its JSON header is not JSON: ");
  expect_refused("\"degree\": 1,\n", "\"degree\":1.5,", "has 1.5, expected a whole number from 0 to 10");
  expect_refused("\"degree\": 1,", "\"degree\":-1,", "transfer of degree -1, expected 0 to 10");
  expect_refused("\"result_degree\": 0,\n", "\"result_degree\":0.5,", "has 0.5, expected a whole number");
  expect_refused("\"result_degree\": 0,\n", "\"result_degree\":11,", "has 11, expected a whole number from 0 to 10");
  expect_refused("\"result_degree\": 0,\n", "\"result_degree\":10,", "transfer of kind DI and degree 1 with");
  expect_refused("\"columns\": 4,", "\"columns\": 5,", "with 3 channels of 1 x 5 numbers, expected 3 of 1 x 4");
  expect_refused("\"rows\": 1,", "\"rows\": 2,", "with 3 channels of 2 x 4 numbers, expected 3 of 1 x 4");
  expect_refused("\"channels\": 3,", "\"channels\": 1,", "with 1 channels of 1 x 4 numbers, expected 3 of 1 x 4");
  expect_refused(R"("sampler": "fibonacci")", R"("sampler": "fibonaccy")", "sampler fibonaccy, expected one of fib");
  expect_refused("\"directions\": 64,", "\"directions\": -4,", "has -4, expected a whole number");
  expect_refused("\"directions\": 128", "\"directions\": 1.5", "has 1.5, expected a whole number");
  expect_refused("\"seed\": 0,", "\"seed\":-1,", "has -1, expected a whole number");
  expect_refused("\"rows\": 1,\n", "\"rows\":1.5,", "has 1.5, expected a whole number");
  expect_refused("\"error\": 0.002,", "\"error\": -0.02,", "has -0.02, expected a number of 0 or more");
  expect_refused("\"tolerance\": 0.001", "\"tolerance\": -1.0 ", "has -1.0, expected a number of 0 or more");
  expect_refused(R"("kind": "DI",)", R"("kind": "\n",)", R"(transfer of kind \x0a, expected one of)");
  expect_refused("\"bytes_saved\": 12,", "\"bytes_saved\":1.5,", "has 1.5, expected a whole number");
}

TEST_F(HostileFile, SaysHowLongItIsWhereItEndsBeforeItsSections) {
  for (const std::size_t size : {std::size_t{0}, sizeof(layout::Prologue) - 1}) {
    write_all(file_, good_.substr(0, size));
    EXPECT_EQ(message_of([&] { read_transfer(file_); }),
              file_ + ": not a transfer file: " + std::to_string(size) + " bytes, expected at least 48");
  }
  EXPECT_EQ(refusal(good_.substr(0, sizeof(layout::Prologue))),
            "truncated or overlong transfer file: 48 bytes, expected " + std::to_string(good_.size()));
}

TEST_F(HostileFile, OfAnotherKindOrVersionIsRefusedHoweverRightItsChecksums) {
  for (std::size_t i = 0; i < layout::kMagic.size(); ++i) {
    std::string bytes = good_;
    bytes[i] ^= 1;
    EXPECT_EQ(refusal(bytes), "not a transfer file: it does not begin with `shprt`") << i;
  }
  for (const std::uint32_t version : {0U, layout::kVersion + 1, ~0U}) {
    std::string bytes = good_;
    std::memcpy(&bytes[layout::kMagic.size()], &version, sizeof version);
    EXPECT_EQ(refusal(bytes), "transfer file of version " + std::to_string(version) + ", expected 1 to 2");
  }
}

// 2^62 rows of four bytes more are no byte more in 64 bits.
TEST_F(HostileFile, IsRefusedWithASectionWhoseBytesAreTooManyToCount) {
  const std::string said = refusal(with_table(good_, [](auto& table) { table[5].rows += std::uint64_t{1} << 62; }));
  EXPECT_EQ(said, "damaged transfer file: section remap does not fit");
}

TEST_F(HostileFile, IsRefusedWithASectionThatDiffersInOneThing) {
  const auto refusal_with = [&](const auto& change) { return refusal(with_table(good_, change)); };
  EXPECT_EQ(refusal_with([](auto& table) {
              table[4].columns = 1;
              table[4].rows *= 3;
            }),
            "damaged transfer file: section face does not fit");
  EXPECT_EQ(refusal_with([](auto& table) { table[2].offset += 4; }),
            "damaged transfer file: section geonorm does not fit");
  EXPECT_EQ(refusal_with([](auto& table) { table[5].type = layout::kFloat; }),
            "damaged transfer file: section remap does not fit");
}

TEST_F(HostileFile, HasScalesWhereItsCoefficientsAreBytesAndNowhereElse) {
  Transfer transfer = read_transfer(file_);
  transfer.mesh.mirror.clear();
  transfer.mesh.specular.clear();
  transfer.mesh.exponent.clear();
  transfer.emitted.clear();
  const auto written = [&](Element element) {
    transfer.shape.storage.element = element;
    write_transfer(file_, transfer);
    return read_all(file_);
  };
  const std::string reason = "damaged transfer file: a scale belongs to 8-bit coefficients and to no others";
  std::string bytes = written(Element::kByte);
  const std::string scale = bytes.substr(place_of(bytes, "scale"));
  bytes = with_table(bytes.substr(0, bytes.size() - scale.size()), [](auto& table) { table.pop_back(); });
  EXPECT_EQ(refusal(bytes, true), reason);
  layout::Section section{layout::padded("scale"), layout::kFloat, 12, 1};
  ASSERT_EQ(scale.size(), bytes_of(section));
  for (const Element element : {Element::kSingle, Element::kHalf}) {
    bytes = with_table(written(element) + scale, [&](auto& table) { table.push_back(section); });
    EXPECT_EQ(refusal(bytes, true), reason);
  }
}

TEST_F(HostileFile, IsRefusedWithAScaleThatIsNegativeOrNotFinite) {
  Transfer transfer = read_transfer(file_);
  transfer.shape.storage.element = Element::kByte;
  write_transfer(file_, transfer);
  good_ = read_all(file_);
  for (const float bad : {-1.0F, -1e-30F, kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(with_number("scale", bad), "damaged transfer file: a scale is negative or not finite") << bad;
  }
  for (const float good : {0.0F, 1.0F}) EXPECT_EQ(with_number("scale", good), "");
}

TEST_F(HostileFile, HasItsLastSectionsToo) {
  const std::string bytes = good_.substr(0, place_of(good_, "face"));
  EXPECT_EQ(refusal(with_table(bytes, [](auto& table) { table.resize(4); }), true),
            "damaged transfer file: section face is missing");
  EXPECT_NE(refusal(with_table(good_, [](auto& table) { table.resize(layout::kSections.size() + 1); }), true)
                .find("sections, expected at most"),
            std::string::npos);
}

TEST_F(HostileFile, HasTheMatricesOfItsKindAndNoOthers) {
  Mesh mesh = primitive_mesh("plane");
  write_transfer(file_, baked(mesh, &kGlossyInterreflected, 64, 1));
  good_ = read_all(file_);
  EXPECT_EQ(refusal(good_), "");
  const std::string expected = ", expected 1 or 3 x squares of 1 to 2 half";
  EXPECT_EQ(with_header("    \"rows\": 4,", "    \"rows\": 9,"),
            "transfer file with indirect matrices of 1 x 9 x 4 \"half\"" + expected);
  EXPECT_EQ(with_header("    \"channels\": 1,", "    \"channels\": 2,"),
            "transfer file with indirect matrices of 2 x 4 x 4 \"half\"" + expected);
  EXPECT_EQ(with_header("    \"element\": \"half\"", "    \"element\": \"byte\""),
            "transfer file with indirect matrices of 1 x 4 x 4 \"byte\"" + expected);
  EXPECT_EQ(with_header("    \"channels\": 1,", "    \"channels\": 3,"),
            "damaged transfer file: section indirect does not fit");
  EXPECT_EQ(with_header("\"kind\": \"GI\"", "\"kind\": \"GS\""),
            "transfer file of kind GS with a section indirect, which it does not have");
  EXPECT_EQ(with_number("indirect", std::uint16_t{0x7e00}),
            "damaged transfer file: a transfer coefficient is not finite");
  const std::string cut = good_.substr(0, place_of(good_, "indirect"));
  EXPECT_EQ(refusal(with_table(cut, [](auto& table) { table.pop_back(); }), true),
            "damaged transfer file: section indirect is missing");
}

TEST_F(HostileFile, IsRefusedWhereItsPartsAndItsSizeDisagree) {
  const auto with_prologue = [&](std::string bytes, const auto& change) {
    layout::Prologue prologue;
    std::memcpy(&prologue, bytes.data(), sizeof prologue);
    change(prologue);
    std::memcpy(bytes.data(), &prologue, sizeof prologue);
    return refusal(bytes);
  };
  const auto of_size = [](std::size_t size) { return [size](auto& prologue) { prologue.file_size = size; }; };
  EXPECT_EQ(with_prologue(good_.substr(0, sizeof(layout::Prologue)), of_size(sizeof(layout::Prologue))),
            "truncated transfer file");
  EXPECT_EQ(with_prologue(good_ + '\0', of_size(good_.size() + 1)),
            "damaged transfer file: bytes after its last section");
  for (const std::uint64_t size : {good_.size() + 1, std::size_t{1} << 60}) {
    EXPECT_EQ(with_prologue(good_, [size](auto& prologue) { prologue.header_size = size; }),
              "damaged transfer file: its JSON header is longer than the file");
  }
}

TEST_F(HostileFile, IsNeverWritten) {
  const Transfer good = read_transfer(file_);
  const auto refusal_of = [&](const auto& spoil) {
    Transfer bad = good;
    spoil(bad);
    return message_of([&] { write_transfer(folder_.file("b.transfer"), bad); });
  };
  const std::string start = folder_.file("b.transfer") + ": cannot write: ";
  EXPECT_EQ(refusal_of([](Transfer& t) { t.mesh.positions[0].x() = kInfinity; }), start + "a position is not finite");
  EXPECT_EQ(refusal_of([](Transfer& t) { t.coefficients[3] = kNan; }), start + "a transfer coefficient is not finite");
  EXPECT_EQ(refusal_of([](Transfer& t) { t.mesh.albedo[0].y() = -1.0F; }), start + "an albedo is not from 0 to 1");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("b.transfer")));
}

TEST_F(HostileFile, KeepsAllColumnsIfItsListOfKeptColumnsIsEmpty) {
  Transfer transfer = read_transfer(file_);
  transfer.shape.storage.element = Element::kHalf;
  write_transfer(file_, transfer);
  EXPECT_EQ(nlohmann::json::parse(transfer_header(transfer))["storage"]["kept"], nlohmann::json::array());
  const Transfer read = read_transfer(file_);
  const std::vector<float> numbers = read.rows().all();
  ASSERT_EQ(numbers.size(), transfer.coefficients.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(numbers[i], transfer.coefficients[i], 1e-3F * std::abs(transfer.coefficients[i]) + 1e-7F);
  }
}

TEST(HostileJson, IsRefusedWhenItNestsTooDeep) {
  const TemporaryFolder folder;
  const std::string file = folder.file("deep.json");
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  for (const std::string& text : {nested(100'000), R"({"name": )" + nested(100'000) + "}", std::string(100'000, '[')}) {
    write_all(file, text);
    EXPECT_EQ(message_of([&] { load_scene(file, OnFlaw::kMend); }),
              file + ": not JSON for this program: expected at most 64 levels of arrays and objects, got more");
  }
  EXPECT_NO_THROW(output::parse_json<nlohmann::json>(nested(output::kDeepestJson)));
  EXPECT_ANY_THROW(output::parse_json<nlohmann::json>(nested(output::kDeepestJson + 1)));
  EXPECT_EQ(output::parse_json<nlohmann::json>(R"({"a": [1, {"b": null}]})").dump(), R"({"a":[1,{"b":null}]})");
}

}  // namespace
}  // namespace sh::prt::test
