
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
  std::vector<float> lit_matrices;  // (kMatrixClusterRows, 3, kCoefficients)
#endif
};

/// Visibility times light, projected, (3, kCoefficients), of a block of rows.
inline void direct(const Data& data, const Light& light, std::size_t block, sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
#if defined(SH_EMITTED_APPLY) || defined(SH_EMITTED_PRODUCT)
  Lanes visibility[kRow];
  read_rows(data.rows, block, visibility);
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
/// out (3, kCoefficients) += the matrices of a block of rows times the light.
inline void add_indirect(const Data& data, const Light& light, std::size_t block, sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
  constexpr std::size_t kSize = kMatrixChannels * kCoefficients * kCoefficients;
  for (std::size_t row = 0; row < kCoefficients; ++row) {
    Lanes entries[kMatrixChannels * kCoefficients];
    for (std::size_t channel = 0; channel < kMatrixChannels; ++channel) {
      for (std::size_t i = 0; i < kCoefficients; ++i) {
        read_number<kMatrixElement>(data.bytes + kMatricesAt, block, kSize,
                                    (channel * kCoefficients + row) * kCoefficients + i,
                                    entries[channel * kCoefficients + i]);
      }
    }
    Lanes rgb[3];
    SH_EMITTED_MATRIX_ROW(entries, light.values, rgb);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      out[channel * kCoefficients + row] = out[channel * kCoefficients + row] + rgb[channel];
    }
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
  made.lit_matrices.resize(3 * kCoefficients * kMatrixClusterRows);
  for (std::size_t block = 0; block * sh::emitted::kBlock < kMatrixClusterRows; ++block) {
    sh::emitted::Lanes reaching[3 * kCoefficients];
    for (sh::emitted::Lanes& value : reaching) value = sh::emitted::Lanes(0.0F);
    add_indirect(data, made, block, reaching);
    keep<3 * kCoefficients>(reaching, block, kMatrixClusterRows, made.lit_matrices);
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
#if defined(SH_EMITTED_MATRIX_CLUSTERS)
  add_mixed<3 * kCoefficients, kMatrixVectors>(data.bytes + kMatrixClusterAt, data.bytes + kMatrixWeightsAt,
                                               light.lit_matrices, block, out);
#elif defined(SH_EMITTED_MATRIX_ROW)
  add_indirect(data, light, block, out);
#endif
}

/// The unit vectors that the vertices of a block mirror the direction to `eye` in.
inline void mirrored(const Data& data, const float* eye, std::size_t block, const sh::emitted::Lanes* normal,
                     sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
  Lanes position[3];
  read_triple(data, kPositionAt, block, position);
  for (std::size_t i = 0; i < sh::emitted::kBlock; ++i) {
    float to_eye[3];
    float length = 0.0F;
    float cosine = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      to_eye[k] = eye[k] - position[k].at(i);
      length += to_eye[k] * to_eye[k];
    }
    length = std::sqrt(length);
    for (std::size_t k = 0; k < 3; ++k) {
      to_eye[k] = length > 0.0F ? to_eye[k] / length : 0.0F;
      cosine += to_eye[k] * normal[k].at(i);
    }
    float back[3];
    length = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      back[k] = 2.0F * cosine * normal[k].at(i) - to_eye[k];
      length += back[k] * back[k];
    }
    length = std::sqrt(length);
    for (std::size_t k = 0; k < 3; ++k) out[k].set(i, length > 0.0F ? back[k] / length : 0.0F);
  }
}

/// Adds color times what a zonal function about `direction` gathers of the transferred radiance.
inline void gather(const Data& data, std::size_t color_at, std::size_t block, const sh::emitted::Lanes* zonal,
                   const sh::emitted::Lanes* direction, const sh::emitted::Lanes* reaching, sh::emitted::Lanes* rgb) {
  using sh::emitted::Lanes;
  Lanes lobe[kCoefficients];
  SH_EMITTED_ZONAL(zonal, direction[0], direction[1], direction[2], lobe);
  Lanes sums[3];
  SH_EMITTED_GATHER(lobe, reaching, sums);
  Lanes color[3];
  read_triple(data, color_at, block, color);
  for (std::size_t k = 0; k < 3; ++k) rgb[k] = rgb[k] + color[k] * sums[k];
}

/// Writes exit radiance towards `eye`, a point in the coordinates of the mesh, linear red, green, blue of each vertex, to
/// radiance (kVertices, 3), for the vertices of the blocks first .. last - 1. Blocks depend on nothing else: threads may
/// share them out.
inline void relight(const Data& data, const Light& light, const float* eye, float* radiance, std::size_t first = 0,
                    std::size_t last = kBlocks) {
  using sh::emitted::Lanes;
  for (std::size_t block = first; block < last; ++block) {
    Lanes reaching[3 * kCoefficients];
    transferred(data, light, block, reaching);
    Lanes normal[3];
    read_triple(data, kNormalAt, block, normal);
    Lanes rgb[3] = {Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};
    if constexpr (kAlbedoAt > 0) {
      Lanes cosine[kBands];
      for (std::size_t l = 0; l < kBands; ++l) cosine[l] = Lanes(kCosine[l]);
      gather(data, kAlbedoAt, block, cosine, normal, reaching, rgb);
    }
    if constexpr (kSpecularAt > 0) {
      Lanes lobe[kBands];
      for (std::size_t l = 0; l < kBands; ++l) {
        read_number<Element::kSingle>(data.bytes + kLobeAt, block, kBands, l, lobe[l]);
      }
      Lanes direction[3];
      mirrored(data, eye, block, normal, direction);
      gather(data, kSpecularAt, block, lobe, direction, reaching, rgb);
    }
    write_radiance(data, block, rgb, radiance);
  }
}
