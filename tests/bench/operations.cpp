// Operations of the kernels, from generated/MANIFEST, against the best that is published or was tried before.
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

struct Row {
  const char* family;
  int first_degree;
  std::array<int, 8> limits;  // by degree; 0 ends the row
};

// product: pairs, separable quadrature; rotate: z-x90-z by parity classes. The basis spends some operations on less error,
// in the same time: basis_targets.cpp times it.
constexpr std::array<Row, 2> kRows{
    {{"product", 2, {148, 534, 1333, 2271, 3798}}, {"rotate", 2, {82, 180, 318, 502, 744}}}};

// "basis_l4" -> the kernel that is written for speed.
std::map<std::string, Counts> read_manifest() {
  std::ifstream manifest(std::string(SHFORGE_SOURCE_DIR) + "/generated/MANIFEST");
  if (!manifest) throw std::runtime_error("generated/MANIFEST: cannot be read; `shgen write` writes it");
  std::map<std::string, Counts> kernels;
  for (std::string line; std::getline(manifest, line);) {
    std::istringstream words(line);
    std::string kernel;
    words >> kernel;
    Counts counts;
    bool written = false;
    for (std::string word; words >> word;) {
      const std::string field = word.substr(0, word.find('='));
      if (field == "mul") counts.mul = std::stoi(word.substr(4));
      if (field == "add") counts.add = std::stoi(word.substr(4));
      written = written || word == "files=cpp/" + kernel + ".hpp";
    }
    if (written) kernels[kernel] = counts;
  }
  return kernels;
}

}  // namespace

Counts manifest_counts(const std::string& kernel) {
  static const std::map<std::string, Counts> kKernels = read_manifest();
  const auto found = kKernels.find(kernel);
  if (found == kKernels.end()) throw std::runtime_error("generated/MANIFEST: no kernel " + kernel);
  return found->second;
}

void operations(Table& table) {
  table.section("Operations (multiplications and additions)");
  for (const Row& row : kRows) {
    for (std::size_t i = 0; i < row.limits.size() && row.limits[i] > 0; ++i) {
      const std::string kernel =
          std::string(row.family) + "_l" + std::to_string(row.first_degree + static_cast<int>(i));
      const Counts counts = manifest_counts(kernel);  // square roots, divisions and selections are counted apart
      table.figure(kernel, std::to_string(counts.mul) + " mul, " + std::to_string(counts.add) + " add",
                   counts.mul + counts.add, row.limits[i]);
    }
  }
}

}  // namespace sh::bench
