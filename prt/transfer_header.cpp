// The JSON header of a transfer file: what a person or a program must know to use the numbers.
#include <nlohmann/json.hpp>

#include "prt/transfer_file.hpp"

namespace sh::prt {

std::string transfer_header(const Transfer& transfer) {
  const nlohmann::ordered_json header = {
      {"format", "shforge transfer"},
      {"scene", transfer.scene},
      {"kind", transfer.kind == TransferKind::kShadowed ? "DS" : "DU"},
      {"degree", transfer.degree},
      {"rows", 1},
      {"columns", transfer.bands_squared()},
      {"vertices", transfer.mesh.positions.size()},
      {"faces", transfer.mesh.faces.size()},
      {"file_vertices", transfer.mesh.remap.size()},
      {"directions", transfer.directions},
      {"instruction_set", transfer.instruction_set},
      {"holds", "cosine and 1/pi, not the albedo: exit radiance = albedo * sum_i T_i L_i"},
      {"convention", "real SH, orthonormal, no Condon-Shortley phase, i = l(l+1)+m, band 1 is (y,z,x)"},
      {"axes", "right-handed, z up"},
      {"units", "positions: the scene's; transfer: radiance out over radiance in, no unit"},
      {"colour_space", "albedo: linear RGB, 0..1"}};
  return header.dump(2);
}

}  // namespace sh::prt
