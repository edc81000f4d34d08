#include <algorithm>

#include "core/geometry/shape_faces.h"
#include "core/geometry/sweep_sections.h"

namespace overstrike {
namespace {

class SweepFaces {
 public:
  explicit SweepFaces(const Sweep& sweep)
      : closed_(sweep.closed_path),
        swept_(sections_of(sweep)),
        lines_(line_numbers({swept_.profile}).front()) {
    for (const std::vector<Vec3>& section : swept_.sections)
      out_.vertices.insert(out_.vertices.end(), section.begin(), section.end());
  }

  Polyhedron run() {
    Index straight = 0;  // segments that go on in one direction share their faces' planes
    for (std::size_t i = 0; i < swept_.directions.size(); ++i) {
      if (i > 0 && swept_.directions[i] != swept_.directions[i - 1]) ++straight;
      for (Index e = 0; e < corners(); ++e) add_side(i, e, straight);
    }
    if (!closed_) add_ends();
    drop_lone_planes(out_);
    return std::move(out_);
  }

 private:
  Index corners() const { return static_cast<Index>(swept_.profile.size()); }

  Index vertex(std::size_t section, Index corner) const {
    return static_cast<Index>(section % swept_.sections.size()) * corners() + corner % corners();
  }

  void end_face(Index plane) { out_.plane_groups.push_back(plane); }

  void add_side(std::size_t i, Index e, Index straight) {
    const Index a = vertex(i, e), b = vertex(i, e + 1);
    const Index next_a = vertex(i + 1, e), next_b = vertex(i + 1, e + 1);
    if (swept_.twisted) {
      out_.add_face({a, next_a, next_b});
      end_face(lone_--);
      out_.add_face({a, next_b, b});
      end_face(lone_--);
      return;
    }
    out_.add_face({a, next_a, next_b, b});
    end_face(straight * corners() + lines_[e]);
  }

  void add_ends() {
    std::vector<Index> start, end;
    for (Index c = 0; c < corners(); ++c) {
      start.push_back(vertex(0, c));
      end.push_back(vertex(swept_.sections.size() - 1, c));
    }
    std::reverse(end.begin(), end.end());
    out_.add_face(start);
    end_face(lone_--);
    out_.add_face(end);
    end_face(lone_--);
  }

  const bool closed_;
  const SweepSections swept_;
  const std::vector<Index> lines_;
  Index lone_ = 0xFFFFFFFFu;  ///< next number for a plane of its own, counting down
  Polyhedron out_;
};

}  // namespace

Polyhedron faces_of(const Sweep& sweep) { return SweepFaces(sweep).run(); }

}  // namespace overstrike
