
/// A light, prepared once for all vertices.
struct Light {
  float values[3 * kCoefficients];
};

/// light (3, kCoefficients): coefficients of the radiance, red, green, blue, in the axes of the mesh. Those outside of
/// kKept have to be zero.
inline Light prepared(const float* light) {
  Light made{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t k = 0; k < kKeptCount; ++k) {
      const std::size_t i = channel * kCoefficients + kKept[k];
      made.values[i] = light[i];
      if constexpr (kElement == Element::kByte) made.values[i] *= kScale[channel % kChannels * kKeptCount + k];
    }
  }
  return made;
}

/// Writes exit radiance, linear red, green, blue of each vertex, to radiance (kVertices, 3), for the vertices of the
/// blocks first .. last - 1. Blocks depend on nothing else: threads may share them out.
inline void relight(const Data& data, const Light& light, float* radiance, std::size_t first = 0,
                    std::size_t last = kBlocks) {
  using sh::emitted::Lanes;
  for (std::size_t block = first; block < last; ++block) {
    Lanes transfer[kChannels * kCoefficients];
    read_rows(data.rows, block, transfer);
    Lanes rgb[3];
    SH_EMITTED_RELIGHT(transfer, light.values, rgb);
    finish(data, block, rgb, radiance);
  }
}

/// The same under white light: light (kCoefficients), as `prepared` takes one channel.
inline Light prepared_white(const float* light) {
  float channels[3 * kCoefficients];
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) channels[i] = light[i % kCoefficients];
  return prepared(channels);
}

inline void relight_white(const Data& data, const Light& light, float* radiance, std::size_t first = 0,
                          std::size_t last = kBlocks) {
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
}
