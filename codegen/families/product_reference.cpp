#include "codegen/families/product_reference.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <tuple>

#include "codegen/measure/domains.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::codegen {
namespace {

using symbolic::BilinearForm;
using symbolic::BilinearTerm;
using symbolic::ProductShape;

constexpr int kGuardDigits = 15;
constexpr unsigned long kSeed = 20060501;

using numeric::coefficient_count;

// The sum of factor_i * a_i * b_j. Surds are grouped by their radical, so that nearly all operations are rational.
cln::cl_F value(const BilinearForm& form, const std::vector<cln::cl_RA>& a, const std::vector<cln::cl_RA>& b) {
  std::map<symbolic::Surd, cln::cl_RA> sums;
  for (const BilinearTerm& term : form.terms) {
    const symbolic::Surd radical = symbolic::Surd(cln::recip(term.factor.rational())) * term.factor;
    cln::cl_RA& sum = sums.try_emplace(radical, 0).first->second;
    sum = sum + term.factor.rational() * a[term.i] * b[term.j];
  }
  const cln::float_format_t format = cln::float_format(kCheckDigits + kGuardDigits);
  cln::cl_F total = cln::cl_float(0, format);
  for (const auto& [radical, sum] : sums) {
    total = total + radical.evaluate(kCheckDigits + kGuardDigits) * cln::cl_float(sum, format);
  }
  return total;
}

const std::vector<BilinearForm>& forms_of(const ProductShape& shape) {
  static std::map<std::tuple<int, int, int>, std::vector<BilinearForm>> known;
  const auto [position, added] = known.try_emplace({shape.a, shape.b, shape.result});
  if (added) position->second = symbolic::product_form(shape);
  return position->second;
}

std::vector<cln::cl_F> values(const std::vector<BilinearForm>& forms, const std::vector<cln::cl_RA>& a,
                              const std::vector<cln::cl_RA>& b) {
  std::vector<cln::cl_F> result;
  for (const BilinearForm& form : forms) result.push_back(value(form, a, b));
  return result;
}

// The parts of a flat vector.
template <class Vector>
std::vector<Vector> split(const Vector& flat, const std::vector<int>& sizes) {
  std::vector<Vector> parts;
  auto begin = flat.begin();
  for (const int size : sizes) {
    parts.emplace_back(begin, begin + size);
    begin += size;
  }
  return parts;
}

int total_of(const std::vector<int>& sizes) { return std::accumulate(sizes.begin(), sizes.end(), 0); }

// Unit vectors, one after the other: random vectors, single coefficients, and equal random vectors.
std::vector<std::vector<double>> unit_factors(const std::vector<int>& sizes) {
  constexpr int kRandom = 80;
  constexpr int kSingle = 20;
  constexpr int kEqual = 20;
  std::vector<std::vector<double>> inputs(kRandom + kSingle + kEqual);
  std::mt19937_64 random(kSeed);
  for (std::size_t f = 0; f < sizes.size(); ++f) {
    const auto vectors = unit_vectors(kRandom, sizes[f], kSeed + f);
    const auto equal = unit_vectors(kEqual, sizes[f], kSeed + sizes.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      std::vector<double> factor(sizes[f]);
      if (i < kRandom) {
        factor = vectors[i];
      } else if (i < kRandom + kSingle) {
        factor[random() % factor.size()] = 1;
      } else {
        factor = equal[i - kRandom - kSingle];
      }
      inputs[i].insert(inputs[i].end(), factor.begin(), factor.end());
    }
  }
  return inputs;
}

}  // namespace

Reference product_reference(const ProductShape& shape, int count) {
  Reference reference;
  const std::vector<int> sizes{coefficient_count(shape.a), coefficient_count(shape.b)};
  for (const auto& point : rational_vectors(count, total_of(sizes), kSeed)) {
    const auto factors = split(point, sizes);
    reference.push_back({point, values(forms_of(shape), factors[0], factors[1])});
  }
  return reference;
}

Reference square_reference(int degree, int count) {
  Reference reference;
  for (const auto& a : rational_vectors(count, coefficient_count(degree), kSeed)) {
    reference.push_back({a, values(forms_of({degree, degree, degree}), a, a)});
  }
  return reference;
}

Reference product_zonal_reference(int degree, int count) {
  const auto forms = symbolic::zonal_product_form({degree, degree, degree});
  const std::vector<int> sizes{coefficient_count(degree), degree + 1};
  Reference reference;
  for (const auto& point : rational_vectors(count, total_of(sizes), kSeed)) {
    const auto factors = split(point, sizes);
    reference.push_back({point, values(forms, factors[0], factors[1])});
  }
  return reference;
}

Reference triple_reference(int degree, int count) {
  const std::vector<int> sizes(3, coefficient_count(degree));
  Reference reference;
  for (const auto& point : rational_vectors(count, total_of(sizes), kSeed)) {
    const auto factors = split(point, sizes);
    const std::vector<cln::cl_F> ab = values(forms_of({degree, degree, degree}), factors[0], factors[1]);
    cln::cl_F integral = cln::cl_float(0, ab[0]);
    for (std::size_t i = 0; i < ab.size(); ++i) integral = integral + ab[i] * cln::cl_float(factors[2][i], ab[i]);
    reference.push_back({point, {integral}});
  }
  return reference;
}

Domain factor_domain(const FactorSizes& sizes, const std::string& unit) {
  Domain domain;
  domain.inputs = "sets of unit vectors of coefficients (random, single coefficients, equal)";
  domain.unit = unit;
  domain.test_inputs = [sizes](int degree) { return unit_factors(sizes(degree)); };
  domain.sizes = {unit};
  return domain;
}

}  // namespace sh::codegen
