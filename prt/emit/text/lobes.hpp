
/// The unit vectors that the vertices of a block mirror the direction to `eye` in.
inline void mirrored(const Data& data, const float* eye, std::size_t block, const sh::emitted::Lanes* normal,
                     sh::emitted::Lanes* out) {
  using sh::emitted::Lanes;
  Lanes position[3];
  read_triple(data, kPositionAt, block, position);
  for (std::size_t i = 0; i < sh::emitted::kBlock; ++i) {
    const float at[3] = {position[0].at(i), position[1].at(i), position[2].at(i)};
    float to_eye[3];
    direction_to(eye, at, to_eye);
    float cosine = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) cosine += to_eye[k] * normal[k].at(i);
    float back[3];
    float length = 0.0F;
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

/// Adds what the diffuse surface and the lobe of the vertices of a block send to the eye.
inline void add_lobes(const Data& data, const float* eye, std::size_t block, const sh::emitted::Lanes* normal,
                      const sh::emitted::Lanes* reaching, sh::emitted::Lanes* rgb) {
  using sh::emitted::Lanes;
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
}
