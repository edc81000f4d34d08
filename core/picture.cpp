#include "core/picture.h"

namespace overstrike {

std::string_view to_string(Kind kind) {
  switch (kind) {
    case Kind::lit:
      return "lit";
    case Kind::shade:
      return "shade";
    case Kind::shadow:
      return "shadow";
    case Kind::ground_shadow:
      return "ground shadow";
    case Kind::cut:
      return "cut";
  }
  return "";
}

std::string_view to_string(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::contour:
      return "contour";
    case StrokeKind::crease:
      return "crease";
    case StrokeKind::intersection:
      return "intersection";
    case StrokeKind::shadow_outline:
      return "shadow outline";
    case StrokeKind::pattern:
      return "pattern";
    case StrokeKind::segment:
      return "segment";
    case StrokeKind::cut_outline:
      return "cut outline";
  }
  return "";
}

}  // namespace overstrike
