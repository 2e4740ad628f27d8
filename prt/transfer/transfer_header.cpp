// The JSON header of a transfer file: what a person or a program must know to use the numbers.
#include <nlohmann/json.hpp>

#include "prt/transfer/plan_json.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_names.hpp"

namespace sh::prt {

namespace {

nlohmann::ordered_json to_json(const BounceReport& report) {
  nlohmann::ordered_json json = {
      {"solver", report.solver},
      {"applications", report.applications},
      {"certified", report.certified},
      {"bound", report.certified ? nlohmann::ordered_json(report.bound) : nlohmann::ordered_json()},
      {"residual", report.residual},
      {"largest", report.largest},
      {"spectral_bound", report.spectral_bound}};
  if (report.emitted_largest > 0.0) {
    json["emitted_bound"] = report.certified ? nlohmann::ordered_json(report.emitted_bound) : nlohmann::ordered_json();
    json["emitted_largest"] = report.emitted_largest;
  }
  return json;
}

}  // namespace

std::string transfer_header(const Transfer& transfer) {
  const bool bounces = transfer.kind == TransferKind::kInterreflected;
  nlohmann::ordered_json header = {
      {"format", "shforge transfer"},
      {"scene", transfer.scene},
      {"kind", name_of(transfer.kind).file},
      {"degree", transfer.degree},
      {"channels", transfer.channels()},
      {"rows", 1},
      {"columns", transfer.bands_squared()},
      {"vertices", transfer.mesh.positions.size()},
      {"faces", transfer.mesh.faces.size()},
      {"file_vertices", transfer.mesh.remap.size()},
      {"directions", transfer.directions},
      {"instruction_set", transfer.instruction_set},
      {"holds", bounces ? "everything, the albedo too: exit radiance of channel c = sum_i T_ci L_ci"
                        : "cosine and 1/pi, not the albedo: exit radiance = albedo * sum_i T_i L_i"},
      {"convention", "real SH, orthonormal, no Condon-Shortley phase, i = l(l+1)+m, band 1 is (y,z,x)"},
      {"axes", "right-handed, z up"},
      {"units", "positions: the scene's; transfer: radiance out over radiance in, no unit"},
      {"colour_space", "albedo: linear RGB, 0..1"}};
  if (!transfer.emitted.empty()) {
    header["emitted"] = "exit radiance that is there whatever the light, to be added: linear RGB, W m^-2 sr^-1";
  }
  if (transfer.directions > 0) {
    header["sampler"] = name_of(transfer.sampler);
    header["seed"] = transfer.seed;
  }
  if (bounces) {
    header["bounces"] = to_json(transfer.bounces);
  }
  if (transfer.missing.any()) {
    header["complete"] = false;  // coarser than was asked for
    header["asked"] = nlohmann::ordered_json::object();
    if (transfer.missing.directions > 0) {
      header["asked"]["directions"] = transfer.missing.directions;
    }
    if (transfer.missing.tolerance > 0.0) {
      header["asked"]["tolerance"] = transfer.missing.tolerance;
    }
  }
  if (!transfer.storage.is_plain()) {
    header["storage"] = to_json(transfer.storage);
  }
  if (!transfer.plan.decisions.empty()) {
    header["plan"] = to_json(transfer.plan);
  }
  return header.dump(2);
}

}  // namespace sh::prt
