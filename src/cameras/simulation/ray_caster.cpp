#include "polygonal_perception/cameras/simulation/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cameras/simulation/embree.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr std::uint32_t kPacketWidth = 8;
constexpr std::uint32_t kPacketHeight = 2;
constexpr std::uint32_t kPacket = kPacketWidth * kPacketHeight;

}  // namespace

struct Material
{
  Surface surface;
  float reflectance;
  std::uint16_t plane;
};

/// The triangles of some solids as one Embree scene.
class Body
{
public:
  Body(RTCDevice device, RTCBuildQuality quality)
      : scene_(rtcNewScene(device)), geometry_(newMesh(device, quality))
  {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, quality);
    rtcAttachGeometry(scene_, geometry_);
    rtcReleaseGeometry(geometry_);
  }
  ~Body() { rtcReleaseScene(scene_); }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  bool empty() const { return materials_.empty(); }
  RTCScene scene() const { return scene_; }
  const Material& material(unsigned triangle) const { return materials_[triangle]; }

  /// Sets the triangles; from the second call on only the vertices may differ.
  void set(const std::vector<Solid>& solids, const ScenePlanes& planes)
  {
    if (solids.empty()) return;
    if (empty()) allocate(solids, planes);
    for (const Solid& solid : solids) {
      for (const Eigen::Vector3f& v : solid.vertices) vertex_ = std::copy(v.data(), v.data() + 3, vertex_);
    }
    vertex_ = vertices_;
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

private:
  static RTCGeometry newMesh(RTCDevice device, RTCBuildQuality quality)
  {
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(mesh, quality);
    return mesh;
  }

  void allocate(const std::vector<Solid>& solids, const ScenePlanes& planes)
  {
    std::size_t vertex_count = 0;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Solid& solid : solids) {
      const auto first = static_cast<std::uint32_t>(vertex_count);
      for (const auto& t : solid.triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
        const std::size_t k = materials_.size();
        materials_.push_back(
            {solid.surface, solid.reflectance,
             k < planes.ofTriangles().size() ? planes.ofTriangles()[k] : ScenePlanes::kNone});
      }
      vertex_count += solid.vertices.size();
    }
    vertices_ = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertex_count));
    auto* indices = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    if (vertices_ == nullptr || indices == nullptr) throw std::runtime_error("Embree cannot allocate a mesh");
    std::copy(triangles.begin(), triangles.end(), indices);
    vertex_ = vertices_;
  }

  RTCScene scene_;
  RTCGeometry geometry_;
  std::vector<Material> materials_;  // a triangle
  float* vertices_ = nullptr;        // owned by Embree
  float* vertex_ = nullptr;
};

class RayCaster::Device
{
public:
  explicit Device(const Scene& scene) : scene_(&scene), planes_(scene.solids), device_(newDevice())
  {
    still_ = std::make_unique<Body>(device_, RTC_BUILD_QUALITY_HIGH);
    moving_ = std::make_unique<Body>(device_, RTC_BUILD_QUALITY_LOW);
    still_->set(scene.solids, planes_);
  }
  ~Device()
  {
    still_.reset();
    moving_.reset();
    rtcReleaseDevice(device_);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const ScenePlanes& planes() const { return planes_; }

  void move(double time)
  {
    scene_->walkersAt(time, people_);
    moving_->set(people_, {});
  }

  void cast(const PinholeCamera& camera, const Eigen::Isometry3d& camera_to_world, RayImage& image) const
  {
    const Eigen::Matrix3f rotation = camera_to_world.linear().cast<float>();
    const Eigen::Vector3f origin = camera_to_world.translation().cast<float>();
    for (std::uint32_t v = 0; v < camera.height; v += kPacketHeight) {
      for (std::uint32_t u = 0; u < camera.width; u += kPacketWidth) {
        castPacket(camera, rotation, origin, u, v, image);
      }
    }
  }

private:
  static RTCDevice newDevice()
  {
    RTCDevice device = rtcNewDevice("threads=1");
    if (device == nullptr) throw std::runtime_error("Embree does not start on this machine");
    return device;
  }

  void castPacket(const PinholeCamera& camera, const Eigen::Matrix3f& rotation, const Eigen::Vector3f& origin,
                  std::uint32_t left, std::uint32_t top, RayImage& image) const
  {
    // Not zeroed: all that Embree reads is set below.
    alignas(64) RTCRayHit16 rays;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    alignas(64) int valid[kPacket];
    for (std::uint32_t i = 0; i < kPacket; ++i) {
      const std::uint32_t u = left + i % kPacketWidth;
      const std::uint32_t v = top + i / kPacketWidth;
      valid[i] = u < camera.width && v < camera.height ? -1 : 0;
      // With a direction whose z is 1 in the optical frame, the ray's parameter is the depth.
      const Eigen::Vector3f direction =
          rotation * Eigen::Vector3f(static_cast<float>((u - camera.cx) / camera.fx),
                                     static_cast<float>((v - camera.cy) / camera.fy), 1.0F);
      rays.ray.org_x[i] = origin.x();
      rays.ray.org_y[i] = origin.y();
      rays.ray.org_z[i] = origin.z();
      rays.ray.dir_x[i] = direction.x();
      rays.ray.dir_y[i] = direction.y();
      rays.ray.dir_z[i] = direction.z();
      rays.ray.tnear[i] = 0.0F;
      rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
      rays.ray.time[i] = 0.0F;
      rays.ray.mask[i] = ~0U;
      rays.ray.id[i] = i;
      rays.ray.flags[i] = 0;
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    intersectCoherent(valid, still_->scene(), &rays);
    float nearest[kPacket];
    std::copy(rays.ray.tfar, rays.ray.tfar + kPacket, nearest);
    if (!moving_->empty()) intersectCoherent(valid, moving_->scene(), &rays);

    for (std::uint32_t i = 0; i < kPacket; ++i) {
      if (valid[i] == 0) continue;
      const std::size_t pixel =
          (top + i / kPacketWidth) * std::size_t{camera.width} + left + i % kPacketWidth;
      if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
        image.depth[pixel] = std::numeric_limits<float>::quiet_NaN();
        image.cosine[pixel] = 0.0F;
        image.reflectance[pixel] = 0.0F;
        image.surface[pixel] = Surface::kNone;
        image.plane[pixel] = ScenePlanes::kNone;
        continue;
      }
      const Body& body = rays.ray.tfar[i] < nearest[i] ? *moving_ : *still_;
      const Material& material = body.material(rays.hit.primID[i]);
      const Eigen::Vector3f normal(rays.hit.Ng_x[i], rays.hit.Ng_y[i], rays.hit.Ng_z[i]);
      const Eigen::Vector3f direction(rays.ray.dir_x[i], rays.ray.dir_y[i], rays.ray.dir_z[i]);
      image.depth[pixel] = rays.ray.tfar[i];
      image.cosine[pixel] =
          std::abs(normal.dot(direction)) / std::sqrt(normal.squaredNorm() * direction.squaredNorm());
      image.reflectance[pixel] = material.reflectance;
      image.surface[pixel] = material.surface;
      image.plane[pixel] = material.plane;
    }
  }

  const Scene* scene_;
  const ScenePlanes planes_;
  RTCDevice device_;
  std::unique_ptr<Body> still_;
  std::unique_ptr<Body> moving_;
  std::vector<Solid> people_;
};

RayCaster::RayCaster(const Scene& scene) : device_(std::make_unique<Device>(scene)) {}
RayCaster::~RayCaster() = default;

const ScenePlanes& RayCaster::planes() const
{
  return device_->planes();
}

void RayCaster::cast(const PinholeCamera& camera, const Eigen::Isometry3d& camera_to_world, double time,
                     RayImage& image)
{
  image.depth.resize(camera.size());
  image.cosine.resize(camera.size());
  image.reflectance.resize(camera.size());
  image.surface.resize(camera.size());
  image.plane.resize(camera.size());
  device_->move(time);
  device_->cast(camera, camera_to_world, image);
}

}  // namespace polygonal_perception::simulation
