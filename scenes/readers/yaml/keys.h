#pragma once
// Every key of a scene file, map by map: what the reader accepts and the schema describes.
#include <span>
#include <string>
#include <string_view>

namespace overstrike::yaml {

using Keys = std::span<const std::string_view>;

/// One kind of map. `shorthand`, if any, is the key that a value which is no map stands for:
/// `sphere: 2` is `sphere: {radius: 2}`.
struct MapKind {
  std::string_view name;
  Keys keys;
  std::string_view shorthand = {};
};

extern const MapKind kSceneMap, kLightMap, kCameraMap, kDensityMap, kBodyMap, kPatternMap,
    kSegmentMap, kRotateMap, kTransformMap, kArrayMap, kLinearMap, kPolarMap, kFaceMap;
extern const MapKind kBoxMap, kPrismMap, kCylinderMap, kPyramidMap, kConeMap, kFrustumMap,
    kWedgeMap, kTetrahedronMap, kSphereMap, kEllipsoidMap, kTorusMap, kExtrusionMap, kRevolutionMap,
    kSweepMap, kPolyhedronMap, kPolygonMap, kMeshMap, kRegionMap, kCircleMap;

/// All of the above.
std::span<const MapKind* const> all_maps();

/// The keys of a body that say what it is: the shapes, the set operations, `group` and
/// `use`.
Keys content_keys();

/// The same of a plane region.
Keys region_content_keys();

/// "did you mean 'radius'?" for an unknown key: by spelling, or a word of other programs for the
/// same thing; or empty.
std::string suggestion(std::string_view word, Keys known);

}  // namespace overstrike::yaml
