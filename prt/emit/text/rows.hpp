
/// The data of this run time in memory, as relight.bin holds it.
struct Data {
  const unsigned char* rows = nullptr;
  const unsigned char* bytes = nullptr;
};

/// Whether `count` bytes are the data of this run time: their number and their first 8 bytes, a checksum of the others.
inline bool is_data(const unsigned char* bytes, std::size_t count) {
  std::uint64_t checksum = 0;
  if (count != kBytes) return false;
  std::memcpy(&checksum, bytes, sizeof checksum);
  return checksum == kChecksum;
}

/// Precondition: is_data. The bytes must outlive the result.
inline Data data_of(const unsigned char* bytes) { return {bytes + kRowsAt, bytes}; }

/// Number k of the vertices of a block: `size` numbers a vertex, each of all 16 vertices in turn.
template <Element Type>
inline void read_number(const unsigned char* numbers, std::size_t block, std::size_t size, std::size_t k,
                        sh::emitted::Lanes& to) {
  constexpr std::size_t kNumber = Type == Element::kSingle ? 4 : Type == Element::kHalf ? 2 : 1;
  const unsigned char* from = numbers + (block * size + k) * sh::emitted::kBlock * kNumber;
  if constexpr (Type == Element::kSingle) to.load_single(from);
  if constexpr (Type == Element::kHalf) to.load_half(from);
  if constexpr (Type == Element::kByte) to.load_byte(from);
}

/// Three numbers of the section at `offset`.
inline void read_triple(const Data& data, std::size_t offset, std::size_t block, sh::emitted::Lanes* to) {
  for (std::size_t k = 0; k < 3; ++k) read_number<Element::kSingle>(data.bytes + offset, block, 3, k, to[k]);
}

/// out (kChannels, kCoefficients); entries outside of kKept stay as they are.
inline void read_rows(const unsigned char* rows, std::size_t block, sh::emitted::Lanes* out) {
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    for (std::size_t k = 0; k < kKeptCount; ++k) {
      read_number<kElement>(rows, block, kChannels * kKeptCount, channel * kKeptCount + k,
                            out[channel * kRow + kKept[k]]);
    }
  }
}

/// Adds the light of the surfaces themselves and writes red, green, blue of each vertex of a block.
inline void write_radiance(const Data& data, std::size_t block, sh::emitted::Lanes* rgb, float* radiance) {
  using sh::emitted::kBlock;
  if constexpr (kEmittedAt > 0) {
    sh::emitted::Lanes emitted[3];
    read_triple(data, kEmittedAt, block, emitted);
    for (std::size_t k = 0; k < 3; ++k) rgb[k] = rgb[k] + emitted[k];
  }
  const std::size_t first = block * kBlock;
  for (std::size_t i = 0; i < kBlock && first + i < kVertices; ++i) {
    for (std::size_t k = 0; k < 3; ++k) radiance[3 * (first + i) + k] = rgb[k].at(i);
  }
}

/// The same, times the albedo if the rows do not hold it.
inline void finish(const Data& data, std::size_t block, sh::emitted::Lanes* rgb, float* radiance) {
  if constexpr (kAlbedoAt > 0) {
    sh::emitted::Lanes albedo[3];
    read_triple(data, kAlbedoAt, block, albedo);
    for (std::size_t k = 0; k < 3; ++k) rgb[k] = rgb[k] * albedo[k];
  }
  write_radiance(data, block, rgb, radiance);
}
