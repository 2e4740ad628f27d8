// A kind of transfer: its names, the shape of what a vertex stores, and the steps by which a bake makes it.
// prt/kinds defines the kinds and lists them.
#pragma once
#include <algorithm>
#include <span>
#include <string_view>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

struct BakeRun;

/// A part of a bake that continues the steps before it; prt/bake/steps.hpp lists the steps.
struct BakeStep {
  void (*run)(BakeRun& run);
  bool traces_rays = false;
  bool bounces = false;  // needs the hits of the rays: the form factors
};

struct TransferKind {
  std::string_view letters;  // in files, as Sloan, Kautz and Snyder 2002 write
  std::string_view word;     // in scenes and on command lines
  /// The shape of a vertex's numbers for light of this degree, in plain storage.
  TransferShape (*shape)(int degree);
  std::span<const BakeStep> steps;                // in order
  const TransferKind* without_bounces = nullptr;  // the same kind without bounces; null if it has none

  [[nodiscard]] bool traces_rays() const {
    return std::any_of(steps.begin(), steps.end(), [](const BakeStep& step) { return step.traces_rays; });
  }
  [[nodiscard]] bool has_bounces() const {
    return std::any_of(steps.begin(), steps.end(), [](const BakeStep& step) { return step.bounces; });
  }
};

}  // namespace sh::prt
