#include "codegen/recipes/product/phi_transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

namespace {

constexpr int kQuickAttempts = 2;
constexpr int kThoroughAttempts = 30;

}  // namespace

PhiTransform::PhiTransform(const PhiShape& shape) : shape_(shape), scales_((2 * shape.degree + 1), ExactReal(Surd(1))) {
  for (int part = 0; part < kParts; ++part) {
    auto& columns = columns_[part];
    for (const int order : orders_of(part)) {
      for (int ring = 0; ring < (shared(order) ? 1 : shape.rings); ++ring) columns.push_back({ring, order});
    }
    choose_scales(part);
    circuits_[part] = short_circuit(matrix(part), static_cast<int>(columns.size()), kThoroughAttempts);
  }
}

const ExactReal& PhiTransform::scale(int order) const { return scales_[order + shape_.degree]; }

std::vector<int> PhiTransform::orders_of(int part) const {
  std::vector<int> orders;
  for (int order = -shape_.degree; order <= shape_.degree; ++order) {
    if (part_of(order) == part) orders.push_back(order);
  }
  return orders;
}

ExactReal PhiTransform::entry(int order, int j) const {
  const int half_steps = 2 * j + (shape_.half_step ? 1 : 0);
  const ExactReal value =
      order < 0 ? sine(-order * half_steps, 2 * shape_.angles) : cosine(order * half_steps, 2 * shape_.angles);
  const bool end = j == 0 || j + 1 == samples();
  return shape_.half_at_ends && end ? multiply(value, Surd(cln::cl_RA(1) / 2)) : value;
}

LinearMap PhiTransform::matrix(int part) const {
  LinearMap rows(shape_.rings * samples());
  const auto& columns = columns_[part];
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const Column& column = columns[c];
    for (int j = 0; j < samples(); ++j) {
      const ExactReal value = entry(column.order, j);
      if (is_zero(value)) continue;
      for (int ring = 0; ring < shape_.rings; ++ring) {
        if (!shared(column.order) && ring != column.ring) continue;
        rows[ring * samples() + j].emplace(static_cast<int>(c), multiply(value, reciprocal(scale(column.order))));
      }
    }
  }
  return rows;
}

int PhiTransform::cost(int part, int attempts) const {
  const auto columns = static_cast<int>(columns_[part].size());
  int total = short_circuit(matrix(part), columns, attempts).operations();
  for (const auto& [order, preferred] : shape_.preferred) {
    const auto& [wanted, operations] = preferred;
    if (part_of(order) == part && std::abs(approximate(wanted) / approximate(scale(order)) - 1) > 1e-9)
      total += operations;
  }
  return total;
}

std::vector<ExactReal> PhiTransform::candidate_scales(int order) const {
  std::vector<ExactReal> candidates;
  const auto add = [&](const ExactReal& value) {
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const ExactReal& c) {
      return std::abs(approximate(c) / approximate(value) - 1) < 1e-9;
    });
    if (!known) candidates.push_back(value);
  };
  add(Surd(1));
  if (const auto preferred = shape_.preferred.find(order); preferred != shape_.preferred.end())
    add(preferred->second.first);
  for (int j = 0; j < samples(); ++j) {
    const ExactReal value = entry(order, j);
    if (!is_zero(value)) add(is_negative(value) ? negate(value) : value);
  }
  return candidates;
}

// Sets one scale after the other to the value with the shortest circuit.
void PhiTransform::choose_scales(int part) {
  int best = cost(part, kQuickAttempts);
  for (const int order : orders_of(part)) {
    if (std::find(shape_.unscaled.begin(), shape_.unscaled.end(), std::abs(order)) != shape_.unscaled.end()) continue;
    ExactReal& chosen = scales_[order + shape_.degree];
    ExactReal before = chosen;
    for (const ExactReal& candidate : candidate_scales(order)) {
      chosen = candidate;
      if (const int total = cost(part, kQuickAttempts); total < best) {
        best = total;
        before = candidate;
      }
    }
    chosen = before;
  }
}

PhiTransform::Samples PhiTransform::sample(SignedBuilder& build, const Coefficients& coefficients) const {
  Samples result(shape_.rings, std::vector<std::array<Value, kParts>>(samples()));
  for (std::size_t part = 0; part < kParts; ++part) {
    std::vector<Value> inputs;
    for (const Column& column : columns_[part]) {
      inputs.push_back(coefficients[column.ring][column.order + shape_.degree]);
    }
    const std::vector<Value> rows = run_forwards(build, circuits_[part], inputs);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto per_ring = samples();
      result[i / per_ring][i % per_ring][part] = rows[i];
    }
  }
  return result;
}

PhiTransform::Coefficients PhiTransform::analyze(SignedBuilder& build, const Samples& given) const {
  Coefficients result(shape_.rings, std::vector<Value>(2 * shape_.degree + 1));
  for (std::size_t part = 0; part < kParts; ++part) {
    std::vector<Value> rows;
    for (const auto& ring : given) {
      for (const auto& parts : ring) rows.push_back(parts[part]);
    }
    const std::vector<Value> columns = run_transposed(build, circuits_[part], rows);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Column& column = columns_[part][c];
      result[column.ring][column.order + shape_.degree] = columns[c];
    }
  }
  return result;
}

}  // namespace sh::codegen::recipes
