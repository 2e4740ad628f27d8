#include "prt/emit/brdfs.hpp"

#include <algorithm>

namespace sh::prt {

namespace {

// What the vertices use of a BRDF.
struct Use {
  bool is_used = false;
  bool has_albedo = false;
};

std::vector<Use> uses_of(const Mesh& mesh) {
  std::vector<Use> uses(mesh.brdfs.heads.size());
  for (std::size_t v = 0; v < mesh.brdf.size(); ++v) {
    if (mesh.brdf[v] == 0) continue;
    Use& use = uses[mesh.brdf[v] - std::size_t{1}];
    use.is_used = true;
    use.has_albedo = use.has_albedo || !mesh.albedo[v].isZero(0.0F);
  }
  return uses;
}

// The first part that is not black, and the end of these parts.
std::pair<std::size_t, std::size_t> parts_of(const Reflectances::Head& head, const Use& use) {
  return head.is_measured ? std::pair<std::size_t, std::size_t>{0, 3}
                          : std::pair<std::size_t, std::size_t>{!use.has_albedo, 2};
}

void append(const float* table, std::size_t part, int degree, std::vector<float>& tables) {
  for (std::size_t view = 0; view < kViews; ++view) {
    const float* row = table + (view * kReflectionParts + part) * even_count(kMaxDegree);
    tables.insert(tables.end(), row, row + even_count(degree));
  }
}

}  // namespace

std::vector<Eigen::Vector3f> EmittedBrdfs::of_lobes(std::vector<Eigen::Vector3f> colors) const {
  for (std::size_t v = 0; v < std::min(colors.size(), numbers.size()); ++v) {
    if (numbers[v] > 0) colors[v].setZero();
  }
  return colors;
}

std::vector<Eigen::Vector3f> EmittedBrdfs::of_bases(std::vector<Eigen::Vector3f> albedo) const {
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] % 4U != 2U) albedo[v].setZero();
  }
  return albedo;
}

EmittedBrdfs emitted_brdfs(const Transfer& transfer) {
  EmittedBrdfs brdfs;
  const Mesh& mesh = transfer.mesh;
  const std::vector<Use> uses = uses_of(mesh);
  std::vector<std::uint16_t> numbers(uses.size(), 0);
  std::size_t parts = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (!uses[i].is_used) continue;
    const auto [first, end] = parts_of(mesh.brdfs.heads[i], uses[i]);
    numbers[i] = static_cast<std::uint16_t>(4 * parts + (end - first));
    for (std::size_t part = first; part < end; ++part, ++parts) {
      append(mesh.brdfs.table(i).rows, part, transfer.degree(), brdfs.tables);
    }
  }
  if (parts == 0) return brdfs;
  for (const std::uint16_t brdf : mesh.brdf) brdfs.numbers.push_back(brdf == 0 ? 0 : numbers[brdf - std::size_t{1}]);
  brdfs.serve_all = std::count(brdfs.numbers.begin(), brdfs.numbers.end(), 0) == 0;
  return brdfs;
}

}  // namespace sh::prt
