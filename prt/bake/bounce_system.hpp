// The operator A = albedo * K and the operations that both solvers of bounces.hpp need.
#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>

#include "prt/bake/bounces.hpp"

namespace sh::prt {

class BounceSystem {
 public:
  BounceSystem(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, BounceLayout layout)
      : factors_(factors), albedo_(albedo), layout_(layout) {}

  /// y = A x.
  void apply(const Panel& x, Panel& y);
  /// r = b - (I - A) x.
  void residual(const Panel& b, const Panel& x, Panel& r);
  /// Fills in bound, residual, largest and spectral_bound for an iterate and its residual.
  void certify(const Panel& x, const Panel& r, BounceReport& report) const;

  [[nodiscard]] const BounceLayout& layout() const { return layout_; }
  [[nodiscard]] int applications() const { return applications_; }

 private:
  const FormFactors& factors_;
  const std::vector<Eigen::Vector3f>& albedo_;
  BounceLayout layout_;
  int applications_ = 0;
};

/// Rows that one task handles; the same for any number of threads.
inline constexpr std::size_t kRowsAPart = 256;

/// Calls each(first, last) for the parts of 0..rows on all threads of the arena.
template <class Each>
void for_rows(std::size_t rows, const Each& each) {
  tbb::parallel_for(std::size_t{0}, (rows + kRowsAPart - 1) / kRowsAPart,
                    [&](std::size_t part) { each(part * kRowsAPart, std::min(rows, (part + 1) * kRowsAPart)); });
}

/// Improves x, whose residual is r, until the bound in `report` is small enough or the limit on applications is
/// reached.
void solve_krylov(BounceSystem& system, const Panel& b, Panel& x, Panel& r, const BounceOptions& options,
                  BounceReport& report);

/// True while applications and time are left.
bool may_go_on(const BounceSystem& system, const BounceOptions& options);

/// True if the certified bound is within the tolerance.
bool is_solved(const BounceReport& report, const BounceOptions& options);

}  // namespace sh::prt
