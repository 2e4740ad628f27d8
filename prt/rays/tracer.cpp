#include "prt/rays/tracer.hpp"

#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "prt/rays/copies.hpp"
#include "prt/rays/sheets.hpp"
#include "prt/rays/whole_faces.hpp"

namespace sh::prt {

namespace {

static_assert(sizeof(ShadowRay) == sizeof(RTCRay));
static_assert(offsetof(RTCRay, tnear) == offsetof(ShadowRay, near) &&
              offsetof(RTCRay, dir_x) == offsetof(ShadowRay, direction) &&
              offsetof(RTCRay, tfar) == offsetof(ShadowRay, far) &&
              offsetof(RTCRay, mask) == offsetof(ShadowRay, mask));

constexpr std::size_t kPrimaryBatch = 256;    // rays a stream call
constexpr double kFarthestStart = 1e18;       // units of the frame; Embree aborts from 1.8e18
constexpr std::uint32_t kLeastCopied = 1024;  // faces of a node; a tree of fewer takes no memory to speak of

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
  // What is attached to the scene, in the order of its numbers.
  struct Attached {
    std::uint32_t first;          // tested face
    Eigen::Matrix3f to_original;  // the axes of its own faces
  };

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::string instruction_set;
  Frame frame;
  std::atomic<std::uint64_t> rays{0};
  WholeFaces wholes;
  Sheets sheets;
  std::vector<Attached> attached;
  std::size_t shared_faces = 0;

  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void open(int threads, const std::string& wanted) {
    instruction_set = choose_instruction_set(wanted);
    device = rtcNewDevice(fmt::format("threads={},isa={}", threads, instruction_set).c_str());
    if (device == nullptr) fail("Embree cannot start");
    scene = new_scene();
  }

  [[nodiscard]] RTCScene new_scene() const {
    RTCScene made = rtcNewScene(device);
    rtcSetSceneBuildQuality(made, RTC_BUILD_QUALITY_HIGH);
    return made;
  }

  [[nodiscard]] RTCGeometry triangles(Parts& parts, const FaceRun& run, const Eigen::Vector3f& center) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), parts.choose(run));
    void* indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Face), run.count);
    if (vertices == nullptr || indices == nullptr) {
      rtcReleaseGeometry(geometry);
      fail("not enough memory for the mesh");
    }
    parts.write(center, static_cast<Eigen::Vector3f*>(vertices), static_cast<Face*>(indices));
    return geometry;
  }

  static void attach(RTCGeometry geometry, RTCScene to) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(to, geometry);
    rtcReleaseGeometry(geometry);
  }

  void add_copies(const CopiedRun& copied, Parts& parts) {
    RTCScene original = new_scene();
    attach(triangles(parts, copied.run, copied.center), original);
    rtcCommitScene(original);
    shared_faces += (copied.places.size() - 1) * copied.run.count;
    for (const CopiedRun::Place& place : copied.places) {
      RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, original);
      rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, place.from_original.data());
      attach(instance, scene);
      attached.push_back({place.first, place.from_original.linear().inverse()});
    }
    rtcReleaseScene(original);
  }

  // Nodes whose tested faces stand together.
  [[nodiscard]] std::vector<RunOfNode> runs_of_nodes(const Mesh& mesh) const {
    const Eigen::Affine3d to_frame = Eigen::Scaling(1.0 / mesh.frame.unit) * Eigen::Translation3d(-mesh.frame.origin);
    const auto tested_before = [&](std::uint32_t face) { return sheets.count_before(wholes.count_before(face)); };
    std::vector<RunOfNode> nodes;
    for (const MeshNode& node : mesh.nodes) {
      std::vector<FaceRun> runs;
      for (const auto& [first, count] : node.faces) {
        const std::uint32_t before = tested_before(first);
        const std::uint32_t tested = tested_before(first + count) - before;
        if (tested > 0) runs.push_back({before, tested});
      }
      if (runs.size() == 1) nodes.push_back({runs.front(), to_frame * node.to_world});
    }
    return nodes;
  }

  // Copies, if they have as many faces as `shared`.
  [[nodiscard]] std::vector<CopiedRun> shared_copies(const Mesh& mesh, const std::vector<Face>& tested,
                                                     std::size_t shared) const {
    if (tested.size() < shared) return {};
    std::vector<CopiedRun> copies = find_copies(mesh.positions, tested, runs_of_nodes(mesh), kLeastCopied);
    std::size_t saved = 0;
    for (const CopiedRun& copied : copies) saved += (copied.places.size() - 1) * copied.run.count;
    return saved >= shared ? copies : std::vector<CopiedRun>();
  }

  void add(const Mesh& mesh, const std::vector<Face>& traced, std::size_t shared) {
    sheets = Sheets(mesh.positions, traced);
    const std::vector<Face> fronts = sheets.any() ? sheets.without_backs(traced) : std::vector<Face>();
    const std::vector<Face>& tested = sheets.any() ? fronts : traced;
    Parts parts(mesh.positions, tested);
    std::vector<FaceRun> runs;  // of originals and copies
    for (const CopiedRun& copied : shared_copies(mesh, tested, shared)) {
      add_copies(copied, parts);
      for (const CopiedRun::Place& place : copied.places) runs.push_back({place.first, copied.run.count});
    }
    std::sort(runs.begin(), runs.end(), [](const FaceRun& a, const FaceRun& b) { return a.first < b.first; });
    runs.push_back({static_cast<std::uint32_t>(tested.size()), 0});
    std::uint32_t end = 0;
    for (const FaceRun& run : runs) {
      if (run.first > end) {
        attach(triangles(parts, {end, run.first - end}, Eigen::Vector3f::Zero()), scene);
        attached.push_back({end, Eigen::Matrix3f::Identity()});
      }
      end = run.first + run.count;
    }
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("Embree cannot build its tree");
  }

  // The hit of a traced face for one of Embree; `direction` is that of its ray.
  [[nodiscard]] Hit hit_of_traced(const RTCRayHit& ray, const Eigen::Vector3f& direction) const {
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const std::uint32_t instance = ray.hit.instID[0];
    const Attached& part = attached[instance == RTC_INVALID_GEOMETRY_ID ? ray.hit.geomID : instance];
    const Eigen::Vector3f normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    Hit hit{part.first + ray.hit.primID, ray.hit.u, ray.hit.v, ray.ray.tfar,
            normal.dot(part.to_original * direction) > 0.0F};
    if (sheets.any()) sheets.face_ray(hit);
    return hit;
  }
};

Tracer::Tracer(const Mesh& mesh, int threads, const std::string& instruction_set, std::size_t shared)
    : impl_(std::make_unique<Impl>()) {
  impl_->frame = mesh.frame;
  impl_->open(threads, instruction_set);
  if (mesh.halving.empty()) {
    impl_->add(mesh, mesh.faces, shared);
  } else {
    impl_->wholes = WholeFaces(mesh);
    impl_->add(mesh, impl_->wholes.traced(mesh.faces), shared);
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

std::size_t Tracer::shared_faces() const { return impl_->shared_faces; }

std::uint64_t Tracer::rays() const { return impl_->rays; }

void Tracer::intersect(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
                       std::span<Hit> hits) const {
  meet(origins, directions, hits);
  if (!impl_->wholes.any()) return;
  for (Hit& hit : hits) {
    if (hit.face != Hit::kNothing) hit = impl_->wholes.hit_of_mesh(hit);
  }
}

void Tracer::meet(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
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
      rays[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect1M(impl_->scene, &context, rays.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
    for (std::size_t i = 0; i < count; ++i) hits[first + i] = impl_->hit_of_traced(rays[i], directions[first + i]);
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
