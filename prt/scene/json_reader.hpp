// A JSON value with its path in its file, so that error messages can name the place:
//   scene.json: /meshes/0/max_edge: expected a positive number, got "x"
#pragma once
#include <Eigen/Core>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prt/names.hpp"

namespace sh::prt {

/// Parses a file; throws std::runtime_error with one line if it is missing or not JSON.
nlohmann::json read_json(const std::string& file);

/// All member functions that read throw std::runtime_error with one line, `file: path: expected ..., got ...`. Copies
/// refer to the same document, which must outlive them.
class JsonReader {
 public:
  JsonReader(const std::string& file, const nlohmann::json& value) : file_(&file), value_(&value) {}

  /// Refuses a value that is not an object, and an object with any other key.
  void allow(const std::vector<std::string_view>& keys) const;
  /// The value of the key; empty if the object has no such key.
  [[nodiscard]] std::optional<JsonReader> find(std::string_view key) const;
  [[nodiscard]] JsonReader at(std::string_view key) const;
  /// Replaces `to` by read(value, arguments...) if the object has this key.
  template <class T, class Read, class... Arguments>
  void take(std::string_view key, T& to, const Read& read, const Arguments&... arguments) const {
    if (const auto value = find(key)) to = static_cast<T>(std::invoke(read, *value, arguments...));
  }
  /// Replaces `to` by the value whose entry in `words` the key names.
  template <class Enumeration, class Words>
  void take_word(std::string_view key, Enumeration& to, const Words& words) const {
    if (const auto value = find(key)) {
      to = value_called<Enumeration>(value->one_of({std::begin(words), std::end(words)}), words).value();
    }
  }
  [[nodiscard]] std::vector<JsonReader> items() const;                            // of an array
  [[nodiscard]] std::vector<JsonReader> items(std::string_view key) const;        // of an array; none without the key
  [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;  // of an object whose keys are names

  [[nodiscard]] bool is(std::string_view type) const;  // array, boolean or string
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string one_of(const std::vector<std::string_view>& words) const;
  [[nodiscard]] double number(double least, double most, std::string_view expected) const;
  /// An angle in degrees. A value that is a multiple of pi / 12 to four digits is probably in radians and is refused.
  [[nodiscard]] double degrees(double least, double most) const;
  [[nodiscard]] float finite() const;
  [[nodiscard]] float positive() const;
  [[nodiscard]] int integer(int least, int most) const;
  [[nodiscard]] Eigen::Vector3f vector() const;  // three numbers
  [[nodiscard]] Eigen::Vector3f vector_within(float least, float most) const;
  [[nodiscard]] Eigen::Vector3d point() const;  // three numbers in double precision
  [[nodiscard]] double real() const;

  [[nodiscard]] const nlohmann::json& json() const { return *value_; }
  /// `file: path`, with which messages begin.
  [[nodiscard]] std::string place() const;
  [[noreturn]] void expected(std::string_view what) const;

 private:
  [[nodiscard]] Eigen::Vector3d numbers(double least, double most) const;
  JsonReader(const JsonReader& parent, std::string path, const nlohmann::json& value)
      : file_(parent.file_), path_(std::move(path)), value_(&value) {}

  const std::string* file_;
  std::string path_;
  const nlohmann::json* value_;
};

}  // namespace sh::prt
