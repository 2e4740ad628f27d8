// BiCGSTAB [VanDerVorst92] for all columns of a panel at once: one application of the operator serves all of them, but
// each column has its own scalars. The recursive residual drifts from the true residual. The true residual is therefore
// computed before anything is certified, and the iteration restarts from there if necessary.
//
// Each process keeps and turns its own rows of all vectors; only what the operator is applied to is a whole panel.
#include <vector>

#include "prt/bake/bounce_system.hpp"

namespace sh::prt {

namespace {

using Scalars = Eigen::ArrayXd;  // (columns)

// sum over the rows of all processes of a b, column by column, in an order that neither threads nor processes change.
Scalars dots(const Ranks& ranks, const OwnRows& a, const OwnRows& b) {
  static_assert(kRowsAPart == Ranks::kRowsAtOnce);
  Panel sums((a.rows() + kRowsAPart - 1) / kRowsAPart, a.columns());  // a row for each part
  for_own_rows(ranks, a.rows(), [&](std::size_t first, std::size_t last) {
    auto sum = sums.block(first / kRowsAPart, first / kRowsAPart + 1).col(0);
    for (std::size_t v = first; v < last; ++v) sum += a.block(v, v + 1).col(0) * b.block(v, v + 1).col(0);
  });
  Scalars total = Scalars::Zero(static_cast<Eigen::Index>(sums.columns));
  for (std::size_t part = 0; part < sums.rows; ++part) {
    if (ranks.count > 1) ranks.broadcast(sums.row(part), sums.columns, ranks.owner(part * kRowsAPart));
    total += sums.block(part, part + 1).col(0);
  }
  return total;
}

// y += a x, column by column.
void add(const Ranks& ranks, const Scalars& a, const OwnRows& x, OwnRows& y) {
  for_own_rows(ranks, y.rows(), [&](std::size_t first, std::size_t last) {
    y.block(first, last) += x.block(first, last).colwise() * a;
  });
}

// p = r + b p, column by column.
void follow(const Ranks& ranks, const OwnRows& r, const Scalars& b, OwnRows& p) {
  for_own_rows(ranks, p.rows(), [&](std::size_t first, std::size_t last) {
    p.block(first, last) = r.block(first, last) + p.block(first, last).colwise() * b;
  });
}

// 0 if a column is solved or breaks down; the column then does not change until the next start.
Scalars ratio(const Scalars& a, const Scalars& b) {
  const Scalars value = a / b;
  return value.isFinite().select(value, 0.0);
}

// y = (I - A) x, by way of `whole`.
void apply_system(BounceSystem& system, const OwnRows& x, OwnRows& y, Panel& whole) {
  x.gather(whole);
  system.advance(whole, y);
  for_own_rows(system.ranks(), x.rows(), [&](std::size_t first, std::size_t last) {
    y.block(first, last) = x.block(first, last) - whole.block(first, last);
  });
}

// Iterates until the recursive residual is small enough or a restart is due.
void run_cycle(BounceSystem& system, OwnRows& x, OwnRows& r, Panel& whole) {
  constexpr int kSteps = 32;
  const Ranks& ranks = system.ranks();
  const OwnRows shadow = r;
  OwnRows p = r;
  OwnRows v(ranks, x.rows(), x.columns());
  OwnRows t = v;
  Scalars rho = dots(ranks, shadow, r);
  for (int step = 0; step < kSteps && !system.is_solved(); ++step) {
    apply_system(system, p, v, whole);
    const Scalars alpha = ratio(rho, dots(ranks, shadow, v));
    add(ranks, alpha, p, x);
    add(ranks, -alpha, v, r);
    apply_system(system, r, t, whole);
    const Scalars omega = ratio(dots(ranks, t, r), dots(ranks, t, t));
    add(ranks, omega, r, x);
    add(ranks, -omega, t, r);
    const Scalars next = dots(ranks, shadow, r);
    add(ranks, -omega, v, p);
    follow(ranks, r, ratio(next, rho) * ratio(alpha, omega), p);
    rho = next;
    system.certify(x, r);
    if (!system.may_go_on()) return;
  }
}

}  // namespace

void solve_krylov(BounceSystem& system, const OwnRows& b, OwnRows& x, Panel& r) {
  OwnRows own_r(system.ranks(), r);
  while (!system.is_solved() && system.may_go_on()) {
    run_cycle(system, x, own_r, r);
    OwnRows room(system.ranks(), x.rows(), x.columns());
    system.residual(b, x, r, room);
    own_r = OwnRows(system.ranks(), r);
    system.certify(x, own_r);
    if (system.may_go_on()) system.keep(BounceState::Phase::kKrylov, 0.0, x, own_r);  // else the cycle may have no end
  }
}

}  // namespace sh::prt
