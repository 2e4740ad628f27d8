// BiCGSTAB [VanDerVorst92] for all columns of a panel at once: one application of the operator serves all of them, but
// each column has its own scalars. The recursive residual drifts from the true residual. The true residual is therefore
// computed before anything is certified, and the iteration restarts from there if necessary.
#include <numeric>
#include <vector>

#include "prt/bake/bounce_system.hpp"

namespace sh::prt {

namespace {

using Scalars = Eigen::ArrayXd;  // (columns)

// sum over rows of a b, column by column, in an order that no thread changes.
Scalars dots(const Panel& a, const Panel& b) {
  const Eigen::Index columns = a.columns;
  std::vector<Scalars> sums((a.rows + kRowsAPart - 1) / kRowsAPart, Scalars::Zero(columns));
  for_rows(a.rows, [&](std::size_t first, std::size_t last) {
    Scalars& sum = sums[first / kRowsAPart];
    for (std::size_t v = first; v < last; ++v) sum += a.block(v, v + 1).col(0) * b.block(v, v + 1).col(0);
  });
  return std::accumulate(sums.begin(), sums.end(), Scalars(Scalars::Zero(columns)));
}

// y += a x, column by column.
void add(const Scalars& a, const Panel& x, Panel& y) {
  for_rows(y.rows,
           [&](std::size_t first, std::size_t last) { y.block(first, last) += x.block(first, last).colwise() * a; });
}

// p = r + b p, column by column.
void follow(const Panel& r, const Scalars& b, Panel& p) {
  for_rows(p.rows, [&](std::size_t first, std::size_t last) {
    p.block(first, last) = r.block(first, last) + p.block(first, last).colwise() * b;
  });
}

// 0 if a column is solved or breaks down; the column then does not change until the next start.
Scalars ratio(const Scalars& a, const Scalars& b) {
  const Scalars value = a / b;
  return value.isFinite().select(value, 0.0);
}

// y = (I - A) x
void apply_system(BounceSystem& system, const Panel& x, Panel& y) {
  system.apply(x, y);
  for_rows(x.rows, [&](std::size_t first, std::size_t last) {
    y.block(first, last) = x.block(first, last) - y.block(first, last);
  });
}

// Iterates until the recursive residual is small enough or a restart is due.
void run_cycle(BounceSystem& system, Panel& x, Panel& r) {
  constexpr int kSteps = 32;
  const Panel shadow = r;
  Panel p = r;
  Panel v(x.rows, x.columns);
  Panel t(x.rows, x.columns);
  Scalars rho = dots(shadow, r);
  for (int step = 0; step < kSteps && !system.is_solved(); ++step) {
    apply_system(system, p, v);
    const Scalars alpha = ratio(rho, dots(shadow, v));
    add(alpha, p, x);
    add(-alpha, v, r);
    apply_system(system, r, t);
    const Scalars omega = ratio(dots(t, r), dots(t, t));
    add(omega, r, x);
    add(-omega, t, r);
    const Scalars next = dots(shadow, r);
    add(-omega, v, p);
    follow(r, ratio(next, rho) * ratio(alpha, omega), p);
    rho = next;
    system.certify(x, r);
    if (!system.may_go_on()) return;
  }
}

}  // namespace

void solve_krylov(BounceSystem& system, const Panel& b, Panel& x, Panel& r) {
  while (!system.is_solved() && system.may_go_on()) {
    run_cycle(system, x, r);
    system.residual(b, x, r);
    system.certify(x, r);
    if (system.may_go_on()) system.keep(BounceState::Phase::kKrylov, 0.0, x, r);  // else the cycle may have no end
  }
}

}  // namespace sh::prt
