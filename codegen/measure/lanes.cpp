#include "codegen/measure/lanes.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "codegen/ir/literal.hpp"
#include "codegen/measure/half.hpp"

namespace sh::codegen {
namespace {

double rounded_to(double x, float /*type*/) { return static_cast<double>(static_cast<float>(x)); }

// The nearest half, ties to even: the sum with a number whose last place is that of a half of this size.
double rounded_to(double x, Half /*type*/) {
  constexpr std::uint64_t kExponentBits = 0x7ff0000000000000ULL;
  const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & kExponentBits);
  const double shift = 0x1.8p42 * std::max(power, 0x1p-14);
  const double nearest = (x + shift) - shift;
  return std::abs(nearest) <= 65504 ? nearest : std::numeric_limits<double>::infinity();
}

// A result and the rounding that it holds: value - exact result of the operation.
struct Rounded {
  double value, rounding;
};

// In double, an operation on numbers of float or half loses nothing that matters beside their roundings.
template <class T>
struct Operations {
  static Rounded rounded(double exact) {
    const double value = rounded_to(exact, T());
    return {value, value - exact};
  }
  static Rounded sum(double a, double b) { return rounded(a + b); }
  static Rounded product(double a, double b) { return rounded(a * b); }
  static Rounded quotient(double a, double b) { return rounded(a / b); }
  static Rounded root(double a) { return rounded(std::sqrt(a)); }
};

template <>
struct Operations<double> {
  static Rounded sum(double a, double b) {
    const double s = a + b, part = s - a;
    return {s, -((a - (s - part)) + (b - part))};
  }
  static Rounded product(double a, double b) {
    constexpr double kSplit = 0x1p27 + 1;
    const double p = a * b;
    const double ca = kSplit * a, cb = kSplit * b;
    const double a1 = ca - (ca - a), b1 = cb - (cb - b);
    const double a2 = a - a1, b2 = b - b1;
    return {p, ((p - a1 * b1) - a1 * b2 - a2 * b1) - a2 * b2};
  }
  static Rounded quotient(double a, double b) {
    const double q = a / b;
    const Rounded back = product(q, b);
    return {q, ((back.value - a) - back.rounding) / b};
  }
  static Rounded root(double a) {
    const double s = std::sqrt(a);
    if (s == 0) return {0, 0};
    const Rounded back = product(s, s);
    return {s, ((back.value - a) - back.rounding) / (2 * s)};
  }
};

}  // namespace

template <class T>
ErrorLanes<T>::ErrorLanes(const Kernel& kernel, const bound::Format& format)
    : kernel_(kernel), values_(kernel.nodes.size(), Lanes{}), errors_(kernel.nodes.size(), Lanes{}) {
  for (std::size_t id = 0; id < kernel.nodes.size(); ++id) {
    const Op op = kernel.nodes[id].op;
    if (op == Op::kFma || op == Op::kTable || op == Op::kRowSum) {
      throw std::logic_error("lanes: " + kernel.name + " has the operation " + op_name(op));
    }
    if (op != Op::kConstant) continue;
    const auto literal =
        nearest<std::conditional_t<std::is_same_v<T, float>, float, double>>(kernel.nodes[id].constant);
    values_[id].fill(static_cast<double>(static_cast<T>(literal)));
    errors_[id].fill(bound::rounded(kernel.nodes[id].constant, format).error.low);
  }
}

template <class T>
void ErrorLanes<T>::operator()(const std::vector<Lanes>& inputs) {
  using Of = Operations<T>;
  for (std::size_t id = 0; id < values_.size(); ++id) {
    const Node& node = kernel_.nodes[id];
    const auto argument = [&](int i) { return node.args[i] < 0 ? id : static_cast<std::size_t>(node.args[i]); };
    const Lanes& a = values_[argument(0)];
    const Lanes& b = values_[argument(1)];
    const Lanes& of_a = errors_[argument(0)];
    const Lanes& of_b = errors_[argument(1)];
    Lanes value, error;
    const auto each = [&](const auto& operation) {
      for (int i = 0; i < kLanes; ++i) operation(i);
      values_[id] = value;
      errors_[id] = error;
    };
    const auto set = [&](int i, Rounded result, double passed) {
      value[i] = result.value;
      error[i] = passed + result.rounding;
    };
    switch (node.op) {
      case Op::kInput:
        values_[id] = inputs[node.input];
        break;
      case Op::kNeg:
        each([&](int i) { set(i, {-a[i], 0}, -of_a[i]); });
        break;
      case Op::kAdd:
        each([&](int i) { set(i, Of::sum(a[i], b[i]), of_a[i] + of_b[i]); });
        break;
      case Op::kSub:
        each([&](int i) { set(i, Of::sum(a[i], -b[i]), of_a[i] - of_b[i]); });
        break;
      case Op::kMul:
        each([&](int i) { set(i, Of::product(a[i], b[i]), a[i] * of_b[i] + (b[i] - of_b[i]) * of_a[i]); });
        break;
      case Op::kDiv:
        each([&](int i) {
          const Rounded result = Of::quotient(a[i], b[i]);
          set(i, result, (of_a[i] - (result.value - result.rounding) * of_b[i]) / (b[i] - of_b[i]));
        });
        break;
      case Op::kSqrt:
        each([&](int i) {
          const Rounded result = Of::root(a[i]);
          const double sum = result.value + std::sqrt(a[i] - of_a[i]);
          set(i, result, sum > 0 ? of_a[i] / sum : 0);
        });
        break;
      case Op::kSelect:
        each([&](int i) {
          const NodeId chosen = node.args[a[i] < b[i] ? 2 : 3];
          set(i, {values_[chosen][i], 0}, errors_[chosen][i]);
        });
        break;
      default:
        break;
    }
  }
}

template <class T>
double ErrorLanes<T>::error(std::size_t output, int lane) const {
  return std::abs(errors_[kernel_.outputs[output].node][lane]);
}

template class ErrorLanes<float>;
template class ErrorLanes<double>;
template class ErrorLanes<Half>;

}  // namespace sh::codegen
