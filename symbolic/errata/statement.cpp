#include "symbolic/errata/statement.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "symbolic/errata/definitions.hpp"
#include "symbolic/errata/vocabulary.hpp"

namespace sh::symbolic::errata {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

// ---- normal form

// sqrt(n), n > 0, as a rational times square roots of primes.
ex root_of_integer(numeric n) {
  ex result = 1;
  for (numeric p = 2; p * p <= n; p += 1) {
    for (; GiNaC::irem(n, p * p).is_zero(); n = GiNaC::iquo(n, p * p)) result *= p;
    if (GiNaC::irem(n, p).is_zero()) {
      result *= GiNaC::sqrt(ex(p));
      n = GiNaC::iquo(n, p);
    }
  }
  return result * GiNaC::sqrt(ex(n));
}

struct SplitRadicals : GiNaC::map_function {
  ex operator()(const ex& e) override {
    if (!GiNaC::is_a<GiNaC::power>(e)) return e.map(*this);
    const ex base = e.op(0).map(*this);
    const ex twice = 2 * e.op(1);
    if (!base.info(GiNaC::info_flags::positive) || !GiNaC::is_a<numeric>(base) ||
        !base.info(GiNaC::info_flags::rational) || !twice.info(GiNaC::info_flags::odd)) {
      return GiNaC::pow(base, e.op(1));
    }
    const numeric q = GiNaC::ex_to<numeric>(base);
    const ex root = root_of_integer(q.numer() * q.denom()) / q.denom();
    return GiNaC::pow(q, (twice - 1) / 2) * root;
  }
};

bool has_symbolic_denominator(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& node) {
    return GiNaC::is_a<GiNaC::power>(node) && !node.op(0).info(GiNaC::info_flags::numeric) &&
           node.op(1).info(GiNaC::info_flags::negative) && !node.op(0).is_equal(GiNaC::Pi);
  });
}

// Powers of `name` from the square on replaced: name^2 = square.
ex reduce(const ex& e, const ex& name, const ex& square) {
  ex result = 0;
  for (int k = e.ldegree(name); k <= e.degree(name); ++k) {
    result += e.coeff(name, k) * GiNaC::pow(name, k % 2) * GiNaC::pow(square, k / 2);
  }
  return result.expand();
}

ex normal_form(const ex& expression) {
  SplitRadicals split;
  ex e = split(expression).expand();
  if (has_symbolic_denominator(e)) e = split(e.normal().numer()).expand();
  for (const auto& [cosine, sine] : {std::pair{"c", "s"}, std::pair{"cp", "sp"}, std::pair{"ca", "sa"},
                                     std::pair{"cb", "sb"}, std::pair{"cg", "sg"}, std::pair{"ch", "sh"}}) {
    e = reduce(e, symbol(sine), 1 - GiNaC::pow(symbol(cosine), 2));
  }
  e = reduce(e, symbol("z"), 1 - GiNaC::pow(symbol("x"), 2) - GiNaC::pow(symbol("y"), 2));
  return split(e).expand();
}

// ---- reading

struct Range {
  ex index;
  ex first;
  ex last;
};

struct Relation {
  ex left;
  std::string sign;
  ex right;
  std::string decimal;  // after ~
};

struct Statement {
  std::vector<Range> ranges;
  std::vector<Relation> relations;
};

ex read(const std::string& text) { return GiNaC::parser(symbols(), true)(text); }

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  int depth = 0;
  std::string part;
  for (const char letter : text) {
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == separator && depth == 0) {
      parts.push_back(std::exchange(part, ""));
    } else {
      part += letter;
    }
  }
  parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

Range read_range(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dots = text.find("..");
  if (equals == std::string::npos || dots == std::string::npos) {
    throw std::invalid_argument("expected a range such as l=0..4, got '" + text + "'");
  }
  return {read(text.substr(0, equals)), read(text.substr(equals + 1, dots - equals - 1)), read(text.substr(dots + 2))};
}

Relation read_relation(const std::string& text) {
  for (const char* const sign : {"==", "!=", "<=", ">=", "<", ">", "~"}) {
    const std::size_t place = text.find(sign);
    if (place == std::string::npos) continue;
    const std::string right = trimmed(text.substr(place + std::string(sign).size()));
    const bool rounds = *sign == '~';
    return {read(text.substr(0, place)), sign, rounds ? ex(0) : read(right), rounds ? right : ""};
  }
  throw std::invalid_argument("expected a relation such as a == b, got '" + text + "'");
}

Statement read_statement(const std::string& text) {
  Statement statement;
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    for (const std::string& range : split(text.substr(0, colon), ',')) statement.ranges.push_back(read_range(range));
  }
  const std::string relations = colon == std::string::npos ? text : text.substr(colon + 1);
  for (const std::string& relation : split(relations, ';')) statement.relations.push_back(read_relation(relation));
  return statement;
}

// ---- deciding

constexpr long kDigits = 60;

numeric value(const ex& e) {
  const long before = GiNaC::Digits;
  GiNaC::Digits = kDigits;
  const ex number = e.evalf();
  GiNaC::Digits = before;
  if (!GiNaC::is_a<numeric>(number) || !GiNaC::ex_to<numeric>(number).is_real()) {
    throw std::invalid_argument("expected a real number to compare");
  }
  return GiNaC::ex_to<numeric>(number);
}

// "-1.250" -> -1250 / 10^3
bool rounds_to(const ex& e, const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  std::string digits = decimal;
  if (point != std::string::npos) digits.erase(point, 1);
  const int places = point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
  const numeric scale = GiNaC::ex_to<numeric>(GiNaC::pow(numeric(10), numeric(places)));
  return GiNaC::abs(value(e) * scale - numeric(digits.c_str())) <= numeric(1, 2);
}

bool vanishes(const ex& e) { return normal_form(e).is_zero(); }

bool holds(const Relation& relation, const GiNaC::exmap& values) {
  const ex left = relation.left.subs(values);
  const ex right = relation.right.subs(values);
  const std::string& sign = relation.sign;
  if (sign == "~") return rounds_to(left, relation.decimal);
  if (sign == "==") return vanishes(left - right);
  if (sign == "!=") return !vanishes(left - right);
  const numeric difference = value(left - right);
  if (sign.size() == 2 && vanishes(left - right)) return true;
  return sign[0] == '<' ? difference.is_negative() : difference.is_positive();
}

bool holds_from(const Statement& statement, std::size_t depth, GiNaC::exmap& values) {
  if (depth == statement.ranges.size()) {
    return std::all_of(statement.relations.begin(), statement.relations.end(),
                       [&](const Relation& relation) { return holds(relation, values); });
  }
  const Range& range = statement.ranges[depth];
  const auto bound = [&](const ex& e) { return GiNaC::ex_to<numeric>(e.subs(values)).to_int(); };
  const int last = bound(range.last);
  for (int k = bound(range.first); k <= last; ++k) {
    values[range.index] = k;
    if (!holds_from(statement, depth + 1, values)) return false;
  }
  values.erase(range.index);
  return true;
}

}  // namespace

bool holds(const std::string& statement) {
  try {
    const std::vector<std::string> parts = split(statement, '&');
    return std::all_of(parts.begin(), parts.end(), [](const std::string& part) {
      GiNaC::exmap values;
      return holds_from(read_statement(part), 0, values);
    });
  } catch (const std::exception& error) {
    throw std::invalid_argument("statement '" + statement + "': " + error.what());
  }
}

}  // namespace sh::symbolic::errata
