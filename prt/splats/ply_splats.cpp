#include "prt/splats/ply_splats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "numeric/output/atomic_file.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/splats/ply_records.hpp"

namespace sh::prt {
namespace {

class PlyReader : public SplatReader {
 public:
  explicit PlyReader(const std::string& path)
      : file_(path),
        header_(read_ply_header(file_)),
        degree_(splat_degree(header_, file_)),
        records_(file_, header_),
        map_(header_.properties, header_.record_size, degree_) {}

  [[nodiscard]] const std::string& file() const override { return file_.path(); }
  [[nodiscard]] std::size_t count() const override { return header_.count; }
  [[nodiscard]] int degree() const override { return degree_; }
  [[nodiscard]] const PlyHeader* ply() const override { return &header_; }

  void read(std::size_t first, std::size_t count, SplatBlock& block) const override {
    block.resize(count, degree_);
    block.first = first;
    block.record_size = header_.record_size;
    block.records.resize(count * block.record_size);
    records_.read(first, count, block.records.data());
    map_.take(block.records.data(), block);
  }

  [[nodiscard]] std::string name_of(SplatNumber number, std::size_t index) const override {
    const std::size_t size = splat_bands_squared(degree_);
    switch (number) {
      case SplatNumber::kPosition:
        return std::string(1, "xyz"[index]);
      case SplatNumber::kRotation:
        return fmt::format("rot_{}", index);
      case SplatNumber::kScale:
        return fmt::format("scale_{}", index);
      case SplatNumber::kOpacity:
        return "opacity";
      case SplatNumber::kHarmonics:
        break;
    }
    const std::size_t channel = index / size;
    const std::size_t k = index % size;
    return k == 0 ? fmt::format("f_dc_{}", channel) : fmt::format("f_rest_{}", channel * (size - 1) + k - 1);
  }

  [[nodiscard]] nlohmann::ordered_json details() const override {
    constexpr std::array kEncodings = {"ascii", "binary_little_endian", "binary_big_endian"};
    return {{"encoding", kEncodings[static_cast<std::size_t>(header_.encoding)]},
            {"bytes_a_splat", header_.record_size},
            {"other_properties", other_properties()},
            {"other_elements", header_.other_elements}};
  }

  [[nodiscard]] std::string extras() const override {
    const std::vector<std::string> properties = other_properties();
    if (properties.empty() && header_.other_elements.empty()) return {};
    std::string text = header_.other_elements.empty() ? "" : "the elements " + header_.other_elements;
    for (const std::string& name : properties) {
      text += (text.empty() ? "the properties " : &name == properties.data() ? ", the properties " : ", ") + name;
    }
    return text;
  }

  /// The bytes of the other elements.
  void read_rest(std::uint64_t offset, std::string& bytes) const {
    file_.read(header_.records + header_.body_size() + offset, bytes.data(), bytes.size());
  }
  [[nodiscard]] std::uint64_t rest_size() const {
    const bool has_rest = header_.encoding == PlyEncoding::kLittleEndian;
    return has_rest ? file_.size() - header_.records - header_.body_size() : 0;
  }

 private:
  [[nodiscard]] std::vector<std::string> other_properties() const {
    const std::vector<std::string> known = splat_properties(degree_);
    std::vector<std::string> names;
    for (const PlyProperty& property : header_.properties) {
      if (std::find(known.begin(), known.end(), property.name) == known.end()) names.push_back(property.name);
    }
    return names;
  }

  InputFile file_;
  PlyHeader header_;
  int degree_;
  PlyRecords records_;
  PlySplatMap map_;
};

/// The properties of the output: those of the input, with coefficients of the other degree in place of its own.
std::vector<PlyProperty> output_properties(const SplatOutput& output, const PlyHeader* like) {
  std::vector<PlyProperty> properties;
  const auto add = [&](const std::string& name, PlyType type) {
    const std::size_t offset = properties.empty() ? 0 : properties.back().offset + size_of(properties.back().type);
    properties.push_back({name, type, offset});
  };
  if (like == nullptr) {
    for (const std::string& name : splat_properties(output.degree)) add(name, PlyType::kFloat);
    return properties;
  }
  const std::size_t rest = 3 * (splat_bands_squared(output.degree) - 1);
  const bool has_rest = like->find("f_rest_0") != nullptr;
  std::size_t added = 0;
  const auto add_rest = [&] {
    for (; added < rest; ++added) add(fmt::format("f_rest_{}", added), PlyType::kFloat);
  };
  for (const PlyProperty& property : like->properties) {
    if (!property.name.starts_with("f_rest_")) add(property.name, property.type);
    if (property.name == (has_rest ? "f_rest_0" : "f_dc_2")) add_rest();
  }
  return properties;
}

class PlyWriter : public SplatWriter {
 public:
  explicit PlyWriter(const SplatOutput& output)
      : input_(output.input != nullptr ? dynamic_cast<const PlyReader*>(output.input) : nullptr),
        is_same_layout_(input_ != nullptr && input_->degree() == output.degree),
        properties_(is_same_layout_ ? input_->ply()->properties
                                    : output_properties(output, input_ == nullptr ? nullptr : input_->ply())),
        record_size_(properties_.back().offset + size_of(properties_.back().type)),
        parts_(input_ == nullptr ? kAllSplatParts : output.changed),
        map_(properties_, record_size_, output.degree),
        file_(output.file) {
    const PlyHeader* like = input_ == nullptr ? nullptr : input_->ply();
    const std::string text = ply_header_text(properties_, output.summary.count, like);
    file_.write(text.data(), text.size());
    if (input_ != nullptr && !is_same_layout_) {
      parts_.harmonics = true;
      add_copies(*like);
    }
  }

  [[nodiscard]] SplatPieces encode(const SplatBlock& block) const override {
    std::string bytes = is_same_layout_ ? std::string(block.records.begin(), block.records.end())
                                        : std::string(block.count * record_size_, '\0');
    for (std::size_t i = 0; i < block.count; ++i) {
      for (const Copy& copy : copies_) {
        std::memcpy(&bytes[i * record_size_ + copy.to], &block.records[i * block.record_size + copy.from], copy.size);
      }
    }
    map_.put(block, parts_, bytes.data());
    return {std::move(bytes)};
  }

  void append(const SplatPieces& pieces) override { file_.write(pieces[0].data(), pieces[0].size()); }

  void finish() override {
    constexpr std::uint64_t kPart = std::uint64_t{1} << 22U;
    const std::uint64_t size = input_ == nullptr ? 0 : input_->rest_size();
    for (std::uint64_t offset = 0; offset < size; offset += kPart) {
      std::string bytes(std::min(kPart, size - offset), '\0');
      input_->read_rest(offset, bytes);
      file_.write(bytes.data(), bytes.size());
    }
    file_.commit();
  }

 private:
  struct Copy {
    std::size_t from;
    std::size_t to;
    std::size_t size;
  };

  // What both layouts have: its bytes are copied before the changed parts are written.
  void add_copies(const PlyHeader& from) {
    for (const PlyProperty& property : properties_) {
      const PlyProperty* source = from.find(property.name);
      if (source != nullptr && !property.name.starts_with("f_rest_"))
        copies_.push_back({source->offset, property.offset, size_of(property.type)});
    }
  }

  const PlyReader* input_;  // null: the input is no PLY file
  bool is_same_layout_;
  std::vector<PlyProperty> properties_;
  std::size_t record_size_;
  std::vector<Copy> copies_;
  SplatParts parts_;
  PlySplatMap map_;
  output::AtomicFile file_;
};

}  // namespace

std::unique_ptr<SplatReader> read_ply_splats(const std::string& file) { return std::make_unique<PlyReader>(file); }

std::unique_ptr<SplatWriter> write_ply_splats(const SplatOutput& output) { return std::make_unique<PlyWriter>(output); }

}  // namespace sh::prt
