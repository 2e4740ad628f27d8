#include "prt/bake/panel.hpp"

#include <algorithm>

namespace sh::prt {

namespace {

// Calls each(from, end) for the rows of first .. last - 1 that belong to one process, in order.
template <class Each>
void for_owned_together(std::size_t first, std::size_t last, const Each& each) {
  for (; first < last; first += Ranks::kRowsAtOnce) each(first, std::min(last, first + Ranks::kRowsAtOnce));
}

}  // namespace

OwnRows::OwnRows(const Ranks& ranks, const Panel& whole) : OwnRows(ranks, whole.rows, whole.columns) {
  for_owned_together(0, rows_, [&](std::size_t first, std::size_t last) {
    if (ranks.owns(first)) std::copy(whole.row(first), whole.row(last), row(first));
  });
}

void OwnRows::gather(std::size_t first, std::size_t last, double* to) const {
  for_owned_together(first, last, [&](std::size_t from, std::size_t end) {
    const std::size_t size = (end - from) * panel_.columns;
    if (ranks_->owns(from)) std::copy_n(row(from), size, to);
    if (ranks_->count > 1) ranks_->broadcast(to, size, ranks_->owner(from));
    to += size;
  });
}

}  // namespace sh::prt
