#pragma once
// The lines that may be drawn: where they are and what they are, not yet whether they are seen.
#include <vector>

#include "core/drawing.h"
#include "core/visibility/face_index.h"
#include "core/visibility/shadows.h"
#include "core/visibility/sight_line.h"

namespace overstrike {

bool wanted(StrokeKind kind, const StrokeOptions& options);

/// Per body: 1 when its facets stand for curved surfaces.
std::vector<char> curved_bodies(const Canonical& canonical);

/// Contours (edges of a face that is seen and of one that is not, or that is seen from the other
/// side, or of none), creases (real edges of two seen faces) and outlines of cuts.
void add_edges(const ProjectedScene& scene, const StrokeOptions& options,
               std::vector<SightLine>& lines);

/// Patterns lie on the plane of a face of their body when they are nearer to it than `tolerance`
/// grid units are there; they are left out where the face is not seen.
void add_patterns(const ProjectedScene& scene, double tolerance, std::vector<SightLine>& lines);

void add_segments(const ProjectedScene& scene, std::vector<SightLine>& lines);

/// Where seen faces of bodies that may cross meet each other and the ground. Faces of one body that
/// share a corner are taken for neighbours that do not cross.
void add_intersections(const ProjectedScene& scene, const FaceIndex& index,
                       std::vector<SightLine>& lines);

/// Where shadow ends on its receivers, whoever casts it; `casting` as in ShadowCaster.
void add_shadow_outlines(const ProjectedScene& scene, const FaceIndex& index,
                         const Canonical& casting, const std::vector<Shadow>& shadows,
                         std::vector<SightLine>& lines);

}  // namespace overstrike
