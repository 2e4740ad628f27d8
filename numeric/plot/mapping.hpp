// The sphere on flat panels, and where +x, +y, +z are in them. World axes: z up, right-handed; every panel is what a
// viewer at the centre sees, not mirrored. Places are (u, v), 0 to 1, from the left and from the top.
//
// Lat-long, one panel: theta = pi v from +z, phi = pi (1 - 2u) from +x towards +y. Top edge +z, bottom edge -z, middle
// +x, a quarter from the left +y, three quarters -y, left and right edge -x. The same as in prt/image/lat_long.hpp.
//
// Cube map, six panels of a cross, four wide and three high: +y +x -y -x side by side in the middle row (as in the
// lat-long picture), +z above +x and -z below it. On a face with centre c, right r and down d the direction of a place
// is c + (2u - 1) r + (2v - 1) d, made a unit vector.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/vector.hpp"

namespace sh::numeric::plot {

enum class Projection { kLatLong, kCubeMap };

struct Panel {
  std::string label;  // the axis at its centre
  int column = 0;     // of the cross
  int row = 0;        // of the cross
  std::function<Vector3(const Point&)> direction;
  std::function<std::optional<Point>(const Vector3&)> place;  // none: not in this panel
};

std::vector<Panel> panels_of(Projection projection);

/// Circles of latitude and meridians, every `degrees`, as lines of places of the panel.
std::vector<std::vector<Point>> graticule(const Panel& panel, int degrees);

}  // namespace sh::numeric::plot
