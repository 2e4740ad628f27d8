
/// lit (rows, Width) = values (Width) of the rows of a block.
template <std::size_t Width>
inline void keep(const sh::emitted::Lanes* values, std::size_t block, std::size_t rows, std::vector<float>& lit) {
  const std::size_t first = block * sh::emitted::kBlock;
  for (std::size_t i = 0; i < sh::emitted::kBlock && first + i < rows; ++i) {
    for (std::size_t k = 0; k < Width; ++k) lit[(first + i) * Width + k] = values[k].at(i);
  }
}

/// out (Width) += the mean and the vectors of the cluster of each vertex of a block, mixed by its weights. lit (rows,
/// Width): under a light; the mean of a cluster, then its vectors.
template <std::size_t Width, std::size_t Vectors>
inline void add_mixed(const unsigned char* clusters, const unsigned char* weights, const std::vector<float>& lit,
                      std::size_t block, sh::emitted::Lanes* out) {
  constexpr float kStep = 1.0F / 127.0F;
  const std::size_t first = block * sh::emitted::kBlock;
  for (std::size_t i = 0; i < sh::emitted::kBlock && first + i < kVertices; ++i) {
    std::uint16_t cluster = 0;
    std::memcpy(&cluster, clusters + (first + i) * sizeof cluster, sizeof cluster);
    const float* row = lit.data() + cluster * (1 + Vectors) * Width;
    float sums[Width];
    for (std::size_t k = 0; k < Width; ++k) sums[k] = row[k];
    for (std::size_t j = 0; j < Vectors; ++j) {
      signed char steps = 0;
      std::memcpy(&steps, weights + (block * Vectors + j) * sh::emitted::kBlock + i, sizeof steps);
      const float weight = kStep * static_cast<float>(steps);
      row += Width;
      for (std::size_t k = 0; k < Width; ++k) sums[k] += weight * row[k];
    }
    for (std::size_t k = 0; k < Width; ++k) out[k].set(i, out[k].at(i) + sums[k]);
  }
}
