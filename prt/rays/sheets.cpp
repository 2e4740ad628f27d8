#include "prt/rays/sheets.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "prt/mesh/corners.hpp"

namespace sh::prt {

namespace {

using Positions = std::vector<Eigen::Vector3f>;
using Corner = std::array<std::uint32_t, 3>;  // the bits of a position

// The corners, starting with the least one, in the order of the face or against it. They are equal for faces that
// coincide.
struct Outline {
  std::array<Corner, 3> corners;
  std::uint32_t face;
  std::uint32_t first;  // the corner of the face that is the least
  bool against;         // they are listed against the face's order

  [[nodiscard]] auto key() const { return std::tie(corners, against, face); }
};

Outline outline_of(const Positions& positions, const std::vector<Face>& faces, std::uint32_t face) {
  std::array<Corner, 3> corners{};
  for (std::size_t k = 0; k < 3; ++k) corners[k] = bits_of(positions[faces[face][k]]);
  const std::size_t first = std::min_element(corners.begin(), corners.end()) - corners.begin();
  Outline outline{{corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]},
                  face,
                  static_cast<std::uint32_t>(first),
                  false};
  if (outline.corners[2] < outline.corners[1]) {
    std::swap(outline.corners[1], outline.corners[2]);
    outline.against = true;
  }
  return outline;
}

// The faces whose corners have the hash of those of another face; 16 bytes of memory a face.
std::vector<std::uint32_t> faces_like_others(const Positions& positions, const std::vector<Face>& faces) {
  struct Hashed {
    std::size_t hash;
    std::uint32_t face;
    bool operator<(const Hashed& other) const { return hash < other.hash; }
  };
  std::vector<Hashed> hashed;
  hashed.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    std::size_t sum = 0;  // does not depend on the order of the corners
    for (const std::uint32_t corner : faces[f]) sum += WordsHash()(bits_of(positions[corner]));
    hashed.push_back({sum, f});
  }
  std::sort(hashed.begin(), hashed.end());
  std::vector<std::uint32_t> like_others;
  for (std::size_t i = 0; i < hashed.size(); ++i) {
    const bool is_like_last = i > 0 && hashed[i - 1].hash == hashed[i].hash;
    const bool is_like_next = i + 1 < hashed.size() && hashed[i + 1].hash == hashed[i].hash;
    if (is_like_last || is_like_next) like_others.push_back(hashed[i].face);
  }
  return like_others;
}

}  // namespace

Sheets::Sheets(const Positions& positions, const std::vector<Face>& faces) {
  std::vector<Outline> outlines;
  for (const std::uint32_t face : faces_like_others(positions, faces)) {
    outlines.push_back(outline_of(positions, faces, face));
  }
  if (outlines.empty()) return;
  std::sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) { return a.key() < b.key(); });
  std::vector<Front> all(faces.size());
  for (std::uint32_t f = 0; f < all.size(); ++f) all[f] = {f, kNoFace, 0};
  std::vector<std::uint8_t> is_back(faces.size(), 0);
  // Among coinciding faces those in order come first; the i-th of them and the i-th face against the order are a pair.
  for (auto begin = outlines.begin(); begin != outlines.end();) {
    const auto end = std::find_if(begin, outlines.end(), [&](const Outline& o) { return o.corners != begin->corners; });
    const auto against = std::find_if(begin, end, [](const Outline& o) { return o.against; });
    for (auto a = begin, b = against; a != against && b != end; ++a, ++b) {
      const auto [front, back] =
          std::minmax(*a, *b, [](const Outline& x, const Outline& y) { return x.face < y.face; });
      all[front.face].back = back.face;
      all[front.face].turn = (front.first + back.first) % 3;
      is_back[back.face] = 1;
    }
    begin = end;
  }
  if (std::find(is_back.begin(), is_back.end(), 1) != is_back.end()) {
    std::copy_if(all.begin(), all.end(), std::back_inserter(fronts_),
                 [&](const Front& front) { return is_back[front.face] == 0; });
  }
}

std::vector<Face> Sheets::without_backs(const std::vector<Face>& faces) const {
  if (!any()) return faces;
  std::vector<Face> known;
  known.reserve(fronts_.size());
  for (const Front& front : fronts_) known.push_back(faces[front.face]);
  return known;
}

std::uint32_t Sheets::count_before(std::uint32_t face) const {
  if (!any()) return face;
  const auto place =
      std::partition_point(fronts_.begin(), fronts_.end(), [&](const Front& front) { return front.face < face; });
  return static_cast<std::uint32_t>(place - fronts_.begin());
}

void Sheets::face_ray(Hit& hit) const {
  const Front& front = fronts_[hit.face];
  if (!hit.from_behind || front.back == kNoFace) {
    hit.face = front.face;
    return;
  }
  const std::array<float, 3> weights = hit.parts();
  hit.face = front.back;
  hit.from_behind = false;
  hit.u = weights[(front.turn + 2) % 3];
  hit.v = weights[(front.turn + 1) % 3];
}

}  // namespace sh::prt
