#include "codegen/families/product_reference.hpp"

#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include "codegen/measure/domains.hpp"

namespace sh::codegen {
namespace {

using symbolic::BilinearForm;
using symbolic::ProductShape;

constexpr unsigned long kSeed = 20060501;

// The sum of factor_i * a_i * b_j. Surds are grouped by their radical, so that nearly all operations are rational.
cln::cl_F value(const BilinearForm& form, std::span<const cln::cl_RA> a, std::span<const cln::cl_RA> b) {
  std::map<Surd, cln::cl_RA> sums;
  for (const symbolic::BilinearTerm& term : form.terms) {
    const Surd radical = Surd(cln::recip(term.factor.rational())) * term.factor;
    cln::cl_RA& sum = sums.try_emplace(radical, 0).first->second;
    sum = sum + term.factor.rational() * a[term.i] * b[term.j];
  }
  cln::cl_F total = precise(0);
  for (const auto& [radical, sum] : sums) total = total + precise(radical * Surd(sum));
  return total;
}

const std::vector<BilinearForm>& forms_of(const ProductShape& shape) {
  static std::map<std::tuple<int, int, int>, std::vector<BilinearForm>> known;
  const auto [position, added] = known.try_emplace({shape.a, shape.b, shape.result});
  if (added) position->second = symbolic::product_form(shape);
  return position->second;
}

std::vector<cln::cl_F> values(const std::vector<BilinearForm>& forms, std::span<const cln::cl_RA> a,
                              std::span<const cln::cl_RA> b) {
  std::vector<cln::cl_F> result;
  for (const BilinearForm& form : forms) result.push_back(value(form, a, b));
  return result;
}

// Products of the first `left` numbers of a point and the others.
Reference bilinear_reference(const std::vector<BilinearForm>& forms, int left, int right, int points) {
  return reference_at(rational_vectors(points, left + right, kSeed), [&](const Rationals& point) {
    return values(forms, std::span(point).first(left), std::span(point).last(right));
  });
}

// Unit vectors, one after the other: random vectors, single coefficients, and equal random vectors.
Inputs unit_factors(const std::vector<int>& sizes) {
  constexpr int kRandom = 80;
  constexpr int kSingle = 20;
  constexpr int kEqual = 20;
  Inputs inputs(kRandom + kSingle + kEqual);
  std::mt19937_64 random(kSeed);
  for (std::size_t f = 0; f < sizes.size(); ++f) {
    Inputs factors = unit_vectors(kRandom, sizes[f], kSeed + f);
    for (int i = 0; i < kSingle; ++i) factors.emplace_back(sizes[f], 0.0)[random() % sizes[f]] = 1;
    const Inputs equal = unit_vectors(kEqual, sizes[f], kSeed + sizes.size());
    factors.insert(factors.end(), equal.begin(), equal.end());
    inputs = joined(std::move(inputs), factors);
  }
  return inputs;
}

}  // namespace

Reference product_reference(const ProductShape& shape, int points) {
  return bilinear_reference(forms_of(shape), coefficient_count(shape.a), coefficient_count(shape.b), points);
}

Reference square_reference(int degree, int points) {
  return reference_at(rational_vectors(points, coefficient_count(degree), kSeed), [degree](const Rationals& a) {
    return values(forms_of({degree, degree, degree}), a, a);
  });
}

Reference product_zonal_reference(int degree, int points) {
  return bilinear_reference(symbolic::zonal_product_form({degree, degree, degree}), coefficient_count(degree),
                            degree + 1, points);
}

Reference triple_reference(int degree, int points) {
  const int count = coefficient_count(degree);
  return reference_at(rational_vectors(points, 3 * count, kSeed), [=](const Rationals& point) {
    const std::span all(point);
    const auto ab = values(forms_of({degree, degree, degree}), all.first(count), all.subspan(count, count));
    cln::cl_F integral = precise(0);
    for (int i = 0; i < count; ++i) integral = integral + ab[i] * precise(point[2 * count + i]);
    return std::vector{integral};
  });
}

Domain factor_domain(const FactorSizes& sizes, const std::string& unit) {
  return {.inputs = "sets of unit vectors of coefficients (random, single coefficients, equal)",
          .unit = unit,
          .test_inputs = [sizes](int degree) { return unit_factors(sizes(degree)); },
          .sizes = {unit}};
}

}  // namespace sh::codegen
