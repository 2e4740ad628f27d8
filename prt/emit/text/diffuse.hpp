
/// A light, prepared once for all vertices.
struct Light {
  float values[3 * kCoefficients];
#if defined(SH_EMITTED_CLUSTERS)
  std::vector<float> lit;  // (kClusterRows, 3)
#endif
};

/// light (3, kCoefficients): coefficients of the radiance, red, green, blue, in the axes of the mesh. Those outside of
/// kKept have to be zero.
inline Light prepared(const Data& data, const float* light) {
  Light made{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t k = 0; k < kKeptCount; ++k) {
      const std::size_t i = channel * kCoefficients + kKept[k];
      made.values[i] = light[i];
      if constexpr (kElement == Element::kByte) made.values[i] *= kScale[channel % kChannels * kKeptCount + k];
    }
  }
#if defined(SH_EMITTED_CLUSTERS)
  using sh::emitted::Lanes;
  made.lit.resize(3 * kClusterRows);
  for (std::size_t block = 0; block * sh::emitted::kBlock < kClusterRows; ++block) {
    Lanes transfer[kChannels * kCoefficients];
    read_rows(data.rows, block, transfer);
    Lanes rgb[3];
    SH_EMITTED_RELIGHT(transfer, made.values, rgb);
    keep<3>(rgb, block, kClusterRows, made.lit);
  }
#else
  static_cast<void>(data);
#endif
  return made;
}

/// Writes exit radiance, linear red, green, blue of each vertex, to radiance (kVertices, 3), for the vertices of the
/// blocks first .. last - 1. Blocks depend on nothing else: threads may share them out.
inline void relight(const Data& data, const Light& light, float* radiance, std::size_t first = 0,
                    std::size_t last = kBlocks) {
  using sh::emitted::Lanes;
  for (std::size_t block = first; block < last; ++block) {
#if defined(SH_EMITTED_CLUSTERS)
    Lanes rgb[3] = {Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};
    add_mixed<3, kVectors>(data.bytes + kClusterAt, data.bytes + kWeightsAt, light.lit, block, rgb);
#else
    Lanes transfer[kChannels * kCoefficients];
    read_rows(data.rows, block, transfer);
    Lanes rgb[3];
    SH_EMITTED_RELIGHT(transfer, light.values, rgb);
#endif
    finish(data, block, rgb, radiance);
  }
}

/// The same under white light: light (kCoefficients), as `prepared` takes one channel.
inline Light prepared_white(const Data& data, const float* light) {
  float channels[3 * kCoefficients];
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) channels[i] = light[i % kCoefficients];
  return prepared(data, channels);
}

inline void relight_white(const Data& data, const Light& light, float* radiance, std::size_t first = 0,
                          std::size_t last = kBlocks) {
#if defined(SH_EMITTED_CLUSTERS)
  relight(data, light, radiance, first, last);
#else
  using sh::emitted::Lanes;
  for (std::size_t block = first; block < last; ++block) {
    Lanes transfer[kChannels * kCoefficients];
    read_rows(data.rows, block, transfer);
    Lanes rgb[3];
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      rgb[channel] =
          SH_EMITTED_RELIGHT_WHITE(transfer + channel * kCoefficients, light.values + channel * kCoefficients);
    }
    for (std::size_t channel = kChannels; channel < 3; ++channel) rgb[channel] = rgb[0];
    finish(data, block, rgb, radiance);
  }
#endif
}
