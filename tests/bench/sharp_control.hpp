// libsharp (Reinecke, Seljebotn 2013) as a control: all coefficients of a degree to Gauss-Legendre rings and back, on one
// thread. Where it is not installed, tasks do nothing and kHasSharp is false.
#pragma once

#include <span>
#include <vector>

#if defined(SHFORGE_SHARP)
#include <libsharp/sharp.h>
#endif

namespace sh::bench {

#if defined(SHFORGE_SHARP)
inline constexpr bool kHasSharp = true;

class SharpControl {
 public:
  /// with_fourier: values on rings; otherwise the Fourier coefficients of the rings.
  SharpControl(int degree, std::span<const double> z, int around, bool with_fourier);
  ~SharpControl();
  SharpControl(const SharpControl&) = delete;
  SharpControl& operator=(const SharpControl&) = delete;

  void synthesis() const { run(SHARP_ALM2MAP); }
  void analysis() const { run(SHARP_MAP2ALM); }

 private:
  void run(sharp_jobtype job) const;
  int flags_;
  sharp_geom_info* geometry_ = nullptr;
  sharp_alm_info* orders_ = nullptr;
  mutable std::vector<double> coefficients_, map_;
};
#else
inline constexpr bool kHasSharp = false;

class SharpControl {
 public:
  SharpControl(int /*degree*/, std::span<const double> /*z*/, int /*around*/, bool /*with_fourier*/) {}
  void synthesis() const {}
  void analysis() const {}
};
#endif

}  // namespace sh::bench
