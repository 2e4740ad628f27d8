#include "tests/bench/city.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "numeric/output/atomic_file.hpp"
#include "prt/scene/scene.hpp"

namespace sh::bench {
namespace {

using nlohmann::json;

constexpr int kBlocks = 8;  // along a side
constexpr double kSide = 0.7;

json house(int i, double longest) {
  const double height = 0.5 + 2.0 * std::fmod(0.618034 * i, 1.0);
  const double gray = 0.3 + 0.5 * std::fmod(0.414214 * i, 1.0);
  return {{"primitive", "box"},
          {"albedo", {gray, 0.8 * gray, 0.6 * gray}},
          {"max_edge", longest},
          {"transform", {{"scale", {kSide, kSide, height}}, {"translate", {i % kBlocks, i / kBlocks, 0.5 * height}}}}};
}

// A ring that stands upright, the same mesh everywhere.
json sculpture(int i, double longest) {
  return {{"primitive", "torus"},
          {"segments", std::max(3, static_cast<int>(kSide * std::numbers::pi / longest))},
          {"transform",
           {{"scale", kSide},
            {"rotate", {{"axis", {1.0, 0.2 * (i % 5), 0.0}}, {"degrees", 90}}},
            {"translate", {i % kBlocks, i / kBlocks, 0.5}}}}};
}

// Houses and sculptures in turn, with edges of about `longest`.
json city(double longest) {
  json meshes = json::array();
  for (int i = 0; i < kBlocks * kBlocks; ++i) {
    meshes.push_back((i + i / kBlocks) % 2 == 0 ? house(i, longest) : sculpture(i, longest));
  }
  return {{"name", "city"},
          {"meshes", meshes},
          {"ground", {{"height", 0.0}, {"size", 1.5 * kBlocks}, {"max_edge", longest}, {"albedo", {0.4, 0.4, 0.4}}}},
          {"bake", {{"degree", 4}, {"directions", 512}}}};
}

// Copies of a model in rows, turned by different angles, each in a square of side 1 that holds its diagonal.
json copies(const std::string& model, const Eigen::AlignedBox3d& box, int count) {
  const double scale = 1.0 / box.diagonal().norm();
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  json meshes = json::array();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d center = scale * box.center();
    const int row = i / side;
    const Eigen::Vector3d at(i % side, row, scale * -box.min().z());
    const double angle = 137.5 * i;
    const Eigen::Vector3d turned =
        Eigen::AngleAxisd(angle * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ()) * center;
    meshes.push_back({{"file", model},
                      {"transform",
                       {{"scale", scale},
                        {"rotate", {{"axis", {0, 0, 1}}, {"degrees", angle}}},
                        {"translate", {at.x() - turned.x(), at.y() - turned.y(), at.z()}}}}});
  }
  return {{"name", "copies"},
          {"meshes", meshes},
          {"ground", {{"height", 0.0}, {"size", side + 1.0}, {"max_edge", 0.02}}},
          {"bake", {{"degree", 4}, {"directions", 512}}}};
}

prt::Mesh written(const std::string& file, const json& scene) {
  output::write_file(file, scene.dump());
  return prt::load_scene(file, prt::OnFlaw::kMend).mesh;
}

std::size_t write(const std::string& file, double longest) { return written(file, city(longest)).positions.size(); }

}  // namespace

std::size_t write_city(const std::string& file, double receivers) {
  constexpr double kEdge = 0.3;
  const auto few = static_cast<double>(write(file, kEdge));
  return write(file, kEdge * std::sqrt(few / receivers));
}

std::size_t write_copies(const std::string& file, const std::string& model, double receivers) {
  const std::string path = std::filesystem::absolute(model).string();
  const std::vector<Eigen::Vector3d> points = prt::points_of(written(file, {{"meshes", {{{"file", path}}}}}));
  const double count = std::max(1.0, std::round(receivers / static_cast<double>(points.size())));
  return written(file, copies(path, prt::bounding_box(points), static_cast<int>(count))).positions.size();
}

Cost run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stderr) != nullptr) execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) {
    throw std::runtime_error(fmt::format("{}: it failed", fmt::join(words, " ")));
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), elapsed.count(),
          1024.0 * static_cast<double>(usage.ru_maxrss)};
}

}  // namespace sh::bench
