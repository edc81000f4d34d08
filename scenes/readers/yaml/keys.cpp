#include "scenes/readers/yaml/keys.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenes/readers/nearest.h"
#include "scenes/readers/source_text.h"

namespace overstrike::yaml {
namespace {

using S = std::string_view;

constexpr S kScene[] = {"ground", "light", "camera", "density", "define", "bodies", "segments"};
constexpr S kLight[] = {"azimuth", "elevation"};
constexpr S kCamera[] = {"look-at", "distance",   "azimuth", "elevation", "eye", "target",
                         "up",      "projection", "window",  "fov",       "near"};
constexpr S kDensity[] = {"k", "hmax", "ground-shadow", "cut"};
// what it is first, then how it looks, then where it stands
constexpr S kBody[] = {
    "box",         "prism",   "cylinder",  "pyramid", "cone",       "frustum",      "wedge",
    "tetrahedron", "sphere",  "ellipsoid", "torus",   "extrusion",  "revolution",   "sweep",
    "polyhedron",  "polygon", "mesh",      "union",   "difference", "intersection", "group",
    "use",         "name",    "density",   "shading", "pen",        "patterns",     "translucent",
    "scale",       "mirror",  "rotate",    "at",      "transform",  "array"};
constexpr std::size_t kContents = 22;
static_assert(kBody[kContents - 1] == "use");
constexpr S kPattern[] = {"points", "closed", "pen"};
constexpr S kSegment[] = {"from", "to", "points", "closed", "pen"};
constexpr S kRotate[] = {"axis", "angle"};
constexpr S kTransform[] = {"scale", "mirror", "rotate", "at"};
constexpr S kArray[] = {"linear", "polar"};
constexpr S kLinear[] = {"count", "step"};
constexpr S kPolar[] = {"count", "step", "axis", "center"};
constexpr S kFace[] = {"outline", "holes"};

constexpr S kBox[] = {"size"};
constexpr S kPrism[] = {"sides", "radius", "height"};
constexpr S kCylinder[] = {"radius", "height", "sides"};
constexpr S kFrustum[] = {"bottom", "top", "height", "sides"};
constexpr S kWedge[] = {"size", "top", "shift"};
constexpr S kTetrahedron[] = {"vertices"};
constexpr S kSphere[] = {"radius", "sides", "rings"};
constexpr S kEllipsoid[] = {"radii", "sides", "rings"};
constexpr S kTorus[] = {"major", "minor"};
constexpr S kExtrusion[] = {"outline", "holes", "region", "height"};
constexpr S kRevolution[] = {"profile", "region", "angle", "sides"};
constexpr S kSweep[] = {"profile", "region", "path", "closed"};
constexpr S kPolyhedron[] = {"vertices", "faces"};
constexpr S kPolygon[] = {"outline", "holes", "region"};
// what it is first, then where it lies
constexpr S kRegion[] = {"outline",      "rectangle", "circle", "union", "difference",
                         "intersection", "scale",     "rotate", "at"};
constexpr std::size_t kRegionContents = 6;
static_assert(kRegion[kRegionContents - 1] == "intersection");
constexpr S kCircle[] = {"radius", "sides"};
constexpr S kMesh[] = {"file"};

// What other programs call it, and ours.
constexpr std::pair<S, S> kOtherWords[] = {{"<<", "use"},
                                           {"centre", "center"},
                                           {"children", "group"},
                                           {"color", "density"},
                                           {"colour", "density"},
                                           {"copies", "array"},
                                           {"cube", "box"},
                                           {"cuboid", "box"},
                                           {"definitions", "define"},
                                           {"donut", "torus"},
                                           {"h", "height"},
                                           {"instance", "use"},
                                           {"move", "at"},
                                           {"n", "sides"},
                                           {"objects", "bodies"},
                                           {"points", "outline"},
                                           {"polygon", "outline"},
                                           {"polyline", "points"},
                                           {"pos", "at"},
                                           {"position", "at"},
                                           {"r", "radius"},
                                           {"repeat", "array"},
                                           {"minus", "difference"},
                                           {"subtract", "difference"},
                                           {"intersect", "intersection"},
                                           {"unite", "union"},
                                           {"ring", "torus"},
                                           {"shapes", "bodies"},
                                           {"square", "rectangle"},
                                           {"to", "target"},
                                           {"translate", "at"},
                                           {"tube", "minor"},
                                           {"turn", "rotate"},
                                           {"vertices", "outline"},
                                           {"width", "window"}};

}  // namespace

const MapKind kSceneMap{"scene", kScene};
const MapKind kLightMap{"light", kLight};
const MapKind kCameraMap{"camera", kCamera};
const MapKind kDensityMap{"density", kDensity};
const MapKind kBodyMap{"body", kBody};
const MapKind kPatternMap{"pattern", kPattern};
const MapKind kSegmentMap{"segment", kSegment};
const MapKind kRotateMap{"rotate", kRotate};
const MapKind kTransformMap{"step", kTransform};
const MapKind kArrayMap{"array", kArray};
const MapKind kLinearMap{"linear", kLinear};
const MapKind kPolarMap{"polar", kPolar};
const MapKind kFaceMap{"face", kFace, "outline"};
const MapKind kBoxMap{"box", kBox, "size"};
const MapKind kPrismMap{"prism", kPrism};
const MapKind kCylinderMap{"cylinder", kCylinder};
const MapKind kPyramidMap{"pyramid", kPrism};
const MapKind kConeMap{"cone", kCylinder};
const MapKind kFrustumMap{"frustum", kFrustum};
const MapKind kWedgeMap{"wedge", kWedge};
const MapKind kTetrahedronMap{"tetrahedron", kTetrahedron, "vertices"};
const MapKind kSphereMap{"sphere", kSphere, "radius"};
const MapKind kEllipsoidMap{"ellipsoid", kEllipsoid, "radii"};
const MapKind kTorusMap{"torus", kTorus};
const MapKind kExtrusionMap{"extrusion", kExtrusion};
const MapKind kRevolutionMap{"revolution", kRevolution};
const MapKind kSweepMap{"sweep", kSweep};
const MapKind kPolyhedronMap{"polyhedron", kPolyhedron};
const MapKind kPolygonMap{"polygon", kPolygon, "outline"};
const MapKind kMeshMap{"mesh", kMesh, "file"};
const MapKind kRegionMap{"region", kRegion, "outline"};
const MapKind kCircleMap{"circle", kCircle, "radius"};

std::span<const MapKind* const> all_maps() {
  static constexpr std::array kAll{
      &kSceneMap,       &kLightMap,   &kCameraMap,     &kDensityMap,   &kBodyMap,
      &kPatternMap,     &kSegmentMap, &kRotateMap,     &kTransformMap, &kArrayMap,
      &kLinearMap,      &kPolarMap,   &kFaceMap,       &kBoxMap,       &kPrismMap,
      &kCylinderMap,    &kPyramidMap, &kConeMap,       &kFrustumMap,   &kWedgeMap,
      &kTetrahedronMap, &kSphereMap,  &kEllipsoidMap,  &kTorusMap,     &kExtrusionMap,
      &kRevolutionMap,  &kSweepMap,   &kPolyhedronMap, &kPolygonMap,   &kMeshMap,
      &kRegionMap,      &kCircleMap};
  return kAll;
}

std::string suggestion(std::string_view word, Keys known) {
  const std::string near = did_you_mean(word, known);
  if (!near.empty()) return near;
  for (const auto& [theirs, ours] : kOtherWords)
    if (theirs == word && std::find(known.begin(), known.end(), ours) != known.end())
      return "did you mean " + in_quotes(ours) + "?";
  return {};
}

Keys region_content_keys() { return Keys(kRegion).first(kRegionContents); }

Keys content_keys() { return Keys(kBody).first(kContents); }

}  // namespace overstrike::yaml
