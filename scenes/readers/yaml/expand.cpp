#include <algorithm>
#include <cmath>

#include "core/geometry/tessellate.h"
#include "scenes/readers/nearest.h"
#include "scenes/readers/yaml/parts.h"

namespace overstrike::yaml {
namespace {

constexpr std::uint64_t kMostPatternPoints = 10'000'000;
// Uses within groups within definitions ...: walks recurse so deep.
constexpr int kDeepestUse = 256;

Cost operator+(const Cost& a, const Cost& b) {
  return {std::min(kUncountable, a.parts + b.parts), std::min(kUncountable, a.points + b.points)};
}

Cost operator*(const Cost& a, std::uint64_t times) {
  // both at most 2^32: the products fit
  return {std::min(kUncountable, a.parts * times), std::min(kUncountable, a.points * times)};
}

/// Of a group or a solid; null of others.
const std::vector<Part>* members_of(const Part& part) {
  if (const auto* solid = std::get_if<Combination>(&part.content)) return &solid->members;
  return std::get_if<std::vector<Part>>(&part.content);
}

/// Follows uses, to find circles and to count what the scene becomes before anything is made.
class Census {
 public:
  Census(Reporter& reporter, const Definitions& definitions)
      : reporter_(reporter), definitions_(definitions) {}

  Cost count(const Part& part, int depth) {
    Cost cost;
    if (const std::vector<Part>* const members = members_of(part)) {
      for (const Part& member : *members) cost = cost + count(member, depth + 1);
    } else if (const auto* use = std::get_if<Use>(&part.content)) {
      cost = count(*use, depth + 1);
    }
    deepest_ = std::max(deepest_, depth);
    cost = cost + Cost{1, 0};
    for (const Pattern& pattern : part.patterns) cost.points += pattern.points.size();
    for (const Array& array : part.arrays) cost = cost * static_cast<std::uint64_t>(array.count);
    return cost;
  }

 private:
  /// What is known of a definition once it was walked.
  struct Known {
    bool done = false;
    Cost cost;
    int height = 0;
  };

  Cost count(const Use& use, int depth) {
    if (use.name.empty()) return {};
    const auto found = definitions_.find(use.name);
    if (found == definitions_.end()) {
      unknown(use);
      return {};
    }
    const auto [at, fresh] = known_.try_emplace(&found->second);
    Known& known = at->second;
    if (!fresh && !known.done) {
      circle(use);
      return {};
    }
    if (depth + known.height > kDeepestUse) {
      reporter_.error(use.mark, "definitions and groups nest deeper than 256");
      return {};
    }
    if (known.done) {
      deepest_ = std::max(deepest_, depth + known.height);
      return known.cost;
    }
    return walk(found->first, found->second, known, depth);
  }

  Cost walk(const std::string& name, const Definition& definition, Known& known, int depth) {
    open_.push_back(&name);
    const int deepest_before = deepest_;
    deepest_ = depth;
    known.cost = count(definition.part, depth);
    known.height = deepest_ - depth;
    known.done = true;
    deepest_ = std::max(deepest_, deepest_before);
    open_.pop_back();
    return known.cost;
  }

  void unknown(const Use& use) {
    std::vector<std::string_view> names;
    if (!reporter_.full())
      for (const auto& [name, definition] : definitions_) names.push_back(name);
    reporter_.error(use.mark, "nothing is defined as " + in_quotes(use.name),
                    did_you_mean(use.name, names));
  }

  void circle(const Use& use) {
    std::string names;
    auto first = std::find_if(open_.begin(), open_.end(),
                              [&](const std::string* name) { return *name == use.name; });
    for (; first != open_.end(); ++first) names += **first + " -> ";
    reporter_.error(use.mark, "definitions go in a circle: " + names + use.name);
  }

  Reporter& reporter_;
  const Definitions& definitions_;
  std::map<const Definition*, Known> known_;
  std::vector<const std::string*> open_;  ///< the definitions that the walk is inside of
  int deepest_ = 0;
};

/// What a group or a use hands down to its members.
struct Inherited {
  Affine placement;
  double density = 1;
  std::string_view name;
  std::optional<Shading> shading;
  std::optional<int> pen;
};

class Expander {
 public:
  Expander(Reporter& reporter, const Definitions& definitions)
      : reporter_(reporter), definitions_(definitions) {}

  void add(const Part& part, const Inherited& above) {
    std::uint64_t copies = 1;
    for (const Array& array : part.arrays) copies *= static_cast<std::uint64_t>(array.count);
    // In a solid's tree copies are one operand.
    const bool united = solid_ != nullptr && copies != 1;
    const std::size_t node = united ? begin(SetOperation::unite) : 0;
    for (std::uint64_t copy = 0; copy < copies; ++copy) {
      Affine place = part.placement;
      std::uint64_t rest = copy;  // mixed radix: the first array's copies come first
      for (const Array& array : part.arrays) {
        const auto count = static_cast<std::uint64_t>(array.count);
        place = array.place(static_cast<int>(rest % count)) * place;
        rest /= count;
      }
      add_copy(part, handed_down(part, place, above));
    }
    if (united) end(node);
  }

  Expanded result;

 private:
  static Inherited handed_down(const Part& part, const Affine& place, const Inherited& above) {
    std::string_view name = part.name;
    if (const auto* use = std::get_if<Use>(&part.content); use && name.empty()) name = use->name;
    return {above.placement * place, std::min(kLargest, above.density * part.density),
            name.empty() ? above.name : name, part.shading ? part.shading : above.shading,
            part.pen ? part.pen : above.pen};
  }

  void add_copy(const Part& part, const Inherited& mine) {
    if (const auto* combination = std::get_if<Combination>(&part.content)) {
      combine(part, *combination, mine);
    } else if (const auto* group = std::get_if<std::vector<Part>>(&part.content)) {
      const std::size_t node = solid_ != nullptr ? begin(SetOperation::unite) : 0;
      for (const Part& member : *group) add(member, mine);
      if (solid_ != nullptr) end(node);
    } else if (const auto* use = std::get_if<Use>(&part.content)) {
      add(definitions_.find(use->name)->second.part, mine);
    } else {
      add_body(part, std::get<ShapePtr>(part.content), mine);
    }
  }

  /// A tree of its own, or a node of the one that it stands in.
  void combine(const Part& part, const Combination& combination, const Inherited& mine) {
    Solid solid{{}, std::string(mine.name), reporter_.place(part.mark), 0};
    const bool is_root = solid_ == nullptr;
    if (is_root) solid_ = &solid;
    solid_->translucent = std::max(solid_->translucent, combination.translucent);
    const std::size_t node = begin(combination.operation);
    for (const Part& member : combination.members) add(member, mine);
    end(node);
    if (!is_root) return;
    solid_ = nullptr;
    result.solids.push_back(std::move(solid));
  }

  std::size_t begin(SetOperation operation) {
    solid_->nodes.push_back({operation, 0, 0});
    return solid_->nodes.size() - 1;
  }
  void end(std::size_t node) {
    solid_->nodes[node].end = static_cast<std::uint32_t>(solid_->nodes.size());
  }

  void add_body(const Part& part, const ShapePtr& shape, const Inherited& mine) {
    if (!usable(mine.placement)) {
      reporter_.error(part.mark,
                      "the transforms of this body together grow beyond 1e30 or shrink to nothing");
      return;
    }
    if (solid_ != nullptr) {
      const std::size_t node = begin(SetOperation::operand);
      solid_->nodes[node].body = static_cast<std::uint32_t>(result.bodies.size());
      end(node);
    }
    Body& body = result.bodies.emplace_back();
    body.shape = shape;
    body.placement = mine.placement;
    body.name = mine.name;
    body.density_factor = mine.density;
    body.shading = mine.shading.value_or(is_curved(*shape) ? Shading::smooth : Shading::flat);
    body.pen = mine.pen.value_or(0);
    body.patterns = part.patterns;
    body.place = reporter_.place(part.mark);
  }

  static bool usable(const Affine& a) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (!(std::fabs(a.linear[i][j]) <= kLargest) || !(std::fabs(a.offset[j]) <= kLargest))
          return false;
    return std::fabs(glm::determinant(a.linear)) > 0;
  }

  Reporter& reporter_;
  const Definitions& definitions_;
  Solid* solid_ = nullptr;  ///< whose tree is being made
};

bool few_enough(Reporter& reporter, const Part& part, const Cost& cost) {
  if (cost.parts > kMostCopies)
    reporter.error(part.mark, "copies make more than 1000000 bodies and groups of the scene");
  else if (cost.points > kMostPatternPoints)
    reporter.error(part.mark, "copies make more than 10000000 points of patterns");
  else
    return true;
  return false;
}

}  // namespace

Expanded expand(Reporter& reporter, const std::vector<Part>& parts,
                const Definitions& definitions) {
  Census census(reporter, definitions);
  const std::size_t errors_before = reporter.errors();
  for (const auto& [name, definition] : definitions) {
    Part use;
    use.content = Use{name, definition.mark};
    census.count(use, 0);
  }
  Cost total;
  for (const Part& part : parts) {
    total = total + census.count(part, 1);
    if (!few_enough(reporter, part, total)) break;
  }
  if (reporter.errors() > 0) return {};
  Expander expander(reporter, definitions);
  for (const Part& part : parts) expander.add(part, {});
  return reporter.errors() == errors_before ? std::move(expander.result) : Expanded{};
}

}  // namespace overstrike::yaml
