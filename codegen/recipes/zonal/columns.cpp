#include "codegen/recipes/zonal/columns.hpp"

#include <array>
#include <string>

#include "symbolic/basis/basis.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

namespace {

// The exact coefficients of e_lm in powers of z^2, lowest power first.
std::vector<cln::cl_RA> coefficients(int l, int m) {
  const symbolic::Polynomial q = symbolic::reduced_basis_function(l, m).axial;
  std::vector<cln::cl_RA> result;
  for (int power = (l - m) % 2; power <= l - m; power += 2) {
    result.push_back(q.coefficient(symbolic::Monomial{0, 0, power}));
  }
  return result;
}

Surd ratio(int p, int q) { return Surd(cln::cl_RA(p) / q); }

}  // namespace

std::string indexed(const std::string& letter, int l, int m) {
  return letter + "_" + std::to_string(l) + "_" + std::to_string(m);
}

Surd turned_factor(int l, int m) {
  return symbolic::convolution_factor(l) * symbolic::reduced_basis_function(l, m).factor;
}

void label_coefficients(Kernel& kernel, int degree, int channels) {
  constexpr std::array<const char*, 3> kChannels{"red ", "green ", "blue "};
  for (int channel = 0; channel < channels; ++channel) {
    const std::string prefix = channels == 1 ? "" : kChannels[channel];
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        kernel.outputs.push_back({-1, prefix + "l=" + std::to_string(l) + " m=" + std::to_string(m)});
      }
    }
  }
}

std::pair<NodeId, NodeId> Azimuth::power(int m) {
  const auto found = powers_.find(m);
  if (found != powers_.end()) return found->second;
  const std::string suffix = std::to_string(m);
  return powers_[m] = m % 2 == 0 ? square(m / 2, suffix) : step(m, suffix);
}

std::pair<NodeId, NodeId> Azimuth::square(int half, const std::string& suffix) {
  const auto [c, s] = power(half);
  const NodeId sum = build_->add(c, s);
  const NodeId difference = build_->sub(c, s);
  const NodeId twice = build_->add(c, c);
  const NodeId real = build_->mul(difference, sum, "c" + suffix);
  const NodeId imaginary = build_->mul(twice, s, "s" + suffix);
  return {real, imaginary};
}

std::pair<NodeId, NodeId> Azimuth::step(int m, const std::string& suffix) {
  const auto [x, y] = power(1);
  const auto [c, s] = power(m - 1);
  const NodeId xc = build_->mul(x, c);
  const NodeId ys = build_->mul(y, s);
  const NodeId real = build_->sub(xc, ys, "c" + suffix);
  const NodeId xs = build_->mul(x, s);
  const NodeId yc = build_->mul(y, c);
  const NodeId imaginary = build_->add(xs, yc, "s" + suffix);
  return {real, imaginary};
}

NodeId AxialPolynomials::at(int l, int m) {
  const auto found = made_.find({l, m});
  if (found != made_.end()) return found->second;
  const NodeId node = make(l, m);
  made_[{l, m}] = node;
  return node;
}

NodeId AxialPolynomials::square() {
  if (square_ < 0) square_ = build_->mul(z_, z_, "z2");
  return square_;
}

NodeId AxialPolynomials::doubled_angle() {
  if (doubled_angle_ < 0) {
    const NodeId one = build_->constant(Surd(1), "one");
    const NodeId twice = build_->add(square(), square());
    doubled_angle_ = build_->sub(twice, one, "t");
  }
  return doubled_angle_;
}

NodeId AxialPolynomials::constant(const char* letter, const Surd& value, int l, int m) {
  return build_->constant(value, indexed(letter, l, m));
}

NodeId AxialPolynomials::make(int l, int m) {
  const int n = l - m;
  if (n <= 1) return constant("k", scale_(l, m) * Surd(coefficients(l, m)[0]), l, m);
  if (n <= 3 || wanted_ == Wanted::kFew) return horner(l, m);
  if (n == 4) return completed_square(l, m);
  const auto relative = [&](int other_l, int other_m) { return scale_(l, m) / scale_(other_l, other_m); };
  const Surd a = ratio(2 * l - 1, l - m) * relative(l - 1, m);
  const Surd b = ratio(l + m - 1, l - m) * relative(l - 2, m);
  NodeId previous = at(l - 1, m);
  if (n % 2 == 0) previous = build_->mul(square(), previous);
  return difference(a, previous, b, at(l - 2, m), l, m);
}

NodeId AxialPolynomials::horner(int l, int m) {
  const std::vector<cln::cl_RA> of_square = coefficients(l, m);
  // z^2 = (t + 1) / 2, t is variable 0.
  const symbolic::Polynomial half(cln::cl_RA(1) / 2);
  const symbolic::Polynomial square = half + half * symbolic::Polynomial::variable(0);
  symbolic::Polynomial sum;
  for (std::size_t k = 0; k < of_square.size(); ++k) sum += of_square[k] * square.power(static_cast<int>(k));
  NodeId value = -1;
  for (int k = sum.degree(); k >= 0; --k) {
    const Surd coefficient = scale_(l, m) * Surd(sum.coefficient(symbolic::Monomial{k}));
    const bool minus = value >= 0 && coefficient.is_negative();
    const NodeId a = constant(k == 0 ? "b" : "a", minus ? -coefficient : coefficient, l, m);
    if (value >= 0) value = build_->mul(value, doubled_angle());
    if (value < 0) {
      value = a;
    } else if (!coefficient.is_zero()) {
      value = minus ? build_->sub(value, a) : build_->add(value, a);
    }
  }
  build_->name(value, indexed("e", l, m));
  return value;
}

NodeId AxialPolynomials::completed_square(int l, int m) {
  const std::vector<cln::cl_RA> q = coefficients(l, m);
  const Surd inner = scale_(l, m + 1) * Surd(coefficients(l, m + 1)[1]);
  const NodeId a = constant("a", scale_(l, m) * Surd(q[2]) / (inner * inner), l, m);
  const Surd least = scale_(l, m) * Surd(q[0] - q[1] * q[1] / (4 * q[2]));
  const NodeId derivative = at(l, m + 1);
  const NodeId squared = build_->mul(build_->mul(a, derivative), derivative);
  const NodeId b = constant("b", least.is_negative() ? -least : least, l, m);
  const std::string name = indexed("e", l, m);
  return least.is_negative() ? build_->sub(squared, b, name) : build_->add(squared, b, name);
}

NodeId AxialPolynomials::difference(const Surd& a, NodeId v, const Surd& b, NodeId w, int l, int m) {
  const NodeId first = constant("a", a, l, m);
  const NodeId second = constant("b", b, l, m);
  const NodeId av = build_->mul(first, v);
  const NodeId bw = build_->mul(second, w);
  return build_->sub(av, bw, indexed("e", l, m));
}

}  // namespace sh::codegen::recipes
