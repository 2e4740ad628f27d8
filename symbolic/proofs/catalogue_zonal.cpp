#include "symbolic/proofs/catalogue.hpp"

namespace sh::symbolic {
namespace {

constexpr int kEmitted = 20;

const char* const kExponents = "exponents of the square of P_l stay below 128";
const char* const kBasis = "the basis is derived to degree 50";

std::vector<ZonalTerm> coefficients(const Formulas& f, const ZonalFamily& family, int degree) {
  return values_to(degree, [&](int l) { return f.zonal(family, l); });
}

std::vector<Proof> window_proofs(const SharedFormulas& f) {
  return {
      {"window-angles", "Hann and Lanczos: cos(l angle) and sin(l angle)",
       "the solution of C' = -l S, S' = l C, as polynomials in c and s", kEmitted, kMaxBasisDegree, kBasis, "degrees",
       [f](int degree) {
         return prove_window_angles(values_to(degree, f->window_hann), values_to(degree, f->window_lanczos_sine));
       }},
      {"window-gaussian", "w_(l+1) w_(l-1) = g^2 w_l^2, w_0 = 1, w_1 = g", "exponents compared", kEmitted,
       kMaxBasisDegree, kBasis, "degrees",
       [f](int degree) { return prove_window_gaussian(values_to(degree, f->window_gaussian_exponent)); }},
      {"window-laplacian", "the squared Laplacian multiplies Y_lm by the penalty",
       "derivatives of the reduced form, normal form modulo x^2+y^2+z^2 = 1", kEmitted, kEmitted, kBasis, "functions",
       [f](int degree) {
         return prove_window_laplacian(values_to(degree, f->window_laplacian_penalty), derive_basis(degree));
       }},
  };
}

}  // namespace

std::vector<Proof> zonal_catalogue(const SharedFormulas& f) {
  std::vector<Proof> proofs;
  for (const ZonalFamily& family : zonal_families()) {
    proofs.push_back(
        {"zonal-" + family.name,
         "GiNaC's definition z_l = sqrt((2l+1) pi) integral f(t) P_l(t) dt, f = " + family.function + ", = closed form",
         "two derivations compared as functions of the parameters", kEmitted, kMaxZonalDegree, kExponents,
         "coefficients",
         [f, &family](int degree) { return prove_zonal_family(family, coefficients(*f, family, degree)); }});
  }
  const std::vector<Proof> others{
      {"cap-complement", "cap + complement = 1", "coefficients as polynomials in c", kEmitted, kMaxZonalDegree,
       kExponents, "bands",
       [f](int degree) {
         return prove_cap_complement(coefficients(*f, zonal_family("cap"), degree),
                                     coefficients(*f, zonal_family("cap-complement"), degree));
       }},
      {"irradiance-factors", "GiNaC's definition A_l = 2 pi integral_0^1 t P_l(t) dt = closed form",
       "two derivations compared", kEmitted, kMaxIrradianceDegree, "exponents stay below 128", "factors",
       [f](int degree) {
         return prove_irradiance_factors(values_to(degree, f->irradiance_factor),
                                         values_to(degree, f->irradiance_factor_integral));
       }},
      {"irradiance-convolution", "A_l = sqrt(4 pi / (2l+1)) z_l of the clamped cosine; A_l / pi is folded in",
       "exact products", kEmitted, kMaxZonalDegree, kExponents, "factors",
       [f](int degree) {
         return prove_irradiance_convolution(
             values_to(degree, f->irradiance_factor), values_to(degree, f->convolution_factor),
             coefficients(*f, zonal_family("clamped-cosine"), degree), f->folded_factor);
       }},
      {"convolution-theorem", "integral Y_lm(s) h(s.n) ds = sqrt(4 pi / (2l+1)) h_l Y_lm(n), h = t^k",
       "multinomial expansion, integrated term by term", kEmitted, kEmitted,
       "every power of s.n is expanded for every function", "pairs of a function and a power of s.n",
       [f](int degree) { return prove_convolution(values_to(degree, f->convolution_factor)); }},
      {"turned-zonal", "sum_m sqrt(4 pi / (2l+1)) Y_lm(d) Y_lm(s) = Y_l0(d.s)", "identity of polynomials in (d, s)",
       kEmitted, kEmitted, "the identity in two points has a number of terms that grows with the fourth power", "bands",
       [f](int degree) { return prove_turned_zonal(f->turned_zonal(degree)); }},
  };
  proofs.insert(proofs.end(), others.begin(), others.end());
  for (const Proof& proof : window_proofs(f)) proofs.push_back(proof);
  return proofs;
}

}  // namespace sh::symbolic
