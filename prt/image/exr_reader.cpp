// Reads OpenEXR pictures with the OpenEXR library.
// Reference: OpenEXR documentation, "Reading and writing image files"; channel names and layers: "Technical
// introduction", section "Channels".
#include <ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "numeric/output/printable.hpp"
#include "prt/image/image.hpp"

namespace sh::prt {
namespace {

/// The names of the channels that hold red, green and blue.
using ChannelNames = std::array<std::string, 3>;

std::vector<std::string> names_of(const Imf::ChannelList& channels) {
  std::vector<std::string> names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) names.emplace_back(channel.name());
  return names;
}

/// R, G, B of the unnamed layer, or of the only layer that has all three, or Y three times.
std::optional<ChannelNames> find_rgb(const std::vector<std::string>& names) {
  const auto has = [&](const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (has("R") && has("G") && has("B")) return ChannelNames{"R", "G", "B"};
  std::optional<ChannelNames> found;
  for (const std::string& name : names) {
    const std::string layer = name.ends_with(".R") ? name.substr(0, name.size() - 1) : std::string();
    if (layer.empty() || !has(layer + "G") || !has(layer + "B")) continue;
    if (found) {
      return std::nullopt;  // two layers: which one is the light?
    }
    found = ChannelNames{layer + "R", layer + "G", layer + "B"};
  }
  if (!found && has("Y") && !has("RY") && !has("BY")) return ChannelNames{"Y", "Y", "Y"};
  return found;
}

ChannelNames rgb_channels(const std::string& file, const Imf::ChannelList& channels) {
  const std::vector<std::string> names = names_of(channels);
  const auto rgb = find_rgb(names);
  if (!rgb) {
    throw std::runtime_error(fmt::format("{}: has the channels {}; expected R, G, B in one layer, or Y alone", file,
                                         output::printable(fmt::format("{}", fmt::join(names, ", ")))));
  }
  for (const std::string& name : *rgb) {
    const Imf::Channel& channel = channels[name];
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      throw std::runtime_error(fmt::format("{}: the channel {} is subsampled; expected a value for every pixel", file,
                                           output::printable(name)));
    }
  }
  return *rgb;
}

/// Warns if a file names primaries other than Rec. 709 (ACES, Rec. 2020, ...): its numbers then have another meaning.
void check_primaries(const std::string& file, const Imf::Header& header, OnFlaw on_flaw) {
  if (!Imf::hasChromaticities(header)) return;
  const Imf::Chromaticities found = Imf::chromaticities(header);
  const Imf::Chromaticities rec709;
  constexpr float kTolerance = 2e-3F;
  const auto near = [](const Imath::V2f& a, const Imath::V2f& b) { return a.equalWithAbsError(b, kTolerance); };
  if (!near(found.red, rec709.red) || !near(found.green, rec709.green) || !near(found.blue, rec709.blue) ||
      !near(found.white, rec709.white)) {
    report_flaw(on_flaw, fmt::format("{}: its primaries are not those of Rec. 709 (values taken as they are)", file));
  }
}

Image read_pixels(const std::string& file, OnFlaw on_flaw) {
  Imf::InputFile input(file.c_str());
  const Imf::Header& header = input.header();
  const Imath::Box2i window = header.dataWindow();
  const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
  const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
  require_sane_size(file, width, height);
  const ChannelNames names = rgb_channels(file, header.channels());
  check_primaries(file, header, on_flaw);
  Image image{static_cast<int>(width), static_cast<int>(height), {}, 0};
  image.pixels.resize(static_cast<std::size_t>(width * height));
  const std::size_t pixel = sizeof(Eigen::Vector3f);
  const std::size_t row = pixel * static_cast<std::size_t>(width);
  Imf::FrameBuffer buffer;
  const bool gray = names[0] == names[1];
  for (std::size_t c = 0; c < (gray ? 1U : 3U); ++c) {
    char* base = reinterpret_cast<char*>(image.pixels.data()) + c * sizeof(float);
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, base, window, pixel, row));
  }
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
  if (gray) {
    for (Eigen::Vector3f& p : image.pixels) p.setConstant(p.x());
  }
  return image;
}

}  // namespace

Image read_exr(const std::string& file, OnFlaw on_flaw) {
  try {
    return read_pixels(file, on_flaw);
  } catch (const Iex::BaseExc& error) {  // thrown by the library: its text may hold line breaks
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw std::runtime_error(fmt::format("{}: cannot read as OpenEXR: {}", file, output::printable(reason)));
  }
}

}  // namespace sh::prt
