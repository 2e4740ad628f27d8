#include "prt/medium/made_density.hpp"

#include <algorithm>
#include <cmath>

#include "prt/chunks.hpp"

namespace sh::prt {
namespace {

// The finisher of SplitMix64 (Steele, Lea and Flood 2014) over the words: uniform in 0..1, a multiple of 2^-53.
double hash(std::uint64_t seed, std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t bits = seed;
  for (const std::int64_t word : {x, y, z}) {
    bits = (bits ^ static_cast<std::uint64_t>(word)) + 0x9E3779B97F4A7C15U;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    bits ^= bits >> 31U;
  }
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

double mix(double a, double b, double t) { return a + t * (b - a); }

// 0 at 0, 1 at 1, flat at both: 3 t^2 - 2 t^3.
double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

using Point = Eigen::Array3d;

// Values of 0..1 at the points of a lattice, smooth between them.
double noise(std::uint64_t seed, const Point& p) {
  const Point low = p.floor();
  const auto x = static_cast<std::int64_t>(low.x());
  const auto y = static_cast<std::int64_t>(low.y());
  const auto z = static_cast<std::int64_t>(low.z());
  const Point t = (p - low).unaryExpr(&smooth);
  const auto row = [&](std::int64_t dy, std::int64_t dz) {
    return mix(hash(seed, x, y + dy, z + dz), hash(seed, x + 1, y + dy, z + dz), t.x());
  };
  return mix(mix(row(0, 0), row(1, 0), t.y()), mix(row(0, 1), row(1, 1), t.y()), t.z());
}

// Octaves, each of twice the frequency and half the size of the one before: -1..1.
double octaves(std::uint64_t seed, Point p, int count) {
  double sum = 0.0;
  double size = 0.5;
  for (int i = 0; i < count; ++i) {
    sum += size * (2.0 * noise(seed + static_cast<std::uint64_t>(i), p) - 1.0);
    p *= 2.0;
    size *= 0.5;
  }
  return sum;
}

constexpr int kOctaves = 5;

struct Puff {
  Point center;
  double radius;
};

// Larger puffs lie low and in the middle.
std::vector<Puff> puffs(std::uint64_t seed) {
  constexpr int kPuffs = 24;
  std::vector<Puff> all;
  for (int i = 0; i < kPuffs; ++i) {
    const auto random = [&](int what) { return hash(seed, i, what, -1); };
    const double out = 0.66 * std::sqrt(random(0));
    const double x = 2.0 * random(1) - 1.0;
    const double y = 2.0 * random(2) - 1.0;
    const double far = std::max(1e-9, std::sqrt(x * x + y * y));
    const double room = 1.0 - out;
    const Point center(out * x / far, 0.8 * out * y / far, -0.45 + 1.0 * random(3) * room);
    all.push_back({center, 0.18 + 0.42 * room * (0.5 + 0.5 * random(4))});
  }
  return all;
}

// Points are in -1..1. The noise moves a point before it meets the puffs.
double cloud(const std::vector<Puff>& heap, std::uint64_t seed, const Point& p) {
  double inside = -1.0;
  for (const Puff& puff : heap) {
    inside = std::max(inside, 1.0 - std::sqrt((p - puff.center).square().sum()) / puff.radius);
  }
  const double rough = octaves(seed, 3.5 * (p + 8.0), kOctaves);
  const double base = smooth((p.z() + 0.7) / 0.15);
  return base * smooth((inside + 0.8 * rough) / 0.25);
}

double smoke(std::uint64_t seed, const Point& p) {
  const double height = 0.5 * (p.z() + 1.0);
  const Point slow(0.3, 0.3, 2.2 * height);
  const double drift = 0.5 * height;
  const double x = p.x() - drift * (2.0 * noise(seed, slow) - 1.0);
  const double y = p.y() - drift * (2.0 * noise(seed + 100, slow) - 1.0);
  const double radius = 0.10 + 0.42 * height;
  const double away = std::sqrt(x * x + y * y) / radius;
  const Point curl(p.x() + 8.0, p.y() + 8.0, 0.7 * p.z() + 8.0);
  const double rough = octaves(seed + 200, 4.0 * curl, kOctaves);
  return (1.0 - 0.75 * height) * smooth((1.0 - away + 0.9 * rough) / 0.6) * smooth((1.0 - height) / 0.25);
}

}  // namespace

std::vector<float> make_density(MadeDensity made, const Counts& counts, std::uint32_t seed) {
  std::vector<float> values(voxel_count(counts), 1.0F);
  if (made == MadeDensity::kUniform) return values;
  const std::vector<Puff> heap = puffs(seed);
  const Density grid{.counts = counts};
  for_vertices(values.size(), [&](std::size_t voxel) {
    const Counts at = grid.place(voxel);
    Point p;
    double border = 1.0;  // 0 at the outermost centers, if there are more than two along an axis
    for (int a = 0; a < 3; ++a) {
      const int n = counts[static_cast<std::size_t>(a)];
      p[a] = (2.0 * at[static_cast<std::size_t>(a)] + 1.0) / n - 1.0;
      const double edge = 1.0 - 1.0 / n;
      if (n > 2) border = std::min(border, smooth((edge - std::abs(p[a])) / 0.1));
    }
    values[voxel] = static_cast<float>(border * (made == MadeDensity::kCloud ? cloud(heap, seed, p) : smoke(seed, p)));
  });
  return values;
}

}  // namespace sh::prt
