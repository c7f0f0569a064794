#include <geos_c.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "polygon_methods.hpp"

namespace polygonal_perception::evaluation {
namespace {

class GeosMethod : public PolygonMethod
{
public:
  GeosMethod() : geos_(GEOS_init_r()) {}
  GeosMethod(const GeosMethod&) = delete;
  GeosMethod(GeosMethod&&) = delete;
  GeosMethod& operator=(const GeosMethod&) = delete;
  GeosMethod& operator=(GeosMethod&&) = delete;
  ~GeosMethod() override { GEOS_finish_r(geos_); }

  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    GEOSGeometry* const outlines = makeOutlines(task.outlines);
    GEOSGeometry* const simplified = simplify(geos_, outlines, task);
    GEOSGeom_destroy_r(geos_, outlines);
    if (simplified == nullptr) throw std::runtime_error(name() + " has failed");
    polygons.clear();
    const int count = GEOSGetNumGeometries_r(geos_, simplified);
    for (int n = 0; n < count; ++n) {
      const GEOSGeometry* const polygon = GEOSGetGeometryN_r(geos_, simplified, n);
      if (GEOSisEmpty_r(geos_, polygon) != 0) continue;
      read(GEOSGetExteriorRing_r(geos_, polygon), false, polygons);
      const int holes = GEOSGetNumInteriorRings_r(geos_, polygon);
      for (int hole = 0; hole < holes; ++hole)
        read(GEOSGetInteriorRingN_r(geos_, polygon, hole), true, polygons);
    }
    GEOSGeom_destroy_r(geos_, simplified);
  }

private:
  virtual GEOSGeometry* simplify(GEOSContextHandle_t geos, const GEOSGeometry* outlines,
                                 const PolygonTask& task) const = 0;

  GEOSGeometry* makeRing(const geometry::RingView& ring) const
  {
    const auto size = static_cast<unsigned>(ring.size());
    GEOSCoordSequence* const points = GEOSCoordSeq_create_r(geos_, size + 1, 2);
    for (unsigned k = 0; k < size; ++k) GEOSCoordSeq_setXY_r(geos_, points, k, ring[k].x(), ring[k].y());
    GEOSCoordSeq_setXY_r(geos_, points, size, ring[0].x(), ring[0].y());
    return GEOSGeom_createLinearRing_r(geos_, points);
  }

  GEOSGeometry* makeOutlines(const geometry::PolygonSet& outlines) const
  {
    std::vector<GEOSGeometry*> polygons;
    for (std::size_t r = 0; r < outlines.rings.size();) {
      GEOSGeometry* const boundary = makeRing(outlines.view(outlines.rings[r]));
      std::vector<GEOSGeometry*> holes;
      for (++r; r < outlines.rings.size() && outlines.rings[r].hole; ++r)
        holes.push_back(makeRing(outlines.view(outlines.rings[r])));
      polygons.push_back(GEOSGeom_createPolygon_r(geos_, boundary, holes.empty() ? nullptr : holes.data(),
                                                  static_cast<unsigned>(holes.size())));
    }
    return GEOSGeom_createCollection_r(geos_, GEOS_MULTIPOLYGON, polygons.empty() ? nullptr : polygons.data(),
                                       static_cast<unsigned>(polygons.size()));
  }

  void read(const GEOSGeometry* ring, bool hole, geometry::PolygonSet& polygons)
  {
    const GEOSCoordSequence* const points = GEOSGeom_getCoordSeq_r(geos_, ring);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(geos_, points, &size);
    ring_.resize(size - 1);  // the first point is repeated
    for (unsigned k = 0; k + 1 < size; ++k) GEOSCoordSeq_getXY_r(geos_, points, k, &ring_[k].x, &ring_[k].y);
    // GEOS promises no orientation.
    char counter_clockwise = 0;
    GEOSCoordSeq_isCCW_r(geos_, points, &counter_clockwise);
    if ((counter_clockwise != 0) == hole) std::reverse(ring_.begin(), ring_.end());
    addRing(ring_, hole, polygons);
  }

  GEOSContextHandle_t geos_;
  std::vector<cv::Point2d> ring_;
};

class TopologyPreserving : public GeosMethod
{
public:
  std::string name() const override { return "GEOS TopologyPreservingSimplifier"; }

private:
  GEOSGeometry* simplify(GEOSContextHandle_t geos, const GEOSGeometry* outlines,
                         const PolygonTask& task) const override
  {
    return GEOSTopologyPreserveSimplify_r(geos, outlines, task.tolerance);
  }
};

#if GEOS_VERSION_MAJOR > 3 || GEOS_VERSION_MINOR >= 11
/// It has no tolerance: it may add as much area as this package does.
class OuterHull : public GeosMethod
{
public:
  std::string name() const override { return "GEOS PolygonHullSimplifier, outer, same area"; }

private:
  GEOSGeometry* simplify(GEOSContextHandle_t geos, const GEOSGeometry* outlines,
                         const PolygonTask& task) const override
  {
    return GEOSPolygonHullSimplifyMode_r(geos, outlines, 1, GEOSHULL_PARAM_AREA_RATIO, task.added_share);
  }
};
#endif

}  // namespace

std::vector<std::unique_ptr<PolygonMethod>> makeGeosMethods()
{
  std::vector<std::unique_ptr<PolygonMethod>> methods;
  methods.push_back(std::make_unique<TopologyPreserving>());
#if GEOS_VERSION_MAJOR > 3 || GEOS_VERSION_MINOR >= 11
  methods.push_back(std::make_unique<OuterHull>());
#endif
  return methods;
}

}  // namespace polygonal_perception::evaluation
