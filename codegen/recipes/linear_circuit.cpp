#include "codegen/recipes/linear_circuit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <tuple>

namespace sh::codegen {
namespace {

constexpr int kDigits = 30;
constexpr double kSame = 1e-12;  // relative; the pipeline later checks every circuit with 100 digits

// An exact constant and the double that the search compares. It is shared, because the search copies it often.
struct Factor {
  std::shared_ptr<const ExactReal> exact;
  double value = 0;
};

bool same(double a, double b) { return std::abs(a - b) <= kSame * std::abs(b); }
bool is_unit(double a) { return same(std::abs(a), 1); }

Factor factor_of(const ExactReal& exact) {
  return {std::make_shared<const ExactReal>(exact), cln::double_approx(evaluate(exact, kDigits))};
}

ExactReal unit(double sign) { return symbolic::Surd(sign < 0 ? -1 : 1); }

Factor quotient(const Factor& a, const Factor& b) {
  const double value = a.value / b.value;
  if (is_unit(value)) return {std::make_shared<const ExactReal>(unit(value)), value < 0 ? -1.0 : 1.0};
  return {std::make_shared<const ExactReal>(multiply(*a.exact, reciprocal(*b.exact))), value};
}

using Row = std::map<int, Factor>;

// The values x = first and y = second, and the rows that have the same ratio y/x.
struct Candidate {
  int first = 0;
  int second = 0;
  double ratio = 0;
  std::vector<std::size_t> rows;
  int scaled_by = 0;  // the new value is x + (c_y/c_x) y, y + (c_x/c_y) x, or c_x x + c_y y of the first row
  int saving = 0;
};

class Search {
 public:
  Search(std::vector<Row> rows, int columns, unsigned seed)
      : rows_(std::move(rows)), columns_(columns), values_(columns), seed_(seed), random_(seed) {}

  LinearCircuit run() {
    while (const auto candidate = best()) replace(*candidate);
    return finish();
  }

 private:
  // The number of different products of a value with a constant.
  static int products(const std::vector<double>& factors) {
    std::vector<double> sizes;
    for (const double f : factors) {
      if (is_unit(f)) continue;
      const double size = std::abs(f);
      if (std::none_of(sizes.begin(), sizes.end(), [size](double s) { return same(size, s); })) sizes.push_back(size);
    }
    return static_cast<int>(sizes.size());
  }

  // The constants of a value in all rows except the rows `without`.
  [[nodiscard]] std::vector<double> factors(int value, const std::vector<std::size_t>& without) const {
    std::vector<double> result;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const auto found = rows_[r].find(value);
      if (found != rows_[r].end() && !std::binary_search(without.begin(), without.end(), r))
        result.push_back(found->second.value);
    }
    return result;
  }

  [[nodiscard]] int saving(const Candidate& c) const {
    const Factor& x = rows_[c.rows[0]].at(c.first);
    const Factor& y = rows_[c.rows[0]].at(c.second);
    std::vector<double> of_x = factors(c.first, c.rows);
    std::vector<double> of_y = factors(c.second, c.rows);
    std::vector<double> of_new;
    for (const std::size_t r : c.rows) {
      const double f = rows_[r].at(c.scaled_by == 1 ? c.second : c.first).value;
      of_new.push_back(c.scaled_by == 2 ? f / x.value : f);
    }
    of_x.push_back(c.scaled_by == 0 ? 1 : c.scaled_by == 1 ? x.value / y.value : x.value);
    of_y.push_back(c.scaled_by == 1 ? 1 : c.scaled_by == 0 ? y.value / x.value : y.value);
    const int before = products(factors(c.first, {})) + products(factors(c.second, {}));
    const int after = products(of_x) + products(of_y) + products(of_new);
    return before - after + static_cast<int>(c.rows.size()) - 1;
  }

  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::map<std::pair<int, int>, std::vector<Candidate>> found;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (auto x = rows_[r].begin(); x != rows_[r].end(); ++x) {
        for (auto y = std::next(x); y != rows_[r].end(); ++y) {
          const double ratio = y->second.value / x->second.value;
          std::vector<Candidate>& of_pair = found[{x->first, y->first}];
          const auto known = std::find_if(of_pair.begin(), of_pair.end(),
                                          [ratio](const Candidate& c) { return same(c.ratio, ratio); });
          if (known == of_pair.end()) {
            of_pair.push_back({x->first, y->first, ratio, {r}});
          } else {
            known->rows.push_back(r);
          }
        }
      }
    }
    std::vector<Candidate> all;
    for (auto& [pair, of_pair] : found) std::move(of_pair.begin(), of_pair.end(), std::back_inserter(all));
    return all;
  }

  std::optional<Candidate> best() {
    std::vector<Candidate> equals;
    for (Candidate& c : candidates()) {
      if (c.rows.size() < 2) continue;
      for (c.scaled_by = 0; c.scaled_by < 3; ++c.scaled_by) {
        c.saving = saving(c);
        if (c.saving <= 0 || (!equals.empty() && c.saving < equals[0].saving)) continue;
        if (!equals.empty() && c.saving > equals[0].saving) equals.clear();
        equals.push_back(c);
      }
    }
    if (equals.empty()) return std::nullopt;
    return equals[seed_ == 0 ? 0 : random_() % equals.size()];
  }

  void replace(const Candidate& c) {
    const Factor x = rows_[c.rows[0]].at(c.first);
    const Factor y = rows_[c.rows[0]].at(c.second);
    const Factor one{std::make_shared<const ExactReal>(unit(1)), 1};
    const int added = values_++;
    if (c.scaled_by == 0) sums_.push_back({{c.first, one}, {c.second, quotient(y, x)}});
    if (c.scaled_by == 1) sums_.push_back({{c.first, quotient(x, y)}, {c.second, one}});
    if (c.scaled_by == 2) sums_.push_back({{c.first, x}, {c.second, y}});
    for (const std::size_t r : c.rows) {
      const Factor f = rows_[r].at(c.scaled_by == 1 ? c.second : c.first);
      rows_[r].erase(c.first);
      rows_[r].erase(c.second);
      rows_[r].emplace(added, c.scaled_by == 2 ? quotient(f, x) : f);
    }
  }

  // Orders the sums by their dependencies. Every product with a constant that occurs twice becomes a value.
  LinearCircuit finish() {
    LinearCircuit circuit;
    circuit.inputs = columns_;
    std::vector<std::vector<std::pair<double, int>>> products(values_);
    std::vector<int> position(values_);
    std::vector<Row> all = sums_;
    all.insert(all.end(), rows_.begin(), rows_.end());
    for (int i = 0; i < columns_; ++i) position[i] = i;
    const auto uses = [&](int value, double size) {
      return std::count_if(all.begin(), all.end(), [&](const Row& row) {
        const auto found = row.find(value);
        return found != row.end() && same(std::abs(found->second.value), size);
      });
    };
    const auto append = [&](std::vector<LinearTerm> terms) {
      circuit.sums.push_back(std::move(terms));
      return circuit.inputs + static_cast<int>(circuit.sums.size()) - 1;
    };
    const auto term = [&](int value, const Factor& f) -> LinearTerm {
      const int source = position[value];
      if (is_unit(f.value)) return {source, unit(f.value)};
      const double size = std::abs(f.value);
      if (uses(value, size) < 2) return {source, *f.exact};
      auto& known = products[value];
      auto found = std::find_if(known.begin(), known.end(), [size](const auto& p) { return same(p.first, size); });
      if (found == known.end()) {
        known.emplace_back(size, append({{source, f.value < 0 ? negate(*f.exact) : *f.exact}}));
        found = std::prev(known.end());
      }
      return {found->second, unit(f.value)};
    };
    const auto row_terms = [&](const Row& row) {
      std::vector<LinearTerm> terms;
      for (const auto& [value, f] : row) terms.push_back(term(value, f));
      return terms;
    };
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const int at = append(row_terms(sums_[i]));
      position[columns_ + i] = at;
    }
    for (const Row& row : rows_) {
      std::vector<LinearTerm> terms = row_terms(row);
      circuit.outputs.push_back(terms.empty() ? -1 : append(std::move(terms)));
    }
    return circuit;
  }

  std::vector<Row> rows_;
  int columns_;
  int values_;
  unsigned seed_;
  std::mt19937 random_;
  std::vector<Row> sums_;
};

// True for 1 and -1.
bool is_sign(const ExactReal& factor) {
  const auto rational = as_rational(factor);
  return rational && cln::abs(*rational) == 1;
}

// Compilers of shaders put chains of five or more values that are used elsewhere, too, in another order, even of results
// that are declared invariant. They keep balanced trees, so that these have the same bits in every language.
bool is_long_chain(const std::vector<LinearTerm>& sum) {
  constexpr std::size_t kLongestKept = 4;
  return sum.size() > kLongestKept &&
         std::all_of(sum.begin(), sum.end(), [](const LinearTerm& term) { return is_sign(term.factor); });
}

}  // namespace

int LinearCircuit::operations() const {
  int total = 0;
  for (const auto& terms : sums) {
    total += static_cast<int>(terms.size()) - 1;
    for (const LinearTerm& term : terms) {
      if (!is_sign(term.factor)) ++total;
    }
  }
  return total;
}

LinearCircuit short_circuit(const LinearMap& rows, int columns, int attempts) {
  std::vector<Row> start;
  for (const auto& entries : rows) {
    Row row;
    for (const auto& [column, entry] : entries) {
      if (!is_zero(entry)) row.emplace(column, factor_of(entry));
    }
    start.push_back(std::move(row));
  }
  LinearCircuit shortest = Search(start, columns, 0).run();
  for (int seed = 1; seed < attempts; ++seed) {
    LinearCircuit circuit = Search(start, columns, static_cast<unsigned>(seed)).run();
    if (circuit.operations() < shortest.operations()) shortest = std::move(circuit);
  }
  return shortest;
}

std::vector<Value> run_forwards(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& columns) {
  std::vector<Value> values = columns;
  for (const auto& sum : circuit.sums) {
    std::vector<Value> terms;
    terms.reserve(sum.size());
    for (const LinearTerm& term : sum) {
      terms.push_back(build.times_once(term.factor, values[term.source]));
    }
    values.push_back(is_long_chain(sum) ? build.balanced_sum(terms) : build.sum(terms));
  }
  std::vector<Value> rows;
  for (const int output : circuit.outputs) {
    rows.push_back(output < 0 ? Value{} : values[output]);
  }
  return rows;
}

std::vector<Value> run_transposed(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& rows) {
  // The parts of every value that come from later values.
  std::vector<std::vector<Value>> reaching(circuit.inputs + circuit.sums.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (circuit.outputs[i] >= 0) reaching[circuit.outputs[i]].push_back(rows[i]);
  }
  for (std::size_t i = circuit.sums.size(); i-- > 0;) {
    const Value value = build.sum(reaching[circuit.inputs + i]);
    for (const LinearTerm& term : circuit.sums[i]) {
      reaching[term.source].push_back(build.times_once(term.factor, value));
    }
  }
  std::vector<Value> columns;
  columns.reserve(circuit.inputs);
  for (int i = 0; i < circuit.inputs; ++i) columns.push_back(build.sum(reaching[i]));
  return columns;
}

}  // namespace sh::codegen
