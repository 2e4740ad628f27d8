#include "tests/codegen/printed_code.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

namespace sh::codegen::test {
namespace {

using print::Scalar;

double rounded(double value, Scalar type) {
  return type == Scalar::kFloat ? static_cast<double>(static_cast<float>(value)) : value;
}

// A number of one of the two types. Sums and products of both types are double.
struct Number {
  double value = 0;
  Scalar type = Scalar::kFloat;
};

Scalar wider(const Number& a, const Number& b) {
  return a.type == Scalar::kDouble || b.type == Scalar::kDouble ? Scalar::kDouble : Scalar::kFloat;
}

// Rounding a sum, product, quotient or root in double to float gives the result of the operation in float.
Number number(double value, Scalar type) { return {rounded(value, type), type}; }

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Words (a name with its namespace, a number with its suffix) and single characters, without line comments.
std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
    } else if (in_word(c)) {
      const bool digits = std::isdigit(static_cast<unsigned char>(c)) != 0;
      std::size_t end = at;
      const auto goes_on = [&] {
        if (in_word(text[end])) return true;
        if (digits) return text[end] == '.' || ((text[end] == '-' || text[end] == '+') && text[end - 1] == 'e');
        return text[end] == ':';
      };
      while (end < text.size() && goes_on()) ++end;
      tokens.push_back(text.substr(at, end - at));
      at = end;
    } else {
      tokens.emplace_back(1, c);
      ++at;
    }
  }
  return tokens;
}

class Reader {
 public:
  Reader(std::string language, Scalar scalar, const std::string& text, const std::string& name, Arguments& arguments)
      : language_(std::move(language)), scalar_(scalar), arguments_(arguments) {
    const std::size_t start = text.find(" " + name + "(");
    if (start == std::string::npos) throw std::runtime_error(name + ": expected a function of this name, got none");
    tokens_ = tokens_of(text.substr(start));
    at_ = 2;
  }

  std::optional<double> run() {
    for (std::size_t i = 0; tokens_.at(at_ - 1) != ")"; ++i) parameter(i);
    if (arrays_.size() + scalars_.size() + unnamed_ != arguments_.size()) fail("as many parameters as arguments");
    while (!take("{")) ++at_;  // noexcept
    while (!take("}")) {
      if (take("return")) {
        const Number value = number(expression().value, scalar_);
        expect(";");
        return value.value;
      }
      statement();
    }
    return std::nullopt;
  }

 private:
  struct Array {
    std::vector<double>* elements;
    bool is_constant;
  };

  [[noreturn]] void fail(const std::string& expected) const {
    std::string got;
    for (std::size_t i = at_ > 4 ? at_ - 4 : 0; i < std::min(at_ + 4, tokens_.size()); ++i) got += tokens_[i] + " ";
    throw std::runtime_error(language_ + ": expected " + expected + ", got: " + got);
  }

  const std::string& peek() const { return tokens_.at(at_); }
  std::string next() { return tokens_.at(at_++); }
  bool take(const std::string& token) {
    if (peek() != token) return false;
    ++at_;
    return true;
  }
  void expect(const std::string& token) {
    if (!take(token)) fail(token);
  }

  std::size_t index() {
    expect("[");
    const std::size_t value = std::stoul(next());
    expect("]");
    return value;
  }

  std::optional<Scalar> type_at(const std::string& word) const {
    if ((word == "T" || word == "S") && language_ == "cpp") return scalar_;
    if (word == "float" && language_ != "cpp") return Scalar::kFloat;
    if (word == "double" && language_ != "cpp") return Scalar::kDouble;
    return std::nullopt;
  }

  // "T x", "T /*x*/", "const T* c", "const float c[9]", "out float result[9]": up to a comma or the bracket.
  void parameter(std::size_t position) {
    if (position >= arguments_.size()) fail("fewer parameters");
    std::vector<double>& argument = arguments_[position];
    bool is_constant = take("const");
    const bool writes = take("out") || take("inout");
    const std::optional<Scalar> type = type_at(next());
    if (!type) fail("a scalar type");
    for (double& value : argument) value = rounded(value, *type);
    const bool is_pointer = take("*");
    if (take("/")) {  // an unused parameter
      while (next() != "/") {
      }
      ++unnamed_;
    } else {
      const std::string name = next();
      if (peek() == "[" && index() != argument.size()) fail("an array of " + std::to_string(argument.size()));
      const bool is_array = is_pointer || tokens_[at_ - 1] == "]";
      if (language_ != "cpp" && language_ != "c99") is_constant = !writes;
      if (is_array) {
        arrays_[name] = {&argument, is_constant};
      } else {
        if (argument.size() != 1) fail("an array");
        scalars_[name] = number(argument[0], *type);
      }
    }
    if (!take(",")) expect(")");
  }

  void statement() {
    if (take("(")) {  // (void)x;
      expect("void");
      expect(")");
      next();
    } else if (take("const") || type_at(peek())) {
      const std::optional<Scalar> type = type_at(next());
      if (!type) fail("a scalar type");
      const std::string name = next();
      expect("=");
      const Number value = number(expression().value, *type);
      if (!scalars_.emplace(name, value).second) fail("a new name");
    } else {
      const auto array = arrays_.find(next());
      if (array == arrays_.end() || array->second.is_constant) fail("a statement");
      const std::size_t i = index();
      expect("=");
      array->second.elements->at(i) = number(expression().value, scalar_).value;
    }
    expect(";");
  }

  Number expression() {
    Number sum = term();
    while (peek() == "+" || peek() == "-") {
      const bool minus = next() == "-";
      const Number b = term();
      sum = number(minus ? sum.value - b.value : sum.value + b.value, wider(sum, b));
    }
    return sum;
  }

  Number term() {
    Number product = factor();
    while (peek() == "*" || peek() == "/") {
      const bool divides = next() == "/";
      const Number b = factor();
      product = number(divides ? product.value / b.value : product.value * b.value, wider(product, b));
    }
    return product;
  }

  Number factor() {
    if (take("-")) {
      const Number a = factor();
      return {-a.value, a.type};
    }
    if (take("(")) return bracket();
    const std::string word = next();
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) return literal(word);
    if (word == "detail::constant") return constant();
    if (word == "detail::choose") return choice();
    if (word == "T" && language_ == "cpp") {  // of an S, which lanes may share
      expect("(");
      const Number a = expression();
      expect(")");
      return number(a.value, scalar_);
    }
    if (word == "sqrt" || word == "sqrtf" || word == "detail::square_root") {
      for (const char* token : {"<", "T", ">"}) {
        if (word == "detail::square_root") expect(token);
      }
      expect("(");
      const Number a = expression();
      expect(")");
      return number(std::sqrt(a.value), word == "sqrtf" ? Scalar::kFloat : a.type);
    }
    if (const auto scalar = scalars_.find(word); scalar != scalars_.end()) return scalar->second;
    const auto array = arrays_.find(word);
    if (array == arrays_.end()) fail("a known name");
    return {array->second.elements->at(index()), scalar_};
  }

  // "a)", or "a < b ? c : d)"
  Number bracket() {
    const Number a = expression();
    if (take(")")) return a;
    expect("<");
    const bool less = a.value < expression().value;
    expect("?");
    return one_of(less, ":");
  }

  // "(a < b, c, d)"
  Number choice() {
    expect("(");
    const Number a = expression();
    expect("<");
    const bool less = a.value < expression().value;
    expect(",");
    return one_of(less, ",");
  }

  Number one_of(bool first, const std::string& between) {
    const Number a = expression();
    expect(between);
    const Number b = expression();
    expect(")");
    return first ? a : b;
  }

  // "<T>(0.5f, 0.5)"
  Number constant() {
    for (const char* token : {"<", "T", ">", "("}) expect(token);
    const bool minus_float = take("-");
    const Number in_float = literal(next());
    expect(",");
    const bool minus_double = take("-");
    const Number in_double = literal(next());
    expect(")");
    if (in_float.type != Scalar::kFloat || in_double.type != Scalar::kDouble) fail("a float and a double");
    return scalar_ == Scalar::kFloat ? number(minus_float ? -in_float.value : in_float.value, scalar_)
                                     : number(minus_double ? -in_double.value : in_double.value, scalar_);
  }

  Number literal(const std::string& word) {
    const std::size_t end = word.find_first_not_of("0123456789.e+-");
    const std::string suffix = end == std::string::npos ? "" : word.substr(end);
    if (word.find('.') == std::string::npos && word.find('e') == std::string::npos) fail("a number with a point");
    const bool is_c = language_ == "cpp" || language_ == "c99";
    const std::string of_double = is_c ? "" : language_ == "hlsl" ? "L" : "lf";
    const std::string of_float = is_c ? "f" : "";
    if (suffix != of_double && suffix != of_float) fail("a suffix of the language");
    return number(std::strtod(word.c_str(), nullptr), suffix == of_double ? Scalar::kDouble : Scalar::kFloat);
  }

  std::string language_;
  Scalar scalar_;
  Arguments& arguments_;
  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::map<std::string, Array> arrays_;
  std::map<std::string, Number> scalars_;
  std::size_t unnamed_ = 0;
};

}  // namespace

std::optional<double> run_printed(const std::string& language, Scalar scalar, const std::string& text,
                                  const std::string& name, Arguments& arguments) {
  return Reader(language, scalar, text, name, arguments).run();
}

}  // namespace sh::codegen::test
