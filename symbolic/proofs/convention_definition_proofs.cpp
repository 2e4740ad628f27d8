// Proofs of the functions of a convention by what defines them.
#include <cstdlib>
#include <optional>

#include "symbolic/convention/convention.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

std::string name_of(int degree, int order) { return "l=" + std::to_string(degree) + " m=" + std::to_string(order); }

void require(bool holds, int degree, int order, const char* otherwise) {
  if (!holds) throw Refuted(name_of(degree, order) + ": " + otherwise);
}

// d/dphi
Polynomial azimuthal_derivative(const Polynomial& p) {
  return Polynomial::variable(0) * p.derivative(1) - Polynomial::variable(1) * p.derivative(0);
}

bool is_solid(const Polynomial& p, int degree) {
  Polynomial laplacian;
  for (int axis = 0; axis < 3; ++axis) laplacian += p.derivative(axis).derivative(axis);
  return p.is_homogeneous() && p.degree() == degree && laplacian.is_zero();
}

// Even in y if `even`, otherwise odd.
bool has_parity(const Polynomial& p, bool even) {
  for (const auto& [monomial, coefficient] : p.terms()) {
    if ((monomial.exponent(1) % 2 == 0) != even) return false;
  }
  return true;
}

// The polynomials of one order: solid harmonics of exp(i m phi), or of cos m phi and sin |m| phi.
void require_shape(const Convention& c, const Polynomial& re, const Polynomial& im, int degree, int order) {
  require(is_solid(re, degree), degree, order, "no solid harmonic of degree l");
  if (c.complex) {
    require(azimuthal_derivative(re) == cln::cl_RA(-order) * im && azimuthal_derivative(im) == cln::cl_RA(order) * re,
            degree, order, "does not belong to exp(i m phi)");
    return;
  }
  require(im.is_zero() && has_parity(re, order >= 0) &&
              azimuthal_derivative(azimuthal_derivative(re)) == cln::cl_RA(-order * order) * re,
          degree, order, "does not belong to cos m phi or sin |m| phi");
}

cln::cl_RA mean_square(const Polynomial& p) {
  cln::cl_RA sum = 0;
  for (const auto& [left, a] : p.terms()) {
    for (const auto& [right, b] : p.terms()) {
      const cln::cl_RA& mean = sphere_mean(left * right);
      if (!cln::zerop(mean)) sum = sum + a * b * mean;
    }
  }
  return sum;
}

// The integral of |Y'|^2 over the sphere where the normalization fixes it.
std::optional<Surd> defined_integral(Normalization normalization, int degree) {
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  const Surd inverse(cln::cl_RA(1) / (2 * degree + 1));
  switch (normalization) {
    case Normalization::kOrthonormal:
      return Surd(1);
    case Normalization::kFourPi:
      return sphere_area;
    case Normalization::kSchmidt:
      return sphere_area * inverse;
    case Normalization::kSn3d:
      return inverse;
    case Normalization::kUnnormalized:
    case Normalization::kPrimitive:
    case Normalization::kFuMa:
      return std::nullopt;
  }
  return std::nullopt;
}

// d^a P_l / dz^a
Polynomial axial_part(int degree, int a) {
  Polynomial q = legendre_polynomial(degree, 2);
  for (int i = 0; i < a; ++i) q = q.derivative(2);
  return q;
}

// The number by which q(z) Re or Im (x + iy)^a is the function: both are compared near the north pole at a small phi.
Surd multiple_of_ferrers(const ConventionFunction& f, const Convention& c, int degree, int order) {
  const int a = std::abs(order);
  const bool sine = order < 0 && !c.complex;
  const Monomial first{sine ? a - 1 : a, sine ? 1 : 0, degree - a};
  const std::array<cln::cl_RA, 3> pole{0, 0, 1};
  const cln::cl_RA expected = (sine ? a : 1) * axial_part(degree, a).evaluate(pole);
  return f.factor * Surd(f.re.coefficient(first) / expected);
}

// The largest square of q(z) (1 - z^2)^(a/2), at z^2 = u. It is stationary there, or u is an end of 0..1.
cln::cl_RA largest_square(const Polynomial& q, int a, const cln::cl_RA& u, int degree, int order) {
  const auto square = [&, squared = q * q](const cln::cl_RA& at) {
    cln::cl_RA sum = 0;
    for (const auto& [monomial, coefficient] : squared.terms())
      sum = sum + coefficient * cln::expt(at, monomial.exponent(2) / 2);
    return sum * cln::expt(1 - at, a);
  };
  const cln::cl_RA largest = square(u);
  constexpr int kSteps = 64;  // the square is a polynomial of degree 3 at most
  for (int i = 0; i <= kSteps; ++i)
    require(square(cln::cl_RA(i) / kSteps) <= largest, degree, order, "is larger somewhere else");
  return largest;
}

// Furse-Malham: the largest value is 1, of W 1/sqrt 2.
void require_largest_value(const Surd& multiple, int degree, int order) {
  const cln::cl_RA places[][4] = {
      {1}, {1, 0}, {1, cln::cl_RA(1) / 2, 0}, {1, cln::cl_RA(11) / 15, cln::cl_RA(1) / 3, 0}};
  const int a = std::abs(order);
  const cln::cl_RA square = largest_square(axial_part(degree, a), a, places[degree][a], degree, order);
  require(multiple * multiple * Surd(square) == Surd(degree == 0 ? cln::cl_RA(1) / 2 : cln::cl_RA(1)), degree, order,
          "its largest value is not that of the format");
}

bool is_negative_phase(const Convention& c, int order) {
  return c.condon_shortley && order % 2 != 0 && (order > 0 || !c.complex);
}

void require_size_and_sign(const Convention& c, const ConventionFunction& f, const cln::cl_RA& mean, int degree,
                           int order) {
  const Surd multiple = multiple_of_ferrers(f, c, degree, order);
  require(multiple.is_negative() == is_negative_phase(c, order), degree, order, "has another sign");
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  if (const auto integral = defined_integral(c.normalization, degree)) {
    require(f.factor * f.factor * Surd(mean) * sphere_area == *integral, degree, order,
            "the integral of its square is not that of the normalization");
  } else if (c.normalization == Normalization::kFuMa) {
    require_largest_value(multiple, degree, order);
  } else if (c.normalization == Normalization::kUnnormalized) {
    require(multiple * multiple == Surd(1), degree, order, "is not P_l^|m| cos or sin");
  } else {
    const Polynomial reduced = axial_part(degree, std::abs(order)) * reduced_basis_function(degree, order).azimuthal;
    require(multiple.is_rational() && content(multiple.rational() * reduced) == 1, degree, order,
            "its coefficients are no integers without a common factor");
  }
}

}  // namespace

int prove_definitions(const std::vector<Convention>& conventions, int degree, const WrittenFunction& function) {
  struct Shape {
    bool complex = false;
    Polynomial re;
    Polynomial im;
    cln::cl_RA mean;  // of re^2 + im^2
  };
  for (int m = -degree; m <= degree; ++m) {
    std::vector<Shape> known;
    for (const Convention& c : conventions) {
      const ConventionFunction f = function(c, degree, m);
      const Shape* shape = nullptr;
      for (const Shape& other : known) {
        if (other.complex == c.complex && other.re == f.re && other.im == f.im) shape = &other;
      }
      if (shape == nullptr) {
        require_shape(c, f.re, f.im, degree, m);
        known.push_back({c.complex, f.re, f.im, mean_square(f.re) + mean_square(f.im)});
        shape = &known.back();
      }
      require_size_and_sign(c, f, shape->mean, degree, m);
    }
  }
  return static_cast<int>(conventions.size()) * (2 * degree + 1);
}

}  // namespace sh::symbolic
