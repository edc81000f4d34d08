#pragma once
// Typed reading of YAML values. Whatever is wrong is reported at its place, and a harmless value
// returned, so that reading goes on and finds the other errors.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec.h"
#include "scenes/readers/yaml/keys.h"
#include "scenes/readers/yaml/tree.h"

namespace overstrike::yaml {

/// Numbers beyond this, and lengths other than zero below its inverse, are refused: products of a
/// few of them stay in a double's range, with room for the determinants of degree 5 of core.
constexpr double kLargest = 1e30;

/// Which numbers are meant.
struct Range {
  double low = -kLargest;
  double high = kLargest;
  bool open = false;            ///< the ends themselves are not allowed
  std::string_view words = {};  ///< "must be positive"; empty: "must lie between low and high"
};
constexpr Range kAny{};
constexpr Range kPositive{1 / kLargest, kLargest, false, "must be positive"};
constexpr Range kNotNegative{0, kLargest, false, "must not be negative"};
constexpr Range kZeroToOne{0, 1, false, {}};

/// `label` names the value in messages.
double number(Reporter&, const Node&, std::string_view label, const Range& = kAny);
/// Whole; ranges as above.
int whole_number(Reporter&, const Node&, std::string_view label, int low, int high);
bool boolean(Reporter&, const Node&, std::string_view label);
/// Not empty, at most 100 bytes.
std::string word(Reporter&, const Node&, std::string_view label);
/// One of some words; its index, or 0 after an error.
std::size_t choice(Reporter&, const Node&, std::string_view label, Keys words);
Vec2 vec2(Reporter&, const Node&, std::string_view label);
Vec3 vec3(Reporter&, const Node&, std::string_view label, const Range& = kAny);
/// At least `fewest` points.
std::vector<Vec2> points2(Reporter&, const Node&, std::string_view label, std::size_t fewest);
std::vector<Vec3> points3(Reporter&, const Node&, std::string_view label, std::size_t fewest);
/// The values of a list of at least `fewest`; of anything else none, after an error.
const std::vector<const Node*>& list(Reporter&, const Node&, std::string_view label,
                                     std::string_view of_what, std::size_t fewest = 0);
bool is_word(const Node&, std::string_view text);

/// The entries of one map of a known kind. Unknown keys, keys given twice and values that are no
/// map are reported once, on construction.
class Fields {
 public:
  Fields(Reporter& reporter, const Node& node, const MapKind& kind);

  /// The value of a key, or null.
  const Node* find(std::string_view key) const;
  /// The same, and its absence is an error, unless it was suggested for an unknown key.
  const Node* need(std::string_view key) const;
  /// True if the key was suggested for an unknown one.
  bool suggested(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }

  double number(std::string_view key, const Range& = kAny) const;
  double number_or(std::string_view key, double otherwise, const Range& = kAny) const;
  int whole_number_or(std::string_view key, int otherwise, int low, int high) const;
  bool boolean_or(std::string_view key, bool otherwise) const;
  Vec3 vec3_or(std::string_view key, const Vec3& otherwise) const;

  Reporter& reporter() const { return reporter_; }
  const TextMark& mark() const { return node_.mark; }
  /// Of the key's value, or of the map when it has none.
  const TextMark& mark(std::string_view key) const;
  const MapKind& kind() const { return kind_; }

 private:
  void check_keys();

  Reporter& reporter_;
  const Node& node_;
  const MapKind& kind_;
  std::string suggested_;  ///< all that was said about unknown keys
  bool usable_ = true;     ///< neither a map nor a shorthand: nothing is missed in it
};

}  // namespace overstrike::yaml
