// The changes that mutations make to numbers, polynomials, matrices and functions.
#pragma once

#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "symbolic/proofs/mutations/mutation.hpp"

namespace sh::symbolic {

/// A formula that can be changed, by its name.
using Mutators = std::map<std::string, std::function<void(Formulas& formulas, const Mutation& mutation)>>;
Mutators basis_mutators();
Mutators rotation_mutators();
Mutators convention_mutators();
Mutators zonal_mutators();
Mutators product_mutators();

/// A kind that does not apply to its formula. It shows when a proof asks for the entry.
struct WrongKind : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};
[[noreturn]] inline void refuse_kind(const std::string& kind) {
  throw WrongKind("the kind '" + kind + "' does not apply to it");
}

/// Number i of the entry.
inline int number(const Mutation& mutation, std::size_t i) {
  std::size_t read = 0;
  try {
    const int value = std::stoi(mutation.entry.at(i), &read);
    if (read == mutation.entry[i].size()) return value;
  } catch (const std::logic_error&) {  // no number, or no such word
  }
  throw std::invalid_argument("expected a number as part " + std::to_string(i + 1) + " of the entry");
}

/// sign: the other sign; factor: one part in a million more; drop: 0; inverse: 1 / number.
template <class Number>
void change_number(Number& value, const std::string& kind) {
  const cln::cl_RA more = cln::cl_RA(1'000'001) / 1'000'000;
  if (kind == "sign") {
    value = Number(cln::cl_RA(-1)) * value;
  } else if (kind == "factor") {
    value = Number(more) * value;
  } else if (kind == "drop") {
    value = Number();
  } else {
    refuse_kind(kind);
  }
}
inline void change(RadicalSum& value, const std::string& kind) { change_number(value, kind); }
inline void change(cln::cl_RA& value, const std::string& kind) {
  if (kind == "inverse") {
    value = cln::recip(value);
  } else {
    change_number(value, kind);
  }
}
inline void change(Surd& value, const std::string& kind) {
  if (kind == "inverse") {
    value = value.inverse();
  } else {
    change_number(value, kind);
  }
}
/// term: without its last term.
inline void change(Polynomial& value, const std::string& kind) {
  if (kind == "term") {
    const auto [monomial, coefficient] = *value.terms().rbegin();
    value.add_term(monomial, -coefficient);
  } else {
    change_number(value, kind);
  }
}

/// A band: "transpose", or the entry (row, column) counted from -l; "exchange": with the entry (column, row).
template <class Number>
void change_band(Matrix<Number>& band, int row, int column, const std::string& kind) {
  const int l = (band.rows() - 1) / 2;
  if (std::abs(row) > l || std::abs(column) > l) throw std::out_of_range("band");
  if (kind == "transpose") {
    band = band.transposed();
  } else if (kind == "exchange") {
    std::swap(band(l + row, l + column), band(l + column, l + row));
  } else {
    change(band(l + row, l + column), kind);
  }
}

/// `function` with change(value, arguments...) of its values.
template <class Value, class... Arguments, class Change>
void spoil(std::function<Value(Arguments...)>& function, const Change& change) {
  function = [original = function, change](Arguments... arguments) {
    Value value = original(arguments...);
    change(value, arguments...);
    return value;
  };
}

/// The value at the degree or index `number(mutation, 0)` changes as its kind says.
template <class Value>
void spoil_at(std::function<Value(int)>& function, const Mutation& mutation) {
  spoil(function, [at = number(mutation, 0), kind = mutation.kind](Value& value, int l) {
    if (l == at) change(value, kind);
  });
}

}  // namespace sh::symbolic
