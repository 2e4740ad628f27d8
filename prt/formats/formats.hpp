// The files and code fragments of engines that prt writes and reads: one table for lights, one for transfer. A new
// format needs a file of this folder with its writer (and reader), and a line in formats.cpp; FORMATS.md describes each.
#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "prt/formats/engine_light.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt::formats {

/// The bytes of a file, and its JSON if they are text that begins with { or a GLB file.
struct Document {
  std::string_view bytes;
  std::optional<nlohmann::json> json;
};

struct LightFormat {
  std::string_view name;    // on the command line
  std::string_view ending;  // of its files
  int degree;               // the highest that it holds
  EngineConvention convention;
  std::string (*write)(const EngineLight& light);
  /// The coefficients of a file of this format; nothing for another file. Throws std::runtime_error, without the file's
  /// name, for a file of this format that is damaged. Null: a code fragment, which is not read.
  std::optional<Triples> (*read)(const Document& document) = nullptr;
};

struct TransferFormat {
  std::string_view name;
  std::string_view ending;
  /// Throws std::runtime_error, without a file's name, for transfer that the format has no place for.
  std::string (*write)(const Transfer& transfer);
};

std::span<const LightFormat> light_formats();
std::span<const TransferFormat> transfer_formats();

/// The format of this name; null if there is none.
const LightFormat* find_light_format(std::string_view name);
const TransferFormat* find_transfer_format(std::string_view name);

/// A file that was read.
struct ImportedLight {
  LightCoefficients light;
  const LightFormat* format;
};

/// Reads the light in a file of any format with a reader. Throws std::runtime_error, one line with the file's name.
ImportedLight import_light(const std::string& file);

}  // namespace sh::prt::formats
