#include "prt/medium/scattered_light.hpp"

#include "generated/batch/batch.hpp"
#include "prt/chunks.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {

std::vector<float> scattered_light(const Transfer& transfer, const LightCoefficients& light) {
  const TransferShape& shape = transfer.shape;
  const std::size_t rows = shape.rows();
  std::vector<float> sent(transfer.receivers() * 3 * rows);
  if (rows == 1) {
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    relight_into(transfer, light, {reinterpret_cast<Eigen::Vector3f*>(sent.data()), transfer.receivers()});
    return sent;
  }
  require_light(transfer, light);
  const std::vector<float> values = in_single(light, transfer.degree());
  const Rows numbers = transfer.rows();
  for_vertices(transfer.receivers(), [&](std::size_t v) {
    std::vector<float> room;
    const float* own = numbers.some(v, 1, room);
    for (std::size_t c = 0; c < 3; ++c) {
      batch::relight(shape.degree, rows, batch::plain(own + c * shape.count()), values.data() + c * shape.columns(),
                     batch::plain(&sent[(3 * v + c) * rows]));
    }
  });
  return sent;
}

}  // namespace sh::prt
