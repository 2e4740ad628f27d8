#include "prt/bake/form_factors.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"
#include "prt/rays/widest.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kVerticesPerTask = 32;

constexpr std::size_t kLanes = sizeof(DoubleLanes) / sizeof(double);

// sum (4 Count) = the weighted sum of the rows of x, kept in registers.
template <std::size_t Count>
[[gnu::always_inline]] inline void sum_block(const FormFactorRow& row, const double* x, std::size_t columns,
                                             double* sum) {
  DoubleLanes block[Count] = {};
  for (const FormFactor& factor : row) {
    const double weight = factor.weight;
    const auto* from = reinterpret_cast<const DoubleLanesAnywhere*>(x + factor.vertex * columns);
    for (std::size_t i = 0; i < Count; ++i) block[i] += weight * from[i].lanes;
  }
  auto* to = reinterpret_cast<DoubleLanesAnywhere*>(sum);
  for (std::size_t i = 0; i < Count; ++i) to[i].lanes = block[i];
}

SHFORGE_WIDEST void sum_row(const FormFactorRow& row, const double* x, std::size_t columns, double* sum) {
  constexpr std::size_t kWide = 10;
  std::size_t first = 0;
  for (; first + kWide * kLanes <= columns; first += kWide * kLanes) {
    sum_block<kWide>(row, x + first, columns, sum + first);
  }
  for (; first < columns; first += Panel::kUnit) sum_block<Panel::kUnit / kLanes>(row, x + first, columns, sum + first);
}

}  // namespace

FormFactors::FormFactors(std::size_t vertices, std::size_t most_bytes, std::function<RowMaker()> make_maker)
    : rows_(vertices), kept_(vertices, 0), most_bytes_(most_bytes), make_maker_(std::move(make_maker)) {}

void FormFactors::keep(std::size_t vertex, FormFactorRow row) {
  if (!ranks_.owns(vertex)) return;
  const std::size_t bytes = row.size() * sizeof(FormFactor);
  const std::atomic_ref<std::size_t> spent(bytes_);
  if (make_maker_ && spent.fetch_add(bytes) + bytes > most_bytes_) {
    spent.fetch_sub(bytes);
    return;
  }
  row.shrink_to_fit();
  rows_[vertex] = std::move(row);
  kept_[vertex] = 1;
}

// A row has at most size() entries with the sum 1 at most. Filling multiplies by its condition.
double FormFactors::rounding() const {
  return 0x1p-53 * static_cast<double>(rows_.size() + 1) * (1.0 + fill_.condition());
}

// The rows of this process.
template <class Rows>
void FormFactors::multiply(const Panel& x, Rows& y) const {
  in_parallel(tbb::blocked_range<std::size_t>(0, rows_.size(), kVerticesPerTask), [&](const auto& part) {
    output::check_interrupt();
    RowMaker make;
    for (std::size_t v = part.begin(); v < part.end(); ++v) {
      if (!ranks_.owns(v)) continue;
      if (kept_[v] == 0 && !make) make = make_maker_();
      sum_row(kept_[v] != 0 ? rows_[v] : make(v), x.values.data(), x.columns, y.row(v));
    }
  });
}

void FormFactors::apply(const Panel& x, Panel& y) const {
  multiply(x, y);
  fill_.apply(y.values.data(), y.columns, y.columns);
}

void FormFactors::advance(Panel& x, OwnRows& room) const {
  multiply(x, room);
  ranks_.count > 1 ? room.gather(x) : room.swap(x);
  fill_.apply(x.values.data(), x.columns, x.columns);
}

}  // namespace sh::prt
