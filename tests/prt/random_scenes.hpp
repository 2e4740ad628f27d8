// Random small scenes for properties; RapidCheck shrinks one that fails to fewer, simpler pieces.
#pragma once
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <ostream>
#include <string_view>
#include <vector>

#include "tests/prt/rooms.hpp"

namespace sh::prt::test {

/// A primitive in steps that shrink towards a plane of size 1 at the origin.
struct Piece {
  static constexpr std::array<std::string_view, 6> kShapes = {"plane", "box", "cone", "sphere", "torus", "stairs"};
  int shape = 0;  // of kShapes
  int size = 0;   // 1 / (1 + size)
  int x = 0;      // quarters
  int y = 0;
  int z = 0;
  int turn = 0;    // of 15 degrees about (1, 2, 3)
  int albedo = 0;  // eighths
  bool is_inside_out = false;
};

inline std::ostream& operator<<(std::ostream& out, const Piece& p) {
  return out << Piece::kShapes.at(p.shape) << "(size 1/" << 1 + p.size << ", at " << p.x << ' ' << p.y << ' ' << p.z
             << " / 4, turned " << 15 * p.turn << ", albedo " << p.albedo << "/8"
             << (p.is_inside_out ? ", inside out)" : ")");
}

inline rc::Gen<std::vector<Piece>> some_pieces() {
  const auto piece = rc::gen::build<Piece>(
      rc::gen::set(&Piece::shape, rc::gen::inRange(0, static_cast<int>(Piece::kShapes.size()))),
      rc::gen::set(&Piece::size, rc::gen::inRange(0, 4)), rc::gen::set(&Piece::x, rc::gen::inRange(-4, 5)),
      rc::gen::set(&Piece::y, rc::gen::inRange(-4, 5)), rc::gen::set(&Piece::z, rc::gen::inRange(-4, 5)),
      rc::gen::set(&Piece::turn, rc::gen::inRange(0, 24)), rc::gen::set(&Piece::albedo, rc::gen::inRange(0, 8)),
      rc::gen::set(&Piece::is_inside_out, rc::gen::weightedElement<bool>({{7, false}, {1, true}})));
  return rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 4),
                         [piece](std::size_t count) { return rc::gen::container<std::vector<Piece>>(count, piece); });
}

inline Mesh mesh_of(const Piece& piece) {
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.translate(0.25F *
                Eigen::Vector3f(static_cast<float>(piece.x), static_cast<float>(piece.y), static_cast<float>(piece.z)));
  map.rotate(Eigen::AngleAxisf(static_cast<float>(piece.turn) * std::numbers::pi_v<float> / 12.0F,
                               Eigen::Vector3f(1.0F, 2.0F, 3.0F).normalized()));
  map.scale(1.0F / static_cast<float>(1 + piece.size));
  Mesh mesh = primitive_mesh(Piece::kShapes.at(piece.shape), 8, map);
  refine(mesh, 0.5F / static_cast<float>(1 + piece.size));
  paint(mesh, Eigen::Vector3f::Constant(static_cast<float>(piece.albedo) / 8.0F));
  if (piece.is_inside_out) turn_inside_out(mesh);
  return mesh;
}

/// The pieces over a square of ground.
inline Mesh mesh_of(const std::vector<Piece>& pieces) {
  Eigen::Affine3f down = Eigen::Affine3f::Identity();
  down.translate(Eigen::Vector3f(0.0F, 0.0F, -1.3F)).scale(4.0F);
  Mesh mesh = primitive_mesh("plane", 8, down);
  refine(mesh, 1.0F);
  for (const Piece& piece : pieces) append(mesh, mesh_of(piece));
  return mesh;
}

}  // namespace sh::prt::test
