#include "tests/symbolic/formula_reader.hpp"

#include <cctype>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace sh::symbolic::test {
namespace {

using Number = std::complex<double>;

class Reader {
 public:
  Reader(const std::string& text, const Values& values) : text_(text), values_(values) {}

  Number whole() {
    const Number value = sum();
    if (place_ != text_.size()) fail("the end");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw std::runtime_error("formula '" + text_ + "', place " + std::to_string(place_) + ": expected " + expected);
  }

  bool take(const std::string& token) {
    if (text_.compare(place_, token.size(), token) != 0) return false;
    place_ += token.size();
    return true;
  }

  void skip_space() {
    while (take(" ") || take("\\,")) {
    }
  }

  Number sum() {
    skip_space();
    Number total = take("-") ? -product() : product();
    for (skip_space(); place_ < text_.size(); skip_space()) {
      if (take("+")) {
        total += product();
      } else if (take("-")) {
        total -= product();
      } else {
        break;
      }
    }
    return total;
  }

  bool at_factor() {
    skip_space();
    if (place_ == text_.size()) return false;
    const char c = text_[place_];
    return c == '(' || c == '\\' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  }

  Number product() {
    if (!at_factor()) fail("a factor");
    Number value = factor();
    while (at_factor()) value *= factor();
    return value;
  }

  Number factor() {
    const Number base = primary();
    return take("^") ? std::pow(base, std::stoi(braces())) : base;
  }

  Number primary() {
    if (take("(")) {
      const Number value = sum();
      if (!take(")")) fail("')'");
      return value;
    }
    if (take("\\frac")) {
      const Number above = inner();
      return above / inner();
    }
    if (take("\\sqrt")) return std::sqrt(inner());
    if (take("\\pi")) return std::numbers::pi;
    if (std::isdigit(static_cast<unsigned char>(text_[place_])) != 0) return integer();
    return variable();
  }

  Number inner() {
    if (!take("{")) fail("'{'");
    const Number value = sum();
    if (!take("}")) fail("'}'");
    return value;
  }

  std::string braces() {
    if (!take("{")) fail("'{'");
    const std::size_t end = text_.find('}', place_);
    if (end == std::string::npos) fail("'}'");
    std::string inside = text_.substr(place_, end - place_);
    place_ = end + 1;
    return inside;
  }

  double integer() {
    std::size_t length = 0;
    const double value = std::stod(text_.substr(place_), &length);
    place_ += length;
    return value;
  }

  Number variable() {
    if (std::isalpha(static_cast<unsigned char>(text_[place_])) == 0) fail("a name");
    std::string name(1, text_[place_++]);
    if (take("_")) name += "_{" + braces() + "}";
    if (name == "i") return {0, 1};
    const auto found = values_.find(name);
    if (found == values_.end()) fail("a known name instead of '" + name + "'");
    return found->second;
  }

  const std::string& text_;
  const Values& values_;
  std::size_t place_ = 0;
};

}  // namespace

std::map<std::string, std::string> read_formulas(const std::string& document) {
  std::map<std::string, std::string> formulas;
  std::istringstream lines(document);
  for (std::string line; std::getline(lines, line);) {
    const bool latex = line.starts_with("\\hangindent=2em $") && line.ends_with("$");
    const bool markdown = line.starts_with("| $") && line.ends_with("$ |");
    if (!latex && !markdown) continue;
    const std::size_t start = line.find('$') + 1;
    const std::string separator = latex ? " = " : "$ | $";
    const std::size_t middle = line.find(separator);
    const std::size_t right = middle + separator.size();
    const std::size_t end = line.rfind('$');
    if (!formulas.emplace(line.substr(start, middle - start), line.substr(right, end - right)).second) {
      throw std::runtime_error("two formulas for one symbol: " + line);
    }
  }
  return formulas;
}

std::complex<double> evaluate(const std::string& formula, const Values& values) {
  return Reader(formula, values).whole();
}

}  // namespace sh::symbolic::test
