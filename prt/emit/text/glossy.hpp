
/// A light, prepared once for all vertices.
struct Light {
  float values[3 * kCoefficients];
#if defined(SH_EMITTED_PREPARE)
  float samples[3 * kSamples];
#endif
#if defined(SH_EMITTED_CLUSTERS)
  std::vector<float> lit;  // (kClusterRows, 3, kCoefficients)
#endif
#if defined(SH_EMITTED_MATRIX_CLUSTERS)
  std::vector<float> lit_matrices;  // (kMatrixClusterRows, 3, kMatrixRows)
#endif
};

/// Visibility times light, projected, (3, kCoefficients), of a block of rows.
inline void direct(const Data& data, const Light& light, std::size_t block, sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
#if defined(SH_EMITTED_APPLY) || defined(SH_EMITTED_PRODUCT)
  Lanes visibility[kRow];
  read_rows(data.rows, block, visibility);
  if constexpr (kElement == Element::kByte) {
    for (std::size_t k = 0; k < kKeptCount; ++k) visibility[kKept[k]] = visibility[kKept[k]] * Lanes(kScale[k]);
  }
#endif
#if defined(SH_EMITTED_APPLY)
  SH_EMITTED_APPLY(visibility, light.samples, out);
#elif defined(SH_EMITTED_PRODUCT)
  Lanes of_light[3 * kCoefficients];
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) of_light[i] = Lanes(light.values[i]);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    SH_EMITTED_PRODUCT(visibility, of_light + channel * kCoefficients, out + channel * kCoefficients);
  }
#else
  static_cast<void>(data);
  static_cast<void>(block);
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) out[i] = Lanes(light.values[i]);
#endif
}

#if defined(SH_EMITTED_MATRIX_ROW)
/// The matrices of a block of rows times the light, (3, kMatrixRows).
inline void indirect(const Data& data, const Light& light, std::size_t block, sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
  constexpr std::size_t kSize = kMatrixChannels * kMatrixRows * kMatrixColumns;
  float incident[3 * kMatrixColumns];
  for (std::size_t i = 0; i < 3 * kMatrixColumns; ++i) {
    incident[i] = light.values[i / kMatrixColumns * kCoefficients + i % kMatrixColumns];
  }
  for (std::size_t row = 0; row < kMatrixRows; ++row) {
    Lanes entries[kMatrixChannels * kMatrixColumns];
    for (std::size_t channel = 0; channel < kMatrixChannels; ++channel) {
      for (std::size_t i = 0; i < kMatrixColumns; ++i) {
        read_number<kMatrixElement>(data.bytes + kMatricesAt, block, kSize,
                                    (channel * kMatrixRows + row) * kMatrixColumns + i,
                                    entries[channel * kMatrixColumns + i]);
      }
    }
    Lanes rgb[3];
    SH_EMITTED_MATRIX_ROW(entries, incident, rgb);
    for (std::size_t channel = 0; channel < 3; ++channel) out[channel * kMatrixRows + row] = rgb[channel];
  }
}
#endif

/// light (3, kCoefficients): coefficients of the radiance, red, green, blue, in the axes of the mesh. Those outside of
/// kLightKept have to be zero.
inline Light prepared(const Data& data, const float* light) {
  Light made{};
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) made.values[i] = light[i];
#if defined(SH_EMITTED_PREPARE)
  for (std::size_t channel = 0; channel < 3; ++channel) {
    SH_EMITTED_PREPARE(light + channel * kCoefficients, made.samples + channel * kSamples);
  }
#endif
#if defined(SH_EMITTED_CLUSTERS)
  made.lit.resize(3 * kCoefficients * kClusterRows);
  for (std::size_t block = 0; block * sh::emitted::kBlock < kClusterRows; ++block) {
    sh::emitted::Lanes reaching[3 * kCoefficients];
    direct(data, made, block, reaching);
    keep<3 * kCoefficients>(reaching, block, kClusterRows, made.lit);
  }
#endif
#if defined(SH_EMITTED_MATRIX_CLUSTERS)
  made.lit_matrices.resize(3 * kMatrixRows * kMatrixClusterRows);
  for (std::size_t block = 0; block * sh::emitted::kBlock < kMatrixClusterRows; ++block) {
    sh::emitted::Lanes reaching[3 * kMatrixRows];
    indirect(data, made, block, reaching);
    keep<3 * kMatrixRows>(reaching, block, kMatrixClusterRows, made.lit_matrices);
  }
#endif
  static_cast<void>(data);
  return made;
}

/// The radiance that reaches the vertices of a block, (3, kCoefficients): directly, and over other surfaces.
inline void transferred(const Data& data, const Light& light, std::size_t block, sh::emitted::Lanes* out) {
#if defined(SH_EMITTED_CLUSTERS)
  for (std::size_t i = 0; i < 3 * kCoefficients; ++i) out[i] = sh::emitted::Lanes(0.0F);
  add_mixed<3 * kCoefficients, kVectors>(data.bytes + kClusterAt, data.bytes + kWeightsAt, light.lit, block, out);
#else
  direct(data, light, block, out);
#endif
#if defined(SH_EMITTED_MATRIX_ROW)
  sh::emitted::Lanes more[3 * kMatrixRows];
#if defined(SH_EMITTED_MATRIX_CLUSTERS)
  for (sh::emitted::Lanes& value : more) value = sh::emitted::Lanes(0.0F);
  add_mixed<3 * kMatrixRows, kMatrixVectors>(data.bytes + kMatrixClusterAt, data.bytes + kMatrixWeightsAt,
                                             light.lit_matrices, block, more);
#else
  indirect(data, light, block, more);
#endif
  for (std::size_t i = 0; i < 3 * kMatrixRows; ++i) {
    const std::size_t to = i / kMatrixRows * kCoefficients + i % kMatrixRows;
    out[to] = out[to] + more[i];
  }
#endif
}

/// The unit vector from a point to the eye; 0 where they are one.
inline void direction_to(const float* eye, const float* from, float* out) {
  float length = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = eye[k] - from[k];
    length += out[k] * out[k];
  }
  length = std::sqrt(length);
  for (std::size_t k = 0; k < 3; ++k) out[k] = length > 0.0F ? out[k] / length : 0.0F;
}
