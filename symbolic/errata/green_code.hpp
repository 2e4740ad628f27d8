// The code fragments of [Green03] up to the projection, as arithmetic over any exact number type T.
//
// Each function follows the printed statements in their order; what the fragment takes from elsewhere (random numbers,
// the factorial) is an argument. Angles are pairs of cosine and sine. T(rational), + - * and root(T) are all it needs.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/errata/green_exact.hpp"

namespace sh::symbolic::errata::green_code {

using exact::cos;
using exact::root;
using exact::sin;
using exact::operator*;

template <class T>
T number(int n) {
  return T(cln::cl_RA(n));
}

/// double P(int l, int m, double x)
template <class T>
T p(int l, int m, const T& x) {
  T pmm = number<T>(1);
  if (m > 0) {
    const T somx2 = root((number<T>(1) - x) * (number<T>(1) + x));
    T fact = number<T>(1);
    for (int i = 1; i <= m; ++i) {
      pmm = pmm * (number<T>(-1) * fact) * somx2;
      fact = fact + number<T>(2);
    }
  }
  if (l == m) return pmm;
  T pmmp1 = x * number<T>(2 * m + 1) * pmm;
  if (l == m + 1) return pmmp1;
  T pll = T();
  for (int ll = m + 2; ll <= l; ++ll) {
    pll = (number<T>(2 * ll - 1) * x * pmmp1 - number<T>(ll + m - 1) * pmm) * T(cln::cl_RA(1) / (ll - m));
    pmm = pmmp1;
    pmmp1 = pll;
  }
  return pll;
}

/// double K(int l, int m)
inline Surd k(int l, int m, const std::function<cln::cl_RA(int)>& factorial = exact::factorial) {
  return Surd::square_root((2 * l + 1) * factorial(l - m) / (4 * factorial(l + m)), -1);
}

/// double SH(int l, int m, double theta, double phi)
template <class T>
exact::Scaled<T> sh(int l, int m, const CosSin<T>& theta, const CosSin<T>& phi) {
  const Surd sqrt2 = Surd::square_root(2);
  if (m == 0) return {k(l, 0), p(l, 0, cos(theta))};
  if (m > 0) return {sqrt2 * k(l, m), cos(m * phi) * p(l, m, cos(theta))};
  return {sqrt2 * k(l, -m), sin(-m * phi) * p(l, -m, cos(theta))};
}

/// struct SHSample, with both angles as pairs and a place for every coefficient that is written.
struct Sample {
  CosSin<RadicalSum> theta;
  CosSin<RadicalSum> phi;
  std::vector<RadicalSum> vec;
  std::vector<RadicalSum> coeff;
  std::vector<int> writes;  ///< how often each coefficient was written
};

/// void SH_setup_spherical_samples(SHSample samples[], int sqrt_n_samples). `random` gives rationals in [0, 1), `turns`
/// the angle 2 pi y.
inline std::vector<Sample> setup_spherical_samples(int sqrt_n_samples, int n_bands,
                                                   const std::function<cln::cl_RA()>& random,
                                                   const std::function<CosSin<RadicalSum>(cln::cl_RA)>& turns) {
  std::vector<Sample> samples;
  const cln::cl_RA one_over_n = cln::cl_RA(1) / sqrt_n_samples;
  for (int a = 0; a < sqrt_n_samples; ++a) {
    for (int b = 0; b < sqrt_n_samples; ++b) {
      const cln::cl_RA x = (a + random()) * one_over_n;
      const cln::cl_RA y = (b + random()) * one_over_n;
      // acos(sqrt(1 - x)) lies in [0, pi/2]: its sine is sqrt(x)
      const CosSin<RadicalSum> arc{root(RadicalSum(1 - x)), root(RadicalSum(x))};
      Sample sample;
      sample.theta = 2 * arc;
      sample.phi = turns(y);
      sample.vec = {sin(sample.theta) * cos(sample.phi), sin(sample.theta) * sin(sample.phi), cos(sample.theta)};
      sample.coeff.resize(to_size(n_bands * n_bands));
      sample.writes.resize(to_size(n_bands * n_bands));
      for (int l = 0; l < n_bands; ++l) {
        for (int m = -l; m <= l; ++m) {
          const int index = l * (l + 1) + m;
          const auto value = sh(l, m, sample.theta, sample.phi);
          sample.coeff.at(to_size(index)) = RadicalSum(value.factor) * value.value;
          ++sample.writes.at(to_size(index));
        }
      }
      samples.push_back(std::move(sample));
    }
  }
  return samples;
}

/// void SH_project_polar_function(SH_polar_fn fn, const SHSample samples[], double result[]), result as it arrives.
inline std::vector<RadicalSum> project_polar_function(
    const std::function<RadicalSum(const CosSin<RadicalSum>&, const CosSin<RadicalSum>&)>& fn,
    const std::vector<Sample>& samples, std::vector<RadicalSum> result) {
  const RadicalSum weight(Surd::square_root(16, 2));
  for (const Sample& sample : samples) {
    for (std::size_t n = 0; n < result.size(); ++n) result[n] += fn(sample.theta, sample.phi) * sample.coeff.at(n);
  }
  const RadicalSum factor = weight * RadicalSum(cln::recip(cln::cl_RA(static_cast<int>(samples.size()))));
  for (RadicalSum& value : result) value = value * factor;
  return result;
}

}  // namespace sh::symbolic::errata::green_code
