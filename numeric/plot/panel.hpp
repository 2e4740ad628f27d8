// The parts of a map in which neighbors show neighboring directions: the faces of a cube, or the whole picture.
// Every mapping of numeric/sampling/image_mapping.hpp. Places are (u, v), 0 to 1, from the left and from the top.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/sphere_function.hpp"
#include "numeric/sampling/image_mapping.hpp"

namespace sh::numeric::plot {

struct Panel {
  ImageMapping mapping = ImageMapping::kLatLong;
  const CubeFace* face = nullptr;  // none: the panel is the whole picture

  /// None beyond a disc's rim.
  [[nodiscard]] std::optional<Vector3> direction(const Point& place) const;
  /// None for what another panel shows.
  [[nodiscard]] std::optional<Point> place(const Vector3& direction) const;
  /// Its part of a picture that fills `area`.
  [[nodiscard]] Box box(const Box& area) const;
};

std::vector<Panel> panels_of(ImageMapping mapping);

/// "+x", "-x", "+y", ...: the axis that is nearest to a direction.
std::string axis_name(const Vector3& direction);

/// Circles of latitude and meridians, every `degrees`, as lines of places of the panel.
std::vector<std::vector<Point>> graticule(const Panel& panel, int degrees);

}  // namespace sh::numeric::plot
