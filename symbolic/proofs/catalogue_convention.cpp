#include <algorithm>

#include "symbolic/convention/convention.hpp"
#include "symbolic/proofs/catalogue.hpp"

namespace sh::symbolic {
namespace {

const char* const kBands = "exact band matrices are kept to degree 20";
const char* const kSlowBands = "exact products of band matrices for every convention take minutes beyond";

// The sum of prove(convention, top) over the samples, at low degrees and at this one: some serve degree 2 or 3 only.
template <class Prove>
int for_each_of(std::vector<Convention> (*samples)(int degree), int degree, const Prove& prove) {
  int count = 0;
  for (const int top : {std::min(degree, 2), std::min(degree, 3), degree}) {
    for (const Convention& convention : samples(top)) count += prove(convention, top);
  }
  return count;
}

int prove_every_definition(const Formulas& f, int degree) {
  const WrittenFunction written = [&f](const Convention& c, int l, int m) {
    ConventionFunction function = f.convention_function(c, l, m);
    if (!(function.factor == f.convention_factor(c, l, m))) {
      throw Refuted("l=" + std::to_string(l) + " m=" + std::to_string(m) + ": the factor is not that of the function");
    }
    return function;
  };
  return for_each_band(degree, [&](int l) { return prove_definitions(unturned_conventions(l), l, written); });
}

int prove_every_same_function(const Formulas& f, std::vector<Convention> (*samples)(int degree), int degree) {
  return for_each_of(samples, degree, [&](const Convention& convention, int top) {
    return prove_same_function(convention, f.convention_map({}, convention, top));
  });
}

int prove_basis_changes(const Formulas& f, int degree) {
  return for_each_of(sample_conventions, degree, [&](const Convention& convention, int top) {
    for_each_band(top, [&](int l) {
      return prove_basis_change(convention, l, f.basis_change(convention, l), f.basis_change_inverse(convention, l));
    });
    return 1;
  });
}

int prove_round_trips(const Formulas& f, int degree) {
  return for_each_of(sample_conventions, degree, [&](const Convention& convention, int top) {
    return prove_there_and_back(f.convention_map({}, convention, top), f.convention_map(convention, {}, top));
  });
}

// Each sample by way of the next one.
int prove_compositions(const Formulas& f, int degree) {
  const std::vector<Convention> samples = sample_conventions(degree);
  int count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Convention& middle = samples[i];
    const Convention& end = samples[(i + 1) % samples.size()];
    count += prove_through(f.convention_map({}, middle, degree), f.convention_map(middle, end, degree),
                           f.convention_map({}, end, degree));
  }
  return count;
}

std::vector<Proof> meaning_proofs(const SharedFormulas& f) {
  return {
      {"convention-definitions",
       "Y'_lm is harmonic, belongs to its order, has the integral of its normalization and the sign of its phase",
       "exact derivatives and integrals; every normalization, phase, real and complex, every preset",
       kMaxConventionDegree, kMaxConventionDegree, kBands, "functions",
       [f](int degree) { return prove_every_definition(*f, degree); }},
      {"convention-coefficients", "sum c' Y' = sum c Y for c' = C c, its convolution where a cosine is folded in",
       "polynomial identities; every normalization, phase, real and complex, every preset", kMaxConventionDegree,
       kMaxConventionDegree, kBands, "conventions",
       [f](int degree) { return prove_every_same_function(*f, unturned_conventions, degree); }},
      {"convention-axes", "sum c' Y'(P s) = sum c Y(s) for c' = C c with other axes P",
       "polynomial identities; every preset in its world and others", 10, 10, kSlowBands, "conventions",
       [f](int degree) { return prove_every_same_function(*f, sample_conventions, degree); }},
      {"index-orders", "the places of an array count up in the order of its functions", "every place, holes included",
       kMaxConventionDegree, kMaxConventionDegree, kBands, "arrays",
       [f](int degree) {
         return prove_index_orders(degree, {f->storage_size, f->storage_position});
       }},
  };
}

}  // namespace

std::vector<Proof> convention_catalogue(const SharedFormulas& f) {
  std::vector<Proof> proofs{
      {"complex-unitary", "Y_real = W Y_complex, W W* = 1, with and without the Condon-Shortley phase",
       "polynomial identities, exact products", kMaxConventionDegree, kMaxConventionDegree, kBands, "matrices",
       [f](int degree) {
         return for_each_band(degree, [&](int l) {
           return prove_unitary(f->real_from_complex(l, false), false) +
                  prove_unitary(f->real_from_complex(l, true), true);
         });
       }},
      {.name = "complex-rotation",
       .statement = "real rotation matrix = W D W*, D from Wigner's d",
       .method = "exact, at a rational rotation",
       .max_degree = kMaxConventionDegree,
       .limit = kBands,
       .compared = "bands",
       .run =
           [f](int degree) {
             return prove_complex_rotation(values_to(degree, [&](int l) { return f->real_from_complex(l, true); }));
           },
       .spot_check = true},
      {"axes", "Y_l(P s) = D_l(P) Y_l(s) for the 48 signed permutations P, D(PQ) = D(P) D(Q)",
       "substitution, exact products", 10, 10, "48 matrices with all products take minutes beyond",
       "pairs of a signed permutation and a band",
       [f](int degree) { return for_each_band(degree, [&](int l) { return prove_axes(f->axes_band, l); }); }},
  };
  for (const Proof& proof : meaning_proofs(f)) proofs.push_back(proof);
  for (const Proof& proof : std::vector<Proof>{
           {"convention-functions", "A_l Y_l = the convention's functions written out, A_l A_l^-1 = 1",
            "polynomial identities, every preset and a spread of others", 10, 10, kSlowBands, "conventions",
            [f](int degree) { return prove_basis_changes(*f, degree); }},
           {"convention-round-trip", "ours -> convention -> ours is the identity",
            "exact products, every preset and others", 10, 10, kSlowBands, "conventions",
            [f](int degree) { return prove_round_trips(*f, degree); }},
           {"convention-composition", "ours -> a -> b equals ours -> b", "exact products, every preset and others", 10,
            10, kSlowBands, "triples", [f](int degree) { return prove_compositions(*f, degree); }}}) {
    proofs.push_back(proof);
  }
  return proofs;
}

}  // namespace sh::symbolic
