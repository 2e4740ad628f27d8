// The parts of an emitted run time that every language has: rows without the coefficients that the lights lack, and the
// kernels that meet the light.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prt/emit/brdfs.hpp"
#include "prt/emit/emit.hpp"
#include "prt/emit/kernels.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

/// The rows as they are stored.
struct EmittedRows {
  TransferShape shape;              // with the storage of the emitted rows
  std::vector<std::uint32_t> kept;  // columns
  std::size_t channels = 1;         // stored
  Encoded encoded;

  [[nodiscard]] bool is_masked() const { return kept.size() < shape.columns(); }
};

/// Throws std::invalid_argument if the rows keep no coefficient that the lights have.
EmittedRows emitted_rows(const Transfer& transfer, const EmitOptions& options);

bool has_matrices(const Transfer& transfer);

/// The matrices of GI, as they are stored. Throws std::invalid_argument for 8 bits.
Encoded emitted_matrices(const Transfer& transfer);

/// The kernels of a run time, each under the name by which its loops call it.
class EmittedKernels {
 public:
  EmittedKernels(const Transfer& transfer, const EmitOptions& options, const EmittedRows& rows,
                 const EmittedBrdfs& brdfs, std::string language);

  struct Use {
    std::string_view macro;
    EmittedKernel kernel;
  };
  [[nodiscard]] const std::vector<Use>& all() const { return all_; }
  [[nodiscard]] const EmittedCost& cost() const { return cost_; }
  [[nodiscard]] bool has(std::string_view macro) const;

 private:
  void add_diffuse();
  void add_glossy();
  void add_operator();
  int times_a_vertex(const TransferShape& shape, std::size_t numbers);
  void use(std::string_view macro, const EmittedKernel& kernel, int times_for_the_light = 0);

  const Transfer& transfer_;
  const EmitOptions& options_;
  const EmittedRows& rows_;
  const EmittedBrdfs& brdfs_;
  std::string language_;
  int degree_;
  std::vector<Use> all_;
  EmittedCost cost_;
};

/// The comment at the head.
std::string emitted_comment(const Transfer& transfer, const EmittedRows& rows, const EmittedCost& cost);

/// x, y, z of each in turn.
std::vector<float> flat(const std::vector<Eigen::Vector3f>& values);
bool any_above_zero(const std::vector<Eigen::Vector3f>& values);

/// The text of a file of prt/emit/text or prt/shaders.
std::string_view emitted_text(std::string_view file);

}  // namespace sh::prt
