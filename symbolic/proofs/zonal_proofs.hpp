// Proofs about zonal functions (zonal.hpp, irradiance.hpp, convolution.hpp).
//
// Every function takes what it proves, so that a spoiled copy is refuted; zonal_proofs() is the catalogue.
#pragma once

#include <vector>

#include "symbolic/proofs/proofs.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {

/// claimed[l] = the closed form of z_l of the family, for every l.
ProofResult prove_zonal_family(const ZonalFamily& family, const std::vector<ZonalTerm>& claimed);

/// cap + complement = 1 everywhere: their coefficients add up to sqrt(4 pi) in band 0 and to zero beyond.
ProofResult prove_cap_complement(const std::vector<ZonalTerm>& cap, const std::vector<ZonalTerm>& complement);

/// claimed[l] = 2 pi integral_0^1 t P_l(t) dt.
ProofResult prove_irradiance_factors(const std::vector<Surd>& claimed);

/// Convolution theorem: integral Y_lm(s) (s.n)^k ds = factors[l] h_l Y_lm(n) for every l, m and every k up to the
/// number of factors, h_l the zonal coefficients of t^k: an identity of polynomials in n, and the powers span every
/// kernel.
ProofResult prove_convolution(const std::vector<Surd>& factors);

/// Addition theorem: sum_m entry_lm(d) Y_lm(s) = Y_l0(d.s) for every degree that `entries` holds, an identity of
/// polynomials in (d, s). Entries are ordered by l(l+1)+m.
ProofResult prove_turned_zonal(const std::vector<TurnedZonal>& entries);

/// The catalogue of this area.
std::vector<Proof> zonal_proofs();

}  // namespace sh::symbolic
