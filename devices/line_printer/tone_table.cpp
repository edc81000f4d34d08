#include "devices/line_printer/tone_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "core/error.h"

namespace overstrike {
namespace {

using Cost = std::int64_t;
using Set = std::vector<int>;  // indexes of glyphs

/// 1/64 of a step squared: what a strike costs.
constexpr Cost kStrikesInSquaredStep = 64;
constexpr Cost kUnreachable = std::numeric_limits<Cost>::max();

struct Candidate {
  int ink;
  Set set;
};

class Search {
 public:
  Search(const Alphabet& alphabet, int levels, int strikes)
      : glyphs_(alphabet.glyphs),
        pixels_(alphabet.cell_pixels),
        last_(levels - 1),
        strikes_(strikes) {}

  ToneTable table() {
    find_darkest();
    offer(0, {});
    offer_singles_and_pairs();
    for (int level = 1; level < last_; ++level) offer_for(level);
    offer(darkest_.ink, darkest_.set);
    return table_of(chosen());
  }

 private:
  int size() const { return static_cast<int>(glyphs_.size()); }

  // --- candidates: for every amount of ink the first smallest set that was found

  void offer(int ink, const Set& set) {
    if (ink > darkest_.ink) return;
    const auto [place, is_new] = pool_.try_emplace(ink, set);
    if (!is_new && set.size() < place->second.size()) place->second = set;
  }

  void offer_singles_and_pairs() {
    for (int a = 0; a < size(); ++a) {
      offer(glyphs_[a].count, {a});
      for (int b = a + 1; strikes_ > 1 && b < size(); ++b)
        offer(glyphs_[a].ink.count_with(glyphs_[b].ink), {a, b});
    }
  }

  /// Strike after strike the one that blackens most; then exchanges, until none helps.
  void find_darkest() {
    Ink all(pixels_);
    for (int k = 0; k < strikes_; ++k) {
      int best = -1, most = darkest_.ink;
      for (int g = 0; g < size(); ++g)
        if (const int ink = all.count_with(glyphs_[g].ink); ink > most) best = g, most = ink;
      if (best < 0) break;
      all.add(glyphs_[best].ink);
      darkest_.set.push_back(best);
      darkest_.ink = most;
    }
    greedy_ = darkest_.set;
    approach(darkest_, pixels_);
    drop_idle(darkest_.set);
  }

  /// Tries sets of three strikes and more for a level, while fewer have not come near enough.
  void offer_for(int level) {
    const int wish = static_cast<int>((Cost{darkest_.ink} * level + last_ / 2) / last_);
    const int near = darkest_.ink / (8 * last_);
    const int most = static_cast<int>(greedy_.size());
    for (int k = 3; k <= most && nearest_error(wish) > near; ++k) {
      Candidate start{0, Set(greedy_.begin(), greedy_.begin() + k)};
      start.ink = ink_of(start.set);
      approach(start, wish);
      drop_idle(start.set);
      offer(start.ink, start.set);
    }
  }

  int nearest_error(int wish) const {
    int error = pixels_;
    const auto above = pool_.lower_bound(wish);
    if (above != pool_.end()) error = above->first - wish;
    if (above != pool_.begin()) error = std::min(error, wish - std::prev(above)->first);
    return error;
  }

  int ink_of(const Set& set) const {
    Ink all(pixels_);
    for (const int g : set) all.add(glyphs_[g].ink);
    return all.count();
  }

  /// Exchanges one strike at a time for the one that comes nearest to the wish, until none does.
  void approach(Candidate& candidate, int wish) const {
    for (bool better = true; better;) {
      better = false;
      for (std::size_t place = 0; place < candidate.set.size(); ++place)
        better |= exchange(candidate, place, wish);
    }
  }

  bool exchange(Candidate& candidate, std::size_t place, int wish) const {
    Ink rest(pixels_);
    for (std::size_t i = 0; i < candidate.set.size(); ++i)
      if (i != place) rest.add(glyphs_[candidate.set[i]].ink);
    bool better = false;
    for (int g = 0; g < size(); ++g) {
      const int ink = rest.count_with(glyphs_[g].ink);
      if (std::abs(ink - wish) >= std::abs(candidate.ink - wish)) continue;
      candidate.ink = ink, candidate.set[place] = g, better = true;
    }
    return better;
  }

  /// Takes out strikes that add no ink to the others.
  void drop_idle(Set& set) const {
    const int ink = ink_of(set);
    for (std::size_t place = set.size(); place-- > 0;) {
      Set fewer = set;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(place));
      if (ink_of(fewer) == ink) set = std::move(fewer);
    }
  }

  // --- choice: the cheapest strictly rising sequence

  /// In units of (1/8 pixel / (levels - 1))^2, so that all is whole.
  Cost cost(int level, int ink, std::size_t strikes) const {
    const Cost error = Cost{ink} * last_ - Cost{darkest_.ink} * level;
    const Cost step = darkest_.ink;
    return kStrikesInSquaredStep * error * error + step * step * static_cast<Cost>(strikes);
  }

  /// best[i][j]: the least cost of levels 0..i of which level i is the j-th candidate. From it the
  /// sequence is read backwards.
  std::vector<Candidate> chosen() const {
    const std::vector<Candidate> pool = pool_in_order();
    const std::size_t count = pool.size();
    std::vector<std::vector<Cost>> best(last_ + 1, std::vector<Cost>(count, kUnreachable));
    best[0][0] = 0;
    for (int level = 1; level <= last_; ++level) {
      Cost before = kUnreachable;
      for (std::size_t j = 1; j < count; ++j) {
        before = std::min(before, best[level - 1][j - 1]);
        if (before != kUnreachable)
          best[level][j] = before + cost(level, pool[j].ink, pool[j].set.size());
      }
    }
    if (best[last_][count - 1] == kUnreachable) too_few(static_cast<int>(count));
    return read_back(best, pool);
  }

  std::vector<Candidate> pool_in_order() const {
    std::vector<Candidate> pool;
    for (const auto& [ink, set] : pool_) pool.push_back({ink, set});
    return pool;
  }

  std::vector<Candidate> read_back(const std::vector<std::vector<Cost>>& best,
                                   const std::vector<Candidate>& pool) const {
    std::vector<Candidate> sequence(last_ + 1);
    auto end = static_cast<std::ptrdiff_t>(pool.size()) - 1;
    sequence[last_] = pool[end];
    for (int level = last_ - 1; level >= 0; --level) {
      const auto first = best[level].begin();
      end = std::min_element(first, first + end) - first;
      sequence[level] = pool[end];
    }
    return sequence;
  }

  [[noreturn]] void too_few(int tones) const {
    throw InputError(
        Place{}, fmt::format("levels must be at most {}, the tones that this type face has with {} "
                             "strike{} a cell, found '{}'",
                             tones, strikes_, strikes_ == 1 ? "" : "s", last_ + 1));
  }

  ToneTable table_of(std::vector<Candidate> sequence) const {
    ToneTable table{{}, pixels_};
    for (Candidate& level : sequence) {
      std::stable_sort(level.set.begin(), level.set.end(),
                       [&](int a, int b) { return glyphs_[a].count > glyphs_[b].count; });
      std::string strikes;
      for (const int g : level.set) strikes += glyphs_[g].character;
      table.levels.push_back({strikes, level.ink});
    }
    return table;
  }

  const std::vector<Glyph>& glyphs_;
  int pixels_;
  int last_;  // the darkest level's number
  int strikes_;
  Set greedy_;
  Candidate darkest_{0, {}};
  std::map<int, Set> pool_;
};

}  // namespace

int ToneTable::most_strikes() const {
  std::size_t most = 0;
  for (const Level& level : levels) most = std::max(most, level.strikes.size());
  return static_cast<int>(most);
}

ToneTable make_tone_table(const Alphabet& alphabet, int levels, int strikes) {
  return Search(alphabet, levels, strikes).table();
}

int nearest_level(float density, int levels) {
  // A density is an area average in float: rounding moves it by up to 2^-25, and three bits are
  // left for the sum that made it.
  constexpr double kNoise = 0x1p-22;
  if (!(density > 0)) return 0;
  if (density >= 1) return levels - 1;
  const int last = levels - 1;
  return std::min(last, static_cast<int>((density + kNoise) * last + 0.5));
}

}  // namespace overstrike
