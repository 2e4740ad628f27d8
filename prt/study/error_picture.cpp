#include "prt/study/error_picture.hpp"

#include "prt/runtime/render.hpp"
#include "prt/study/false_color.hpp"

namespace sh::prt {

std::string error_picture(const Mesh& mesh, const Tracer& tracer, const std::vector<float>& relative_errors,
                          const Camera& camera, const PictureSize& size, const std::string& title,
                          const std::string& what) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(relative_errors.size());
  for (const float error : relative_errors) {
    places.emplace_back(Eigen::Vector3f::Constant(error_place(static_cast<double>(error))));
  }
  const Background nothing = [](const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f::Zero().eval(); };
  Mesh shown = mesh;
  shown.mirror.clear();  // errors are those of the vertices themselves
  const Picture picture = render(shown, tracer, places, camera, size, nothing, what);
  ErrorMap map{picture.width, picture.height, {}, picture.coverage};
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    map.place.push_back(picture.coverage[i] > 0.0F ? picture.radiance[i].x() / picture.coverage[i] : 0.0F);
  }
  return error_png(map, title);
}

}  // namespace sh::prt
