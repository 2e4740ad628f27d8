#include "prt/splats/ply_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>

#include "numeric/output/read_file.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/splats/splat_convention.hpp"
#include "prt/splats/splat_numbers.hpp"

namespace sh::prt {
namespace {

static_assert(std::endian::native == std::endian::little, "records are read and written as they are in memory");

template <class T>
bool append_number(const char*& next, const char* end, std::string& to) {
  T value{};
  const auto read = std::from_chars(next, end, value);
  if (read.ec != std::errc()) return false;
  next = read.ptr;
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
  return true;
}

template <class T>
bool append_small(const char*& next, const char* end, std::string& to) {
  int value = 0;
  const auto read = std::from_chars(next, end, value);
  if (read.ec != std::errc() || value != static_cast<T>(value)) return false;
  next = read.ptr;
  const auto small = static_cast<T>(value);
  to.append(reinterpret_cast<const char*>(&small), sizeof small);
  return true;
}

bool append_as(PlyType type, const char*& next, const char* end, std::string& to) {
  switch (type) {
    case PlyType::kInt8:
      return append_small<std::int8_t>(next, end, to);
    case PlyType::kUint8:
      return append_small<std::uint8_t>(next, end, to);
    case PlyType::kInt16:
      return append_small<std::int16_t>(next, end, to);
    case PlyType::kUint16:
      return append_small<std::uint16_t>(next, end, to);
    case PlyType::kInt32:
      return append_number<std::int32_t>(next, end, to);
    case PlyType::kUint32:
      return append_number<std::uint32_t>(next, end, to);
    case PlyType::kFloat:
      return append_number<float>(next, end, to);
    case PlyType::kDouble:
      return append_number<double>(next, end, to);
  }
  return false;
}

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

std::string records_of_text(const InputFile& file, const PlyHeader& header) {
  const std::string body = output::read_file(file.path(), std::size_t{1} << 36U).substr(header.records);
  const char* next = body.data();
  const char* const end = next + body.size();
  const auto skip = [&] {
    while (next < end && is_space(*next)) ++next;
  };
  std::string records;
  for (std::uint64_t i = 0; i < header.count; ++i) {
    for (const PlyProperty& property : header.properties) {
      skip();
      if (next == end)
        file.fail(fmt::format("truncated: the header announces {} splats, the file has {}", header.count, i));
      const char* const start = next;
      if (!append_as(property.type, next, end, records) || (next < end && !is_space(*next))) {
        const char* const stop = std::find_if(start, std::min(end, start + 32), is_space);
        file.fail(
            fmt::format("splat {}: expected a number of {}, got `{}`", i, property.name, std::string(start, stop)));
      }
    }
  }
  skip();
  if (next != end) file.fail(fmt::format("the header announces {} splats, the file has more numbers", header.count));
  return records;
}

void swap_bytes(const PlyHeader& header, std::size_t count, char* records) {
  for (std::size_t i = 0; i < count; ++i) {
    for (const PlyProperty& property : header.properties) {
      char* number = records + i * header.record_size + property.offset;
      std::reverse(number, number + size_of(property.type));
    }
  }
}

}  // namespace

PlyRecords::PlyRecords(const InputFile& file, const PlyHeader& header) : file_(file), header_(header) {
  if (header.encoding == PlyEncoding::kText) text_ = records_of_text(file, header);
}

void PlyRecords::read(std::size_t first, std::size_t count, char* to) const {
  const std::size_t size = count * header_.record_size;
  if (header_.encoding == PlyEncoding::kText) {
    std::memcpy(to, text_.data() + first * header_.record_size, size);
    return;
  }
  file_.read(header_.records + std::uint64_t{first} * header_.record_size, to, size);
  if (header_.encoding == PlyEncoding::kBigEndian) swap_bytes(header_, count, to);
}

PlySplatMap::PlySplatMap(const std::vector<PlyProperty>& properties, std::size_t record_size, int degree)
    : record_size_(record_size), signs_(splat_signs(degree)) {
  const auto add = [&](Places& places, const std::string& name) {
    const auto found =
        std::find_if(properties.begin(), properties.end(), [&](const auto& p) { return p.name == name; });
    if (found != properties.end()) places.add({found->offset, found->type == PlyType::kDouble});
  };
  for (const char* name : {"x", "y", "z"}) add(position_, name);
  for (const char* name : {"nx", "ny", "nz"}) add(normal_, name);
  for (const char* name : {"rot_0", "rot_1", "rot_2", "rot_3"}) add(rotation_, name);
  for (const char* name : {"scale_0", "scale_1", "scale_2"}) add(scale_, name);
  for (const char* name : {"f_dc_0", "f_dc_1", "f_dc_2"}) add(constant_, name);
  add(opacity_, "opacity");
  if (normal_.all.size() != 3) normal_ = {};
  for (std::size_t i = 0; i < 3 * (signs_.size() - 1); ++i) add(rest_, fmt::format("f_rest_{}", i));
}

void PlySplatMap::Places::add(const Place& place) {
  is_run &= !place.is_double && (all.empty() || place.offset == all.back().offset + sizeof(float));
  all.push_back(place);
}

void PlySplatMap::take_row(const Places& places, const char* record, float* row) {
  if (places.all.empty()) return;
  if (places.is_run) {
    std::memcpy(row, record + places.all[0].offset, places.all.size() * sizeof(float));
    return;
  }
  for (const Place& place : places.all) {
    if (place.is_double) {
      double value = 0.0;
      std::memcpy(&value, record + place.offset, sizeof value);
      *row++ = to_single(value);
    } else {
      std::memcpy(row++, record + place.offset, sizeof(float));
    }
  }
}

void PlySplatMap::put_row(const Places& places, const float* row, char* record) {
  if (places.all.empty()) return;
  if (places.is_run) {
    std::memcpy(record + places.all[0].offset, row, places.all.size() * sizeof(float));
    return;
  }
  for (const Place& place : places.all) {
    if (place.is_double) {
      const auto value = static_cast<double>(*row++);
      std::memcpy(record + place.offset, &value, sizeof value);
    } else {
      std::memcpy(record + place.offset, row++, sizeof(float));
    }
  }
}

void PlySplatMap::take(const char* records, SplatBlock& block) const {
  const std::size_t size = signs_.size();
  std::vector<float> rest(3 * (size - 1));
  for (std::size_t i = 0; i < block.count; ++i) {
    const char* record = records + i * record_size_;
    take_row(position_, record, &block.position[3 * i]);
    take_row(normal_, record, &block.normal[3 * i]);
    take_row(rotation_, record, &block.rotation[4 * i]);
    take_row(scale_, record, &block.log_scale[3 * i]);
    take_row(opacity_, record, &block.opacity[i]);
    float* c = &block.harmonics[3 * size * i];
    std::array<float, 3> constant{};
    take_row(constant_, record, constant.data());
    take_row(rest_, record, rest.data());
    for (std::size_t channel = 0; channel < 3; ++channel) {
      c[channel * size] = constant[channel] * signs_[0];
      for (std::size_t k = 1; k < size; ++k) c[channel * size + k] = rest[channel * (size - 1) + k - 1] * signs_[k];
    }
  }
}

void PlySplatMap::put(const SplatBlock& block, const SplatParts& parts, char* records) const {
  const std::size_t size = signs_.size();
  std::vector<float> rest(3 * (size - 1));
  for (std::size_t i = 0; i < block.count; ++i) {
    char* record = records + i * record_size_;
    if (parts.position) put_row(position_, &block.position[3 * i], record);
    if (parts.rotation) {
      put_row(normal_, &block.normal[3 * i], record);
      put_row(rotation_, &block.rotation[4 * i], record);
    }
    if (parts.scale) put_row(scale_, &block.log_scale[3 * i], record);
    const float* c = &block.harmonics[3 * size * i];
    if (parts.rest) {
      const std::array<float, 3> constant = {c[0] * signs_[0], c[size] * signs_[0], c[2 * size] * signs_[0]};
      put_row(opacity_, &block.opacity[i], record);
      put_row(constant_, constant.data(), record);
    }
    if (!parts.harmonics) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t k = 1; k < size; ++k) rest[channel * (size - 1) + k - 1] = c[channel * size + k] * signs_[k];
    }
    put_row(rest_, rest.data(), record);
  }
}

}  // namespace sh::prt
