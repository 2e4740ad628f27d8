#include "prt/transfer/transfer_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "numeric/output/printable.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/whole_number.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBadStorage = "transfer file whose JSON header names a storage that does not exist";

template <class Whole>
Whole whole_from(const nlohmann::json& json, Whole least = 0, Whole most = std::numeric_limits<Whole>::max()) {
  return whole_number<Whole>(json, "transfer file whose JSON header has", least, most);
}

// A bound or a residual.
double amount_from(const nlohmann::json& json) {
  const auto amount = json.get<double>();
  if (!(amount >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("transfer file whose JSON header has {}, expected a number of 0 or more", json.dump()));
  }
  return amount;
}

Decision decision_from(const nlohmann::json& json) {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();  // a decision may cost rays
  return {json.at("name").get<std::string>(),
          json.at("choice").get<std::string>(),
          json.at("why").get<std::string>(),
          whole_from<std::int64_t>(json.at("bytes_saved"), kLeast),
          whole_from<std::int64_t>(json.at("rays_saved"), kLeast),
          amount_from(json.at("error")),
          json.at("basis").get<std::string>()};
}

Json to_json(const Decision& decision) {
  return {{"name", decision.name},
          {"choice", decision.choice},
          {"why", decision.why},
          {"bytes_saved", decision.bytes_saved},
          {"rays_saved", decision.rays_saved},
          {"error", decision.error},
          {"basis", decision.basis}};
}

// Bounds are null if nothing is certified.
Json bound_or_null(const BounceReport& report, double bound) { return report.certified ? Json(bound) : Json(); }

double bound_from(const BounceReport& report, const nlohmann::json& json) {
  return report.certified ? amount_from(json) : std::numeric_limits<double>::infinity();
}

Json to_json(const BounceReport& report) {
  Json json = {{"solver", report.solver},
               {"applications", report.applications},
               {"certified", report.certified},
               {"bound", bound_or_null(report, report.bound)},
               {"residual", report.residual},
               {"largest", report.largest},
               {"spectral_bound", report.spectral_bound}};
  if (report.directions > 0) json["directions"] = report.directions;
  if (report.between_vertices > 0.0) json["between_vertices"] = report.between_vertices;
  if (report.emitted_largest > 0.0) {
    json["emitted_bound"] = bound_or_null(report, report.emitted_bound);
    json["emitted_largest"] = report.emitted_largest;
  }
  return json;
}

BounceReport bounces_from(const nlohmann::json& json) {
  BounceReport report;
  report.solver = json.at("solver").get<std::string>();
  report.applications = whole_from<int>(json.at("applications"));
  report.certified = json.at("certified").get<bool>();
  report.residual = amount_from(json.at("residual"));
  report.largest = amount_from(json.at("largest"));
  report.spectral_bound = amount_from(json.at("spectral_bound"));
  report.bound = bound_from(report, json.at("bound"));
  if (json.contains("emitted_largest")) report.emitted_largest = amount_from(json.at("emitted_largest"));
  if (json.contains("directions")) report.directions = whole_from<std::uint32_t>(json.at("directions"));
  if (json.contains("between_vertices")) report.between_vertices = amount_from(json.at("between_vertices"));
  if (json.contains("emitted_bound")) report.emitted_bound = bound_from(report, json.at("emitted_bound"));
  return report;
}

template <class Enumeration, std::size_t Count>
Enumeration value_from(const nlohmann::json& json, const std::array<std::string_view, Count>& words, const char* what) {
  const auto word = json.get<std::string>();
  const auto value = value_called<Enumeration>(word, words);
  if (!value)
    throw std::invalid_argument(
        fmt::format("{} {}, expected one of {}", what, output::printable(word), fmt::join(words, ", ")));
  return *value;
}

// The counts of clusters, if the header has any.
void take_clusters(const nlohmann::json& json, Storage& storage) {
  if (!json.contains("clusters")) return;
  storage.clusters = whole_from<std::uint32_t>(json["clusters"], 1, kMostClusters);
  storage.vectors = whole_from<std::uint32_t>(json.at("vectors"), 0, kMostVectors);
}

void put_clusters(const Storage& storage, Json& json) {
  if (!storage.is_clustered()) return;
  json["clusters"] = storage.clusters;
  json["vectors"] = storage.vectors;
}

void put_shape(const TransferShape& shape, Json& header) {
  header["degree"] = shape.degree;
  header["result_degree"] = shape.result_degree;
  header["meets"] = word_of(shape.meets, kMeetsNames);
  header["channels"] = shape.channels;
  header["rows"] = shape.rows();
  header["columns"] = shape.columns();
  header["holds_cosine"] = shape.holds_cosine;
  header["holds_albedo"] = shape.holds_albedo;
}

// A header of version 1 gives only channels (default: one) and rows; the kind implies the rest.
TransferShape shape_from(const nlohmann::json& header, std::uint32_t version, const TransferKind& kind) {
  const int highest = kind.highest_degree;
  if (header.at("degree").is_number() && !(header["degree"] >= 0 && header["degree"] <= highest)) {
    throw std::invalid_argument(
        fmt::format("transfer of degree {}, expected 0 to {}", header["degree"].dump(), highest));
  }
  const auto degree = whole_from<int>(header["degree"], 0, highest);
  TransferShape shape = kind.shape(degree);
  TransferShape expected = shape;
  if (version == 1) {
    shape.channels = header.contains("channels") ? whole_from<std::size_t>(header["channels"]) : 1;
  } else {
    shape.channels = whole_from<std::size_t>(header.at("channels"));
    shape.result_degree = whole_from<int>(header.at("result_degree"), 0, kMaxDegree);
    shape.meets = value_from<Meets>(header.at("meets"), kMeetsNames, "transfer that meets the light by");
    shape.holds_cosine = header.at("holds_cosine").get<bool>();
    shape.holds_albedo = header.at("holds_albedo").get<bool>();
    if (kind.any_result && shape.result_degree <= highest) expected.result_degree = shape.result_degree;
  }
  const auto rows = whole_from<std::uint64_t>(header.at("rows"));
  const auto columns = version == 1 ? expected.columns() : whole_from<std::uint64_t>(header.at("columns"));
  if (!is_alike(shape, expected) || rows != expected.rows() || columns != expected.columns()) {
    throw std::invalid_argument(fmt::format(
        "transfer of kind {} and degree {} with {} channels of {} x {} numbers, expected {} of {} x {}", kind.letters,
        degree, shape.channels, rows, columns, expected.channels, expected.rows(), expected.columns()));
  }
  if (header.contains("storage")) shape.storage = storage_from(header.at("storage"), shape.columns());
  return shape;
}

// Rows and columns tell the degrees of the matrices.
void put_indirect(const TransferShape& shape, Json& header) {
  header["indirect"] = {{"channels", shape.channels},
                        {"rows", shape.rows()},
                        {"columns", shape.columns()},
                        {"element", word_of(shape.storage.element, kElementNames)}};
  put_clusters(shape.storage, header["indirect"]);
}

// The degree, `highest` at most, that so many coefficients have; -1 if there is none.
int degree_of(const nlohmann::json& count, int highest) {
  int degree = highest;
  while (degree >= 0 && count != coefficient_count(degree)) --degree;
  return degree;
}

TransferShape indirect_from(const nlohmann::json& json, const TransferKind& kind, const TransferShape& numbers) {
  const int degree = numbers.degree;
  TransferShape shape = kind.indirect(degree);
  shape.channels = whole_from<std::size_t>(json.at("channels"), 1, 3);
  shape.result_degree = degree_of(json.at("rows"), numbers.result_degree);
  shape.degree = degree_of(json.at("columns"), degree);
  const std::string_view element = word_of(shape.storage.element, kElementNames);
  if (shape.channels == 2 || shape.result_degree < 0 || shape.degree < 0 || json.at("element") != element) {
    throw std::invalid_argument(
        fmt::format("transfer file with indirect matrices of {} x {} x {} {}, expected 1 or 3 x squares of 1 to {} {}",
                    json.at("channels").dump(), json.at("rows").dump(), json.at("columns").dump(),
                    json.at("element").dump(), degree + 1, element));
  }
  take_clusters(json, shape.storage);
  return shape;
}

Json to_json(const Frame& frame) {
  return {{"origin", {frame.origin.x(), frame.origin.y(), frame.origin.z()}}, {"unit", frame.unit}};
}

Frame frame_from(const nlohmann::json& json) {
  const auto origin = json.at("origin").get<std::array<double, 3>>();
  Frame frame{Eigen::Vector3d(origin.data()), json.at("unit").get<double>()};
  constexpr double kFarthest = 1e100;
  if (!(frame.origin.cwiseAbs().maxCoeff() <= kFarthest) ||
      !(frame.unit >= 0.5 * kLeastExtent && frame.unit <= 2.0 * kLargestExtent)) {
    throw std::invalid_argument("transfer file whose frame has an origin or a unit that is no length");
  }
  return frame;
}

Json to_json(const Eigen::AlignedBox3d& box) {
  const auto corner = [](const Eigen::Vector3d& p) { return Json{p.x(), p.y(), p.z()}; };
  return {corner(box.min()), corner(box.max())};
}

Json to_json(const PointGrid& grid) {
  return {{"box", to_json(grid.box)}, {"counts", grid.counts}, {"filled", grid.filled}};
}

PointGrid grid_from(const nlohmann::json& json) {
  const auto box = json.at("box").get<std::array<std::array<double, 3>, 2>>();
  PointGrid grid;
  grid.box = {Eigen::Vector3d(box[0].data()), Eigen::Vector3d(box[1].data())};
  const nlohmann::json& counts = json.at("counts");
  if (json["box"].size() != 2 || json["box"][0].size() != 3 || json["box"][1].size() != 3 || counts.size() != 3) {
    throw std::invalid_argument("transfer file whose grid has more than three axes");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) grid.counts.at(axis) = whole_from<std::uint32_t>(counts.at(axis));
  grid.filled = whole_from<std::size_t>(json.at("filled"));
  if (std::string flaw = flaw_of(grid); !flaw.empty()) throw std::invalid_argument("transfer file: " + flaw);
  return grid;
}

Json to_json(const Transfer& transfer, const MediumRecord& medium) {
  return {{"albedo", medium.albedo},
          {"anisotropy", medium.anisotropy},
          {"directions", medium.directions},
          {"density", "extinction, 1 / unit of positions"},
          {"scattering", to_json(transfer.bounces)}};
}

void take_medium(const nlohmann::json& json, Transfer& transfer) {
  MediumRecord& medium = transfer.medium;
  medium.albedo = json.at("albedo").get<std::array<float, 3>>();
  medium.anisotropy = json.at("anisotropy").get<double>();
  medium.directions = whole_from<std::uint32_t>(json.at("directions"));
  const bool is_albedo = std::all_of(medium.albedo.begin(), medium.albedo.end(),
                                     [](float value) { return value >= 0.0F && value <= 1.0F; });
  if (!is_albedo || json["albedo"].size() != 3 || !(std::abs(medium.anisotropy) < 1.0)) {
    throw std::invalid_argument(
        "transfer file of a medium whose albedo is not from 0 to 1, or anisotropy not within 1");
  }
  transfer.bounces = bounces_from(json.at("scattering"));
}

std::string_view holds(const Transfer& transfer) {
  const TransferShape& shape = transfer.shape;
  const bool on_grid = transfer.kind->on_grid;
  if (transfer.kind->in_medium) {
    return shape.rows() == 1
               ? "what scatters at the point, the albedo too: radiance of channel c = sum_i T_ci L_ci"
               : "what scatters at the point, the albedo too: coefficient r, by the direction in which the "
                 "point is seen, of the radiance of channel c = sum_i T_cri L_ci";
  }
  if (on_grid && shape.meets == Meets::kOperator) {
    return transfer.kind->stores_matrices()
               ? "visibility V, 1 where the object blocks nothing: V times the light, on the bands of the result, and "
                 "the matrix times the light, what the object reflects, reach the point"
               : "visibility V, 1 where the object blocks nothing: V times the light, on the bands of the result, "
                 "reaches the point";
  }
  if (transfer.kind->is_length) {
    return "thickness: sum_i T_i Y_i(s) is the distance through the body from the vertex in direction s, into the body";
  }
  if (shape.meets == Meets::kNothing) return "nothing: the light itself reaches every vertex";
  if (shape.meets == Meets::kOperator) {
    return "visibility V, 1 towards the sky: V times the light, on the bands of the light, reaches the vertex";
  }
  return shape.holds_albedo ? "everything, the albedo too: exit radiance of channel c = sum_i T_ci L_ci"
                            : "cosine and 1/pi, not the albedo: exit radiance = albedo * sum_i T_i L_i";
}

Json to_json(const std::vector<Reflectances::Head>& heads) {
  Json json = Json::array();
  for (const Reflectances::Head& head : heads) json.push_back({{"name", head.name}, {"measured", head.is_measured}});
  return json;
}

std::vector<Reflectances::Head> heads_from(const nlohmann::json& json) {
  std::vector<Reflectances::Head> heads;
  for (const nlohmann::json& head : json) {
    heads.push_back({head.at("name").get<std::string>(), head.at("measured").get<bool>()});
  }
  return heads;
}

Json to_json(const std::vector<NormalMaps::Head>& heads) {
  Json json = Json::array();
  for (const NormalMaps::Head& head : heads) {
    json.push_back({{"name", head.name}, {"width", head.width}, {"height", head.height}});
  }
  return json;
}

// No map has more than kMostTexels, so that no sum of their texels overflows.
std::vector<NormalMaps::Head> map_heads_from(const nlohmann::json& json) {
  constexpr int kLongest = static_cast<int>(NormalMaps::kMostTexels);
  std::vector<NormalMaps::Head> heads;
  for (const nlohmann::json& head : json) {
    const auto width = whole_from<int>(head.at("width"), 1, kLongest);
    const auto height = whole_from<int>(head.at("height"), 1, kLongest / width);
    heads.push_back({head.at("name").get<std::string>(), width, height});
  }
  return heads;
}

Json to_json(const std::vector<Pictures::Head>& heads) {
  Json json = Json::array();
  for (const Pictures::Head& head : heads) json.push_back({{"name", head.name}, {"bytes", head.bytes}});
  return json;
}

// No picture has more than 1 TiB, so that no sum of their bytes overflows.
std::vector<Pictures::Head> picture_heads_from(const nlohmann::json& json) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 40U;
  std::vector<Pictures::Head> heads;
  for (const nlohmann::json& head : json) {
    heads.push_back({head.at("name").get<std::string>(), whole_from<std::size_t>(head.at("bytes"), 0, kMostBytes)});
  }
  return heads;
}

Json to_json(const std::vector<Atlases::Head>& heads) {
  Json json = Json::array();
  for (const Atlases::Head& head : heads) {
    json.push_back({{"width", head.width}, {"height", head.height}, {"first", head.first}, {"texels", head.count}});
  }
  return json;
}

std::vector<Atlases::Head> atlas_heads_from(const nlohmann::json& json) {
  std::vector<Atlases::Head> heads;
  for (const nlohmann::json& head : json) {
    heads.push_back({whole_from<int>(head.at("width"), 1, kMostTexelsAlong),
                     whole_from<int>(head.at("height"), 1, kMostTexelsAlong),
                     whole_from<std::uint32_t>(head.at("first")), whole_from<std::uint32_t>(head.at("texels"))});
  }
  return heads;
}

Json to_json(const std::vector<MeshNode>& nodes) {
  Json json = Json::array();
  for (const MeshNode& node : nodes) {
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) rows.push_back(node.to_world(row, column));
    }
    json.push_back({{"name", node.name}, {"material", node.material}, {"to_world", rows}, {"faces", node.faces}});
  }
  return json;
}

// The runs of a node rise and do not overlap.
std::vector<MeshNode> nodes_from(const nlohmann::json& json, std::uint64_t faces) {
  std::vector<MeshNode> nodes;
  for (const nlohmann::json& entry : json) {
    MeshNode& node = nodes.emplace_back();
    node.name = entry.at("name").get<std::string>();
    node.material = entry.at("material").get<std::string>();
    const auto rows = entry.at("to_world").get<std::vector<double>>();
    if (rows.size() != 12)
      throw std::invalid_argument("transfer file with a node whose `to_world` is not 3 x 4 numbers");
    node.to_world.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(rows.data());
    std::uint64_t end = 0;
    for (const nlohmann::json& run : entry.at("faces")) {
      const auto first = whole_from<std::uint32_t>(run.at(0));
      const auto count = whole_from<std::uint32_t>(run.at(1), 1);
      if (run.size() != 2 || first < end || std::uint64_t{first} + count > faces) {
        throw std::invalid_argument("transfer file with a node whose runs of faces do not rise, or name missing faces");
      }
      node.faces.push_back({first, count});
      end = std::uint64_t{first} + count;
    }
  }
  return nodes;
}

void put_shortfall(const Shortfall& missing, Json& header) {
  if (!missing.any()) return;
  header["complete"] = false;  // coarser than was asked for
  header["asked"] = Json::object();
  if (missing.directions > 0) header["asked"]["directions"] = missing.directions;
  if (missing.tolerance > 0.0) header["asked"]["tolerance"] = missing.tolerance;
}

}  // namespace

Json to_json(const Storage& storage) {
  Json json = {{"element", word_of(storage.element, kElementNames)},
               {"one_channel", storage.one_channel},
               {"kept", storage.kept}};
  put_clusters(storage, json);
  return json;
}

Json to_json(const KeptBands& kept, const TransferKind& kind) {
  Json json = {{"visibility", kept.visibility}};
  if (!kind.stores_matrices()) return json;
  json["result"] = kept.result;
  json["light"] = kept.light;
  return json;
}

PlanRecord plan_record_from(const nlohmann::json& json) {
  PlanRecord plan{
      amount_from(json.at("budget")), amount_from(json.at("error")), json.at("light_turns").get<std::string>(), {}};
  for (const nlohmann::json& decision : json.at("decisions")) plan.decisions.push_back(decision_from(decision));
  return plan;
}

Storage storage_from(const nlohmann::json& json, std::size_t columns) {
  const auto element = value_called<Element>(json.at("element").get<std::string>(), kElementNames);
  Storage storage;
  storage.one_channel = json.at("one_channel").get<bool>();
  for (const nlohmann::json& column : json.at("kept")) storage.kept.push_back(whole_from<std::uint32_t>(column));
  const bool rises = std::is_sorted(storage.kept.begin(), storage.kept.end(), std::less_equal<>());
  if (!element || !rises || columns == 0 || (!storage.kept.empty() && storage.kept.back() >= columns)) {
    throw std::invalid_argument(kBadStorage);
  }
  storage.element = *element;
  take_clusters(json, storage);
  return storage;
}

Json to_json(const PlanRecord& plan) {
  Json decisions = Json::array();
  for (const Decision& decision : plan.decisions) decisions.push_back(to_json(decision));
  return {{"budget", plan.budget}, {"error", plan.error}, {"light_turns", plan.light_turns}, {"decisions", decisions}};
}

std::string transfer_header(const Transfer& transfer) {
  Json header = {{"format", "shforge transfer"}, {"scene", transfer.scene}, {"kind", transfer.kind->letters}};
  put_shape(transfer.shape, header);
  if (transfer.grid) {
    header["grid"] = to_json(*transfer.grid);
  } else {
    header.update({{"vertices", transfer.mesh.positions.size()},
                   {"faces", transfer.mesh.faces.size()},
                   {"file_vertices", transfer.mesh.remap.size()}});
    if (!transfer.mesh.positions.empty()) {
      const Eigen::AlignedBox3f box = bounding_box(transfer.mesh.positions);
      const Frame& frame = transfer.mesh.frame;
      header["bounding_box"] = to_json(Eigen::AlignedBox3d(frame.world(box.min()), frame.world(box.max())));
    }
  }
  header.update({{"directions", transfer.directions},
                 {"instruction_set", transfer.instruction_set},
                 {"holds", holds(transfer)},
                 {"convention", "real SH, orthonormal, no Condon-Shortley phase, i = l(l+1)+m, band 1 is (y,z,x)"},
                 {"axes", "right-handed, z up"},
                 {"units", transfer.kind->is_length ? "positions and thickness: the scene's"
                           : transfer.shape.holds_cosine
                               ? "positions: the scene's; transfer: radiance out over radiance in, no unit"
                               : "positions: the scene's; transfer: visibility, no unit"},
                 {"colour_space", "albedo: linear RGB, 0..1"}});
  if (transfer.grid) header.erase("colour_space");  // of albedos
  if (!transfer.mesh.frame.is_world()) header["frame"] = to_json(transfer.mesh.frame);
  if (!transfer.emitted.empty()) {
    header["emitted"] = "exit radiance that is there whatever the light, to be added: linear RGB, W m^-2 sr^-1";
  }
  if (transfer.directions > 0) {
    header["sampler"] = name_of(transfer.sampler);
    header["seed"] = transfer.seed;
  }
  if (transfer.kind->in_medium) header["medium"] = to_json(transfer, transfer.medium);
  if (transfer.kind->has_bounces()) header["bounces"] = to_json(transfer.bounces);
  if (transfer.kind->indirect != nullptr) put_indirect(transfer.indirect_shape, header);
  if (!transfer.indirect_clusters.empty()) header["indirect"]["error"] = transfer.indirect_clusters.error;
  put_shortfall(transfer.missing, header);
  if (!transfer.shape.storage.is_plain()) header["storage"] = to_json(transfer.shape.storage);
  if (!transfer.clusters.empty()) header["storage"]["error"] = transfer.clusters.error;
  if (!transfer.mesh.brdfs.heads.empty()) header["brdfs"] = to_json(transfer.mesh.brdfs.heads);
  if (!transfer.mesh.normal_maps.heads.empty()) header["normal_maps"] = to_json(transfer.mesh.normal_maps.heads);
  if (!transfer.mesh.albedo_maps.heads.empty()) header["albedo_maps"] = to_json(transfer.mesh.albedo_maps.heads);
  if (!transfer.mesh.atlases.heads.empty()) header["atlases"] = to_json(transfer.mesh.atlases.heads);
  if (!transfer.grid && !transfer.mesh.nodes.empty()) header["nodes"] = to_json(transfer.mesh.nodes);
  if (!transfer.plan.decisions.empty()) header["plan"] = to_json(transfer.plan);
  return header.dump(2, ' ', false, Json::error_handler_t::replace);  // names of files may be no UTF-8
}

void take_header(const nlohmann::json& header, std::uint32_t version, TransferKinds kinds, Transfer& transfer) {
  transfer.scene = header.at("scene").get<std::string>();
  const auto letters = header.at("kind").get<std::string>();
  transfer.kind = find_kind(&TransferKind::letters, letters, kinds);
  if (transfer.kind == nullptr) {
    throw std::invalid_argument(fmt::format("transfer of kind {}, expected one of {}", output::printable(letters),
                                            fmt::join(kind_names(&TransferKind::letters, kinds), ", ")));
  }
  transfer.shape = shape_from(header, version, *transfer.kind);
  if (transfer.kind->on_grid) transfer.grid = grid_from(header.at("grid"));
  if (header.contains("frame")) transfer.mesh.frame = frame_from(header.at("frame"));
  if (transfer.kind->in_medium) take_medium(header.at("medium"), transfer);
  if (transfer.kind->has_bounces()) transfer.bounces = bounces_from(header.at("bounces"));
  if (transfer.kind->indirect != nullptr) {
    transfer.indirect_shape = indirect_from(header.at("indirect"), *transfer.kind, transfer.shape);
  }
  if (transfer.shape.storage.is_clustered()) transfer.clusters.error = amount_from(header["storage"].at("error"));
  if (transfer.indirect_shape.storage.is_clustered()) {
    transfer.indirect_clusters.error = amount_from(header["indirect"].at("error"));
  }
  if (header.contains("brdfs")) transfer.mesh.brdfs.heads = heads_from(header.at("brdfs"));
  if (header.contains("normal_maps")) transfer.mesh.normal_maps.heads = map_heads_from(header.at("normal_maps"));
  if (header.contains("albedo_maps")) transfer.mesh.albedo_maps.heads = picture_heads_from(header.at("albedo_maps"));
  if (header.contains("atlases")) transfer.mesh.atlases.heads = atlas_heads_from(header.at("atlases"));
  if (header.contains("nodes")) {
    transfer.mesh.nodes = nodes_from(header.at("nodes"), whole_from<std::uint64_t>(header.at("faces")));
  }
  if (header.contains("plan")) transfer.plan = plan_record_from(header.at("plan"));
  transfer.directions = whole_from<std::uint32_t>(header.at("directions"));
  if (header.contains("sampler")) {  // absent where no ray was traced, and in files older than the choice
    transfer.sampler = value_from<Sampler>(header["sampler"], kSamplerNames, "sampler");
  }
  if (header.contains("seed")) transfer.seed = whole_from<std::uint32_t>(header["seed"]);
  if (header.contains("asked")) {
    const nlohmann::json& asked = header["asked"];
    if (asked.contains("directions")) transfer.missing.directions = whole_from<std::uint32_t>(asked["directions"]);
    if (asked.contains("tolerance")) transfer.missing.tolerance = amount_from(asked["tolerance"]);
  }
  transfer.instruction_set = header.at("instruction_set").get<std::string>();
}

}  // namespace sh::prt
