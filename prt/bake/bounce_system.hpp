// The system x = b + A x, A = albedo * K, and the operations that both solvers of bounces.hpp need.
#pragma once

#include <algorithm>
#include <vector>

#include "prt/bake/bounces.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

class BounceSystem {
 public:
  /// All arguments must outlive this object.
  BounceSystem(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, const BounceLayout& layout,
               const BounceOptions& options, BounceCheckpoint* checkpoint = nullptr)
      : factors_(factors), albedo_(albedo), layout_(layout), options_(options), checkpoint_(checkpoint) {}

  /// x = A x, by way of `room`.
  void advance(Panel& x, OwnRows& room);
  /// r = b - (I - A) x in the rows of this process, by way of `room`.
  void residual(const OwnRows& b, const OwnRows& x, Panel& r, OwnRows& room);
  /// Fills in bound, residual, largest and spectral_bound of the report for an iterate and its residual, of whose rows each
  /// process needs its own. R: Panel or OwnRows.
  template <class R>
  void certify(const OwnRows& x, const R& r);
  /// Keeps a state from which the solver can go on, if it is time; `before`: of the series. R: Panel or OwnRows.
  template <class R>
  void keep(BounceState::Phase phase, double before, const OwnRows& x, const R& r) const {
    if (checkpoint_ == nullptr) return;
    checkpoint_->keep({phase, static_cast<std::uint32_t>(report.applications), before}, x, r);
  }
  /// True while applications and time are left.
  [[nodiscard]] bool may_go_on() const;
  /// True if the certified bound is within the tolerance.
  [[nodiscard]] bool is_solved() const;

  [[nodiscard]] const Ranks& ranks() const { return factors_.ranks(); }

  BounceReport report;  // of the last certify()

 private:
  void scale(Panel& y);

  const FormFactors& factors_;
  const std::vector<Eigen::Vector3f>& albedo_;
  const BounceLayout& layout_;
  const BounceOptions& options_;
  BounceCheckpoint* checkpoint_;
};

/// Rows that one task handles; the same for any number of threads.
inline constexpr std::size_t kRowsAPart = 256;

/// Calls each(first, last) for the parts of 0..rows on all threads of the arena.
template <class Each>
void for_rows(std::size_t rows, const Each& each) {
  in_parallel(std::size_t{0}, (rows + kRowsAPart - 1) / kRowsAPart,
              [&](std::size_t part) { each(part * kRowsAPart, std::min(rows, (part + 1) * kRowsAPart)); });
}

/// Calls each(first, last) for rows of this process, on all threads of the arena.
template <class Each>
void for_own_rows(const Ranks& ranks, std::size_t rows, const Each& each) {
  static_assert(Ranks::kRowsAtOnce % kRowsAPart == 0);
  for_rows(rows, [&](std::size_t first, std::size_t last) {
    if (ranks.owns(first)) each(first, last);
  });
}

/// Improves x, whose residual is r, until the certified bound is small enough or the limit on applications is reached; r is
/// of no use then.
void solve_krylov(BounceSystem& system, const OwnRows& b, OwnRows& x, Panel& r);

}  // namespace sh::prt
