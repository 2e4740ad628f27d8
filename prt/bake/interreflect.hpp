// Shadowed transfer becomes interreflected: the right sides of the bounces from transfer vectors, and back.
#pragma once
#include "prt/bake/form_factors.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Replaces shadowed vectors (vertices, bands^2) by interreflected ones (vertices, 3, bands^2), which hold the albedo,
/// and adds the bounces of the surfaces' own light to `emitted`.
/// Bounces that do not settle are reported as a flaw.
void interreflect(const Scene& scene, const FormFactors& factors, OnFlaw on_flaw, Transfer& transfer);

}  // namespace sh::prt
