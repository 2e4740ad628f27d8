// BiCGSTAB [VanDerVorst92] for all columns of a panel at once: one application of the operator serves all of them, but
// each column has its own scalars. The recursive residual drifts from the true residual. The true residual is therefore
// computed before anything is certified, and the iteration restarts from there if necessary.
#include <cmath>

#include "prt/bake/bounce_system.hpp"

namespace sh::prt {

namespace {

using Scalars = std::vector<double>;  // (columns)

// sum over rows of a b, column by column, in an order that no thread changes.
Scalars dots(const Panel& a, const Panel& b) {
  constexpr std::size_t kRowsAPart = 256;
  const std::size_t parts = (a.rows + kRowsAPart - 1) / kRowsAPart;
  Panel sums(parts, a.columns);
  for_rows(a.rows, [&](std::size_t first, std::size_t last) {
    double* sum = sums.row(first / kRowsAPart);
    for (std::size_t v = first; v < last; ++v) {
      for (std::size_t i = 0; i < a.columns; ++i) sum[i] += a.row(v)[i] * b.row(v)[i];
    }
  });
  Scalars total(a.columns, 0.0);
  for (std::size_t part = 0; part < parts; ++part) {
    for (std::size_t i = 0; i < a.columns; ++i) total[i] += sums.row(part)[i];
  }
  return total;
}

// y += sign a x, column by column.
void add(const Scalars& a, double sign, const Panel& x, Panel& y) {
  for_rows(y.rows, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      for (std::size_t i = 0; i < y.columns; ++i) y.row(v)[i] += sign * a[i] * x.row(v)[i];
    }
  });
}

// p = r + b p, column by column.
void follow(const Panel& r, const Scalars& b, Panel& p) {
  for_rows(p.rows, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      for (std::size_t i = 0; i < p.columns; ++i) p.row(v)[i] = r.row(v)[i] + b[i] * p.row(v)[i];
    }
  });
}

// 0 if a column is solved or breaks down; the column then does not change until the next start.
Scalars ratio(const Scalars& a, const Scalars& b) {
  Scalars out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double value = a[i] / b[i];
    out[i] = std::isfinite(value) ? value : 0.0;
  }
  return out;
}

Scalars product(Scalars a, const Scalars& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::multiplies<>());
  return a;
}

// y = (I - A) x
void apply_system(BounceSystem& system, const Panel& x, Panel& y) {
  system.apply(x, y);
  for_rows(x.rows, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first * x.columns; i < last * x.columns; ++i) y.values[i] = x.values[i] - y.values[i];
  });
}

// Iterates until the recursive residual is small enough or a restart is due.
void run_cycle(BounceSystem& system, Panel& x, Panel& r, const BounceOptions& options, BounceReport& report) {
  constexpr int kSteps = 32;
  const Panel shadow = r;
  Panel p = r;
  Panel v(x.rows, x.columns);
  Panel t(x.rows, x.columns);
  Scalars rho = dots(shadow, r);
  for (int step = 0; step < kSteps && !is_solved(report, options); ++step) {
    apply_system(system, p, v);
    const Scalars alpha = ratio(rho, dots(shadow, v));
    add(alpha, 1.0, p, x);
    add(alpha, -1.0, v, r);
    apply_system(system, r, t);
    const Scalars omega = ratio(dots(t, r), dots(t, t));
    add(omega, 1.0, r, x);
    add(omega, -1.0, t, r);
    const Scalars next = dots(shadow, r);
    add(omega, -1.0, v, p);
    follow(r, product(ratio(next, rho), ratio(alpha, omega)), p);
    rho = next;
    system.certify(x, r, report);
    if (!may_go_on(system, options)) return;
  }
}

}  // namespace

void solve_krylov(BounceSystem& system, const Panel& b, Panel& x, Panel& r, const BounceOptions& options,
                  BounceReport& report) {
  while (!is_solved(report, options) && may_go_on(system, options)) {
    run_cycle(system, x, r, options, report);
    system.residual(b, x, r);
    system.certify(x, r, report);
  }
}

}  // namespace sh::prt
