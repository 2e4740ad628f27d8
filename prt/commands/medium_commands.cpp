#include "prt/commands/medium_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/output/atomic_file.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/commands/shown.hpp"
#include "prt/medium/bake_medium.hpp"
#include "prt/medium/lit_medium.hpp"
#include "prt/medium/scattered_light.hpp"
#include "prt/say.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

constexpr double kMiB = 1048576.0;

// Which errors the certificate does not cover.
void report_coarseness(const Scene& scene) {
  const Density& density = scene.medium->extinction;
  const double depth =
      static_cast<double>(*std::max_element(density.values.begin(), density.values.end())) * density.spacing.maxCoeff();
  if (depth > 1.0) {
    say(
        fmt::format("the densest voxels are {:.3g} mean free paths thick: interpolation between them spreads light "
                    "further than the medium does; more voxels would hold it",
                    depth));
  }
  const double lost = std::pow(std::abs(scene.medium->anisotropy), scene.bake.degree + 1);
  if (lost > 0.01) {
    say(fmt::format("degree {} cuts the phase function off where its bands are still {:.2g}: it shows duller",
                    scene.bake.degree, lost));
  }
}

void report_scattering(const BounceReport& report) {
  const std::string error = report.certified ? fmt::format("certified error {:.2g}", report.bound)
                            : std::isfinite(report.bound) && report.bound > 0.0
                                ? fmt::format("error {:.2g}, not as small as asked for", report.bound)
                                : fmt::format("{:.2g} left", report.residual) + " (measured)";
  say(fmt::format("scattering by {}: {} applications, {} of {:.3g}", report.solver, report.applications, error,
                  report.largest));
}

class ShownMedium : public Shown {
 public:
  ShownMedium(const SubjectOptions& options, const PictureSize& size)
      : file_(options.file),
        size_(size),
        shading_(options.shading),
        transfer_(read_transfer(options.file, medium_kinds())),
        chosen_(choose_light(options.light)) {
    refuse(options);
    if (!chosen_.camera) chosen_.camera = default_camera(transfer_.grid->box, size);
    const int degree = shading_.degree_for(transfer_.degree());
    light_ = shading_.chosen(project_windowed(chosen_.lights, degree, options.light.window));
  }

  [[nodiscard]] const std::vector<Light>& lights() const override { return chosen_.lights; }
  [[nodiscard]] Turntable turntable() const override { return Turntable::kLight; }
  void require_no_input(const std::string& output) const override {
    output::require_no_input(output, {file_});
    output::require_no_input(output, chosen_.files);
  }
  const Camera& place(double /*time*/) override { return *chosen_.camera; }

  [[nodiscard]] Picture picture(const View& view, const Background& background, const std::string& what) override {
    const std::vector<float> sent = finite_scattered_light(transfer_, turned(light_, view.light_turn), file_);
    return render(LitMedium(*transfer_.grid, transfer_.density, sent), view.camera, size_, background, what);
  }
  [[nodiscard]] float least_coverage() const override { return 0.5F; }

 private:
  void refuse(const SubjectOptions& options) const {
    const auto refuse_if = [&](bool given, const char* option) {
      if (given) {
        throw std::invalid_argument(
            fmt::format("{}: {}: is for surfaces; a medium has none: expected no such option", options.file, option));
      }
    };
    refuse_if(options.sharp, "--sharp");
    refuse_if(!options.local.empty(), "--local");
    refuse_if(!shading_.recolor.empty(), "--recolor");
    refuse_if(!shading_.lobe.empty(), "--lobe");
    refuse_if(!options.transfers.empty(), "--transfers");
    shading_.require_fit(transfer_, transfer_.degree());
  }

  std::string file_;
  PictureSize size_;
  Shading shading_;
  Transfer transfer_;
  ChosenLight chosen_;
  LightCoefficients light_;
};

}  // namespace

void require_meshes(const Scene& scene, const std::string& what) {
  if (!scene.medium) return;
  throw std::invalid_argument(
      fmt::format("{}: {} takes meshes, this scene has a medium; expected `meshes`", scene.name, what));
}

void print_medium_estimate(const Scene& scene, std::size_t bounce_memory) {
  const MediumEstimate estimate = estimate_medium(scene, bounce_memory);
  print_json({{"scene", scene.name},
              {"voxels", estimate.voxels},
              {"degree", scene.bake.degree},
              {"directions", estimate.directions},
              {"seconds_before_scattering", estimate.seconds},
              {"bytes", estimate.bytes}});
}

void bake_medium_to_file(const Scene& scene, std::size_t bounce_memory, const std::string& output) {
  const Stopwatch stopwatch;
  const MediumEstimate estimate = estimate_medium(scene, bounce_memory);
  constexpr double kWorthSaying = 2.0;  // seconds
  if (estimate.seconds >= kWorthSaying) {
    say(fmt::format("about {:.2g} s before the first order of scattering, {:.0f} MiB: {} voxels, {} directions",
                    estimate.seconds, static_cast<double>(estimate.bytes) / kMiB, estimate.voxels,
                    estimate.directions));
  }
  report_coarseness(scene);
  const Transfer transfer = bake_medium(scene, bounce_memory);
  write_transfer(output, transfer);
  report_scattering(transfer.bounces);
  say(fmt::format("{:.0f} MiB at the most", static_cast<double>(peak_memory()) / kMiB));
  report_time(stopwatch, fmt::format("baked {} voxels, degree {}, {} directions, into {}", estimate.voxels,
                                     transfer.degree(), estimate.directions, output));
}

std::vector<float> finite_scattered_light(const Transfer& transfer, const LightCoefficients& light,
                                          const std::string& file) {
  std::vector<float> sent = scattered_light(transfer, light);
  if (!std::all_of(sent.begin(), sent.end(), [](float value) { return std::isfinite(value); })) {
    throw std::runtime_error(fmt::format("{}: its radiance exceeds single precision: expected weaker lights", file));
  }
  return sent;
}

std::unique_ptr<Shown> shown_medium(const SubjectOptions& options, const PictureSize& size) {
  const TransferKind* kind = kind_of_file(options.file);
  return kind != nullptr && kind->in_medium ? std::make_unique<ShownMedium>(options, size) : nullptr;
}

}  // namespace sh::prt
