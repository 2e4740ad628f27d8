
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
#if defined(SH_EMITTED_ZONAL)
    add_lobes(data, eye, block, normal, reaching, rgb);
#endif
#if defined(SH_EMITTED_ROTATE)
    add_reflected(data, eye, block, normal, reaching, rgb);
#endif
    write_radiance(data, block, rgb, radiance);
  }
}
