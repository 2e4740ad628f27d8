// `prt info FILE`: prints the header and counts of a transfer file as JSON.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/commands/commands.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

/// The header of the file, and values from its body.
Json report(const std::string& file, const Transfer& transfer) {
  Json json = Json::parse(transfer_header(transfer));
  Eigen::Vector3f low = transfer.mesh.positions.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& p : transfer.mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  double mean = 0.0;
  const std::size_t vectors = transfer.coefficients.size() / transfer.shape.count();
  for (std::size_t i = 0; i < transfer.coefficients.size(); i += transfer.shape.count()) {
    mean += static_cast<double>(transfer.coefficients[i]) / static_cast<double>(vectors);
  }
  json["file"] = std::filesystem::path(file).filename().string();
  json["bytes"] = std::filesystem::file_size(file);
  json["bounding_box"] = {to_json(low), to_json(high)};
  json["mean_of_first_coefficient"] = mean;
  return json;
}

void run(const std::string& file) {
  const Transfer transfer = read_transfer(file);
  print_out(report(file, transfer).dump(2) + "\n");
}

}  // namespace

void add_info_command(CLI::App& tool) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = tool.add_subcommand("info", "print the header and counts of a transfer file as JSON");
  command->add_option("FILE", *file, "transfer file from `prt bake`")->required();
  command->callback([file] { run(*file); });
}

}  // namespace sh::prt
