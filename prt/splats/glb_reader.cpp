// Reads GLB files with KHR_gaussian_splatting; see glb_splats.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "prt/binary/input_file.hpp"
#include "prt/splats/glb_document.hpp"
#include "prt/splats/glb_splats.hpp"
#include "prt/splats/splat_convention.hpp"
#include "prt/splats/splat_numbers.hpp"

namespace sh::prt {
namespace {

template <class T>
float component(const char* from, bool normalized) {
  T value{};
  std::memcpy(&value, from, sizeof value);
  const auto number = static_cast<float>(value);
  if (!normalized) return number;
  return std::max(number / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
}

/// A number of glTF; the document has checked the type.
float component(const char* from, int type, bool normalized) {
  switch (type) {
    case 5120:
      return component<std::int8_t>(from, normalized);
    case 5121:
      return component<std::uint8_t>(from, normalized);
    case 5122:
      return component<std::int16_t>(from, normalized);
    case 5123:
      return component<std::uint16_t>(from, normalized);
    default:
      return component<float>(from, false);
  }
}

/// Columns that are read together, because they stand in the same rows.
struct Rows {
  std::vector<std::size_t> columns;
  std::uint64_t offset = 0;  // of the first column
  std::size_t stride = 0;
  std::size_t size = 0;  // bytes of a row that hold columns
};

std::vector<Rows> rows_of(const std::vector<GlbColumn>& columns) {
  std::vector<Rows> all;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const GlbColumn& column = columns[c];
    const auto row = std::find_if(all.begin(), all.end(), [&](const Rows& rows) {
      return rows.stride == column.stride && column.offset >= rows.offset &&
             column.offset + column.size <= rows.offset + rows.stride;
    });
    if (row == all.end()) {
      all.push_back({{c}, column.offset, column.stride, column.size});
    } else {
      row->columns.push_back(c);
      row->size = std::max(row->size, static_cast<std::size_t>(column.offset - row->offset) + column.size);
    }
  }
  return all;
}

class GlbReader : public SplatReader {
 public:
  explicit GlbReader(const std::string& path)
      : file_(path),
        document_(read_glb_document(file_)),
        rows_(rows_of(document_.columns)),
        signs_(splat_signs(document_.degree)) {}

  [[nodiscard]] const std::string& file() const override { return file_.path(); }
  [[nodiscard]] std::size_t count() const override { return document_.count; }
  [[nodiscard]] int degree() const override { return document_.degree; }
  [[nodiscard]] Similarity placement() const override { return document_.placement; }

  void read(std::size_t first, std::size_t count, SplatBlock& block) const override {
    block.resize(count, document_.degree);
    block.first = first;
    block.record_size = 0;
    block.records.clear();
    if (count == 0) return;
    for (const Rows& rows : rows_) {
      std::vector<char> bytes((count - 1) * rows.stride + rows.size);
      file_.read(rows.offset + first * rows.stride, bytes.data(), bytes.size());
      for (const std::size_t c : rows.columns) {
        take(document_.columns[c], bytes.data() + (document_.columns[c].offset - rows.offset), block);
      }
    }
  }

  [[nodiscard]] std::string name_of(SplatNumber number, std::size_t index) const override {
    const std::size_t size = signs_.size();
    const auto of = [&](GlbPart part, std::size_t coefficient, std::size_t at) {
      const auto found = std::find_if(document_.columns.begin(), document_.columns.end(), [&](const GlbColumn& column) {
        return column.attribute.part == part && column.attribute.coefficient == coefficient;
      });
      return fmt::format("component {} of {}", at, found->attribute.name);
    };
    switch (number) {
      case SplatNumber::kPosition:
        return of(GlbPart::kPosition, 0, index);
      case SplatNumber::kRotation:
        return of(GlbPart::kRotation, 0, (index + 3) % 4);
      case SplatNumber::kScale:
        return of(GlbPart::kScale, 0, index);
      case SplatNumber::kOpacity:
        return of(GlbPart::kOpacity, 0, 0);
      case SplatNumber::kHarmonics:
        break;
    }
    return of(GlbPart::kHarmonics, index % size, index / size);
  }

  [[nodiscard]] nlohmann::ordered_json details() const override {
    return {{"generator", document_.generator},
            {"kernel", document_.kernel},
            {"color_space", document_.color_space},
            {"other_attributes", document_.other_attributes}};
  }

  [[nodiscard]] std::string extras() const override {
    return document_.other_attributes.empty() ? "" : "the attributes " + document_.other_attributes;
  }

 private:
  void take(const GlbColumn& column, const char* bytes, SplatBlock& block) const {
    const std::size_t components = column.attribute.components;
    const std::size_t step = size_of_component(column.component_type);
    std::array<float, 4> v{};
    for (std::size_t i = 0; i < block.count; ++i) {
      for (std::size_t k = 0; k < components; ++k) {
        v[k] = component(bytes + i * column.stride + k * step, column.component_type, column.normalized);
      }
      put(column.attribute, v, i, block);
    }
  }

  void put(const GlbAttribute& attribute, const std::array<float, 4>& v, std::size_t i, SplatBlock& block) const {
    const std::size_t size = signs_.size();
    switch (attribute.part) {
      case GlbPart::kPosition:
        std::copy_n(v.begin(), 3, &block.position[3 * i]);
        return;
      case GlbPart::kRotation:
        for (std::size_t k = 0; k < 4; ++k) block.rotation[4 * i + k] = v[(k + 3) % 4];
        return;
      case GlbPart::kScale:
        for (std::size_t k = 0; k < 3; ++k) block.log_scale[3 * i + k] = log_of_scale(static_cast<double>(v[k]));
        return;
      case GlbPart::kOpacity:
        block.opacity[i] = logit_of_opacity(static_cast<double>(v[0]));
        return;
      case GlbPart::kHarmonics:
        for (std::size_t channel = 0; channel < 3; ++channel) {
          block.harmonics[(3 * i + channel) * size + attribute.coefficient] =
              v[channel] * signs_[attribute.coefficient];
        }
        return;
    }
  }

  InputFile file_;
  GlbDocument document_;
  std::vector<Rows> rows_;
  std::vector<float> signs_;
};

}  // namespace

std::unique_ptr<SplatReader> read_glb_splats(const std::string& file) { return std::make_unique<GlbReader>(file); }

}  // namespace sh::prt
