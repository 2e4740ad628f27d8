
/// Four neighboring views of a table, and the weights of the cubic through them [Lagrange].
struct View {
  std::size_t first;
  float weights[4];
};

/// The view at the sine and cosine of the angle between the normal and the eye; below the surface that of grazing view.
inline View view_at(float sine, float cosine) {
  constexpr float kStep = 1.57079633F / static_cast<float>(kViews - 1);
  const float place = cosine > 0.0F ? std::atan2(sine, cosine) / kStep : static_cast<float>(kViews - 1);
  const auto before = static_cast<std::size_t>(place);
  const std::size_t first = before < 1 ? 0 : before - 1 < kViews - 4 ? before - 1 : kViews - 4;
  const float t = place - static_cast<float>(first);
  return {first,
          {-(t - 1.0F) * (t - 2.0F) * (t - 3.0F) / 6.0F, t * (t - 2.0F) * (t - 3.0F) / 2.0F,
           -t * (t - 1.0F) * (t - 3.0F) / 2.0F, t * (t - 1.0F) * (t - 2.0F) / 6.0F}};
}

/// The rotation, row by row, from the frame of a surface to the mesh: z is the normal, and the eye stands over x >= 0.
/// Returns the sine of the angle between the normal and the eye.
inline float frame_of(const float* normal, const float* to_eye, float cosine, float* rotation) {
  float x[3];
  for (std::size_t k = 0; k < 3; ++k) x[k] = to_eye[k] - cosine * normal[k];
  float length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  const float sine = length;
  if (length <= 1e-6F) {  // the eye is over the surface: any x serves
    const bool is_up = normal[0] * normal[0] + normal[1] * normal[1] <= 1e-10F * normal[2] * normal[2];
    x[0] = is_up ? 0.0F : -normal[1];
    x[1] = is_up ? -normal[2] : normal[0];
    x[2] = is_up ? normal[1] : 0.0F;
    length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  }
  for (float& value : x) value /= length;
  const float tilt = x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2];
  for (std::size_t k = 0; k < 3; ++k) x[k] -= tilt * normal[k];
  length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    rotation[3 * k] = x[k] / length;
    rotation[3 * k + 1] = (normal[next] * x[last] - normal[last] * x[next]) / length;
    rotation[3 * k + 2] = normal[k];
  }
  return sine;
}

/// lobe (kCoefficients): the coefficients of one part of a table, of order 0 and above, of a vertex of a block.
inline void read_lobe(const Data& data, std::size_t table, const View& view, std::size_t vertex,
                      sh::emitted::Lanes* lobe) {
  float even[kEven];
  for (float& value : even) value = 0.0F;
  for (std::size_t n = 0; n < 4; ++n) {
    float row[kEven];
    std::memcpy(row, data.bytes + kTablesAt + (table * kViews + view.first + n) * sizeof row, sizeof row);
    for (std::size_t k = 0; k < kEven; ++k) even[k] += view.weights[n] * row[k];
  }
  const float* from = even;
  for (std::size_t l = 0; l < kBands; ++l) {
    for (std::size_t m = 0; m <= l; ++m) lobe[l * (l + 1) + m].set(vertex, *from++);
  }
}

/// Adds what the BRDFs of the vertices of a block send to the eye. A vertex has the number 4 t + n: its n parts stand in
/// the tables t, t + 1, ...; 1: white, 2: of the color of the albedo and white, 3: red, green, blue; 0: no BRDF.
inline void add_reflected(const Data& data, const float* eye, std::size_t block, const sh::emitted::Lanes* normal,
                          const sh::emitted::Lanes* reaching, sh::emitted::Lanes* rgb) {
  using sh::emitted::kBlock;
  using sh::emitted::Lanes;
  std::uint16_t numbers[kBlock];
  std::memcpy(numbers, data.bytes + kBrdfAt + block * sizeof numbers, sizeof numbers);
  std::size_t most = 0;
  for (const std::uint16_t number : numbers) most = number % 4U > most ? number % 4U : most;
  if (most == 0) return;
  Lanes position[3];
  read_triple(data, kPositionAt, block, position);
  View views[kBlock];
  Lanes frame[9];
  for (std::size_t i = 0; i < kBlock; ++i) {
    float rotation[9] = {1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F};
    if (numbers[i] > 0) {
      const float up[3] = {normal[0].at(i), normal[1].at(i), normal[2].at(i)};
      const float at[3] = {position[0].at(i), position[1].at(i), position[2].at(i)};
      float to_eye[3];
      direction_to(eye, at, to_eye);
      const float cosine = up[0] * to_eye[0] + up[1] * to_eye[1] + up[2] * to_eye[2];
      views[i] = view_at(frame_of(up, to_eye, cosine, rotation), cosine);
    }
    for (std::size_t k = 0; k < 9; ++k) frame[k].set(i, rotation[k]);
  }
  Lanes base[3] = {Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};
  if constexpr (kBaseAt > 0) read_triple(data, kBaseAt, block, base);
  for (std::size_t part = 0; part < most; ++part) {
    Lanes lobe[kCoefficients];
    for (Lanes& values : lobe) values = Lanes(0.0F);
    Lanes color[3] = {Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::size_t parts = numbers[i] % 4U;
      if (part >= parts) continue;
      read_lobe(data, numbers[i] / 4U + part, views[i], i, lobe);
      for (std::size_t k = 0; k < 3; ++k) {
        const float own = k == part ? 1.0F : 0.0F;
        color[k].set(i, parts == 3 ? own : part + 1 == parts ? 1.0F : base[k].at(i));
      }
    }
    Lanes turned[kCoefficients];
    SH_EMITTED_ROTATE(frame, lobe, turned);
    Lanes sums[3];
    SH_EMITTED_GATHER(turned, reaching, sums);
    for (std::size_t k = 0; k < 3; ++k) rgb[k] = rgb[k] + color[k] * sums[k];
  }
}
