#include "prt/rays/tracer.hpp"

#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "prt/rays/sheets.hpp"
#include "prt/rays/whole_faces.hpp"

namespace sh::prt {

namespace {

static_assert(sizeof(ShadowRay) == sizeof(RTCRay));
static_assert(offsetof(RTCRay, tnear) == offsetof(ShadowRay, near) &&
              offsetof(RTCRay, dir_x) == offsetof(ShadowRay, direction) &&
              offsetof(RTCRay, tfar) == offsetof(ShadowRay, far) &&
              offsetof(RTCRay, mask) == offsetof(ShadowRay, mask));

constexpr std::size_t kPrimaryBatch = 256;  // rays a stream call
constexpr double kFarthestStart = 1e18;     // units of the frame; Embree aborts from 1.8e18

struct InstructionSet {
  std::string_view name;
  bool available;
};

// From best to least. avx512 is used only on request, so that results agree on nearly every machine.
std::array<InstructionSet, 4> instruction_sets() {
  return {{{"avx2", __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0},
           {"avx", __builtin_cpu_supports("avx") != 0},
           {"sse4.2", __builtin_cpu_supports("sse4.2") != 0},
           {"avx512", __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                          __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0}}};
}

}  // namespace

std::string choose_instruction_set(const std::string& wanted) {
  std::string names;
  for (const InstructionSet& set : instruction_sets()) {
    if (set.available && (wanted.empty() || wanted == set.name)) return std::string(set.name);
    names += set.available ? fmt::format("{}{}", names.empty() ? "" : ", ", set.name) : "";
  }
  throw std::invalid_argument(
      fmt::format("instruction set {}: expected one that this machine has ({})", wanted, names));
}

namespace {

[[noreturn]] void fail(const char* what) { throw std::runtime_error(fmt::format("ray tracer: {}", what)); }

}  // namespace

struct Tracer::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::string instruction_set;
  Frame frame;
  std::atomic<std::uint64_t> rays{0};
  WholeFaces wholes;
  Sheets sheets;

  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void open(int threads, const std::string& wanted) {
    instruction_set = choose_instruction_set(wanted);
    device = rtcNewDevice(fmt::format("threads={},isa={}", threads, instruction_set).c_str());
    if (device == nullptr) fail("Embree cannot start");
    scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  }

  void add(const Mesh& mesh) {
    sheets = Sheets(mesh);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), mesh.positions.size());
    const std::vector<Face> known = sheets.without_backs(mesh.faces);
    void* indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Face), known.size());
    if (vertices == nullptr || indices == nullptr) {
      rtcReleaseGeometry(geometry);
      fail("not enough memory for the mesh");
    }
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Eigen::Vector3f*>(vertices));
    std::copy(known.begin(), known.end(), static_cast<Face*>(indices));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("Embree cannot build its tree");
  }
};

Tracer::Tracer(const Mesh& mesh, int threads, const std::string& instruction_set) : impl_(std::make_unique<Impl>()) {
  impl_->frame = mesh.frame;
  impl_->open(threads, instruction_set);
  if (mesh.halving.empty()) {
    impl_->add(mesh);
  } else {
    impl_->wholes = WholeFaces(mesh.halving);
    impl_->add(impl_->wholes.surface(mesh));
  }
}

Tracer::~Tracer() = default;

const std::string& Tracer::instruction_set() const { return impl_->instruction_set; }

Eigen::Vector3f Tracer::start(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = frame().local(point);
  if (!(local.cwiseAbs().maxCoeff() <= kFarthestStart)) {
    throw std::runtime_error(fmt::format("the point {:g} {:g} {:g}: expected one within {:g} of the meshes", point.x(),
                                         point.y(), point.z(), kFarthestStart * frame().unit));
  }
  return local.cast<float>();
}

const Frame& Tracer::frame() const { return impl_->frame; }

std::uint64_t Tracer::rays() const { return impl_->rays; }

void Tracer::intersect(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
                       std::span<Hit> hits) const {
  impl_->rays += hits.size();
  std::vector<RTCRayHit> rays(std::min(kPrimaryBatch, hits.size()));
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t first = 0; first < hits.size(); first += rays.size()) {
    const std::size_t count = std::min(rays.size(), hits.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3f& o = origins[first + i];
      const Eigen::Vector3f& d = directions[first + i];
      rays[i].ray = {o.x(),       o.y(), o.z(), 0.0F, d.x(), d.y(), d.z(), 0.0F, std::numeric_limits<float>::infinity(),
                     0xFFFFFFFFU, 0,     0};
      rays[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect1M(impl_->scene, &context, rays.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = rays[i].hit.geomID != RTC_INVALID_GEOMETRY_ID;
      hits[first + i] = hit ? Hit{rays[i].hit.primID, rays[i].hit.u, rays[i].hit.v, rays[i].ray.tfar} : Hit{};
      if (hit && impl_->sheets.any()) {
        const Eigen::Vector3f normal(rays[i].hit.Ng_x, rays[i].hit.Ng_y, rays[i].hit.Ng_z);
        impl_->sheets.face_ray(normal.dot(directions[first + i]) > 0.0F, hits[first + i]);
      }
      if (hit && impl_->wholes.any()) hits[first + i] = impl_->wholes.hit_of_mesh(hits[first + i]);
    }
  }
}

void Tracer::occluded(std::span<ShadowRay> rays) const {
  impl_->rays += rays.size();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1M(impl_->scene, &context, reinterpret_cast<RTCRay*>(rays.data()), static_cast<unsigned>(rays.size()),
                sizeof(RTCRay));
}

}  // namespace sh::prt
