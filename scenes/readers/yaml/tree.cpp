#include "scenes/readers/yaml/tree.h"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>

namespace overstrike::yaml {
namespace {

/// Reads from memory that somebody else owns.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // get areas are char*; nothing is written
    setg(begin, begin, begin + text.size());
  }
};

TextMark from(const YAML::Mark& mark) {
  if (mark.is_null()) return {};
  return {mark.line + 1, mark.column + 1, static_cast<std::size_t>(mark.pos)};
}

/// Ends the parse at the first thing that makes the rest meaningless.
struct Stop {
  TextMark mark;
  std::string message;
  std::string hint;
};

constexpr const char* kTooMany = "more than 4 million values, counting those that aliases repeat";
constexpr const char* kTooDeep = "nested deeper than 480 levels";

}  // namespace

class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(Tree& tree) : tree_(tree) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) throw Stop{from(mark), "a second document; a scene is one", {}};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Node& node = make(NodeKind::nothing, mark, anchor);
    // yaml-cpp places what is not there at whatever follows: say where it is missing instead
    if (!open_.empty() && open_.back()->kind == NodeKind::map && open_.back()->items.size() % 2)
      node.mark = open_.back()->items.back()->mark;
    add(&node);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const Node* target = anchors_.at(anchor);
    if (std::find(open_.begin(), open_.end(), target) != open_.end())
      throw Stop{from(mark), "this alias stands inside the value that it repeats", {}};
    alias_mark_ = from(mark);
    add(target);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    Node& node = make(NodeKind::scalar, mark, anchor);
    node.quoted = tag == "!";
    node.text = value;
    add(&node);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(make(NodeKind::list, mark, anchor));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(make(NodeKind::map, mark, anchor));
  }
  void OnMapEnd() override { close(); }

 private:
  Node& make(NodeKind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (tree_.nodes_.size() >= kMostValues)
      throw Stop{from(mark), kTooMany, "a large mesh belongs in a mesh file"};
    Node& node = tree_.nodes_.emplace_back();
    node.kind = kind;
    node.mark = from(mark);
    alias_mark_ = node.mark;
    if (anchor != 0) {
      anchors_.resize(std::max(anchors_.size(), anchor + 1));
      anchors_[anchor] = &node;
    }
    return node;
  }
  void open(Node& node) {
    if (open_.size() >= static_cast<std::size_t>(kDeepest)) throw Stop{node.mark, kTooDeep, {}};
    open_.push_back(&node);
  }
  void close() {
    const Node* node = open_.back();
    open_.pop_back();
    add(node);
  }
  /// Puts a finished value into the container that is open.
  void add(const Node* node) {
    if (open_.empty()) {
      tree_.root_ = node;
      return;
    }
    Node& parent = *open_.back();
    parent.items.push_back(node);
    parent.expanded += node->expanded;
    parent.height = std::max(parent.height, node->height + 1);
    if (parent.expanded > kMostValues) throw Stop{alias_mark_, kTooMany, {}};
    if (parent.height + static_cast<int>(open_.size()) - 1 > kDeepest)
      throw Stop{alias_mark_, kTooDeep, {}};
  }

  Tree& tree_;
  std::vector<Node*> open_;
  std::vector<const Node*> anchors_;
  TextMark alias_mark_;  ///< of the value last met, for what is found to be too much
  int documents_ = 0;
};

namespace {

// yaml-cpp's scanner looks ahead to the end of an unclosed bracket and keeps a hundred bytes for
// each: more open brackets than this are refused before it sees them. What a plain scan of quotes
// and comments may miscount stays far below.
constexpr int kMostOpenBrackets = 100'000;

/// Offset behind the quoted text that begins at `i`.
std::size_t skip_quoted(std::string_view text, std::size_t i) {
  const char quote = text[i++];
  while (i < text.size() && text[i] != quote) i += quote == '"' && text[i] == '\\' ? 2 : 1;
  return i + 1;
}

/// Where too many brackets are open, or npos.
std::size_t too_many_brackets(std::string_view text) {
  int open = 0;
  bool token_start = true;  // quotes and '#' mean something only there
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (token_start && (c == '"' || c == '\'')) {
      i = skip_quoted(text, i) - 1;
    } else if (token_start && c == '#') {
      i = std::min(text.size(), text.find('\n', i)) - 1;
    } else if (c == '[' || c == '{') {
      if (++open > kMostOpenBrackets) return i;
    } else if (c == ']' || c == '}') {
      open = std::max(0, open - 1);
    }
    constexpr std::string_view kBefore = " \t\r\n[{,:";
    token_start = kBefore.find(c) != std::string_view::npos;
  }
  return std::string_view::npos;
}

std::string hint_for(std::string_view text, const TextMark& mark) {
  const std::size_t start = mark.offset + 1 - std::min<std::size_t>(mark.offset + 1, mark.column);
  const std::string_view line = text.substr(std::min(start, text.size()));
  const std::size_t indent = line.find_first_not_of(' ');
  if (indent != std::string_view::npos && line[indent] == '\t')
    return "indent with blanks, not tabs";
  return {};
}

/// yaml-cpp's words for the commonest slips, in ours.
std::string message_for(const std::string& theirs) {
  if (theirs == "illegal map value") return "a ':' that cannot stand here";
  if (theirs == "end of sequence flow not found") return "a '[' is not closed by a ']'";
  if (theirs == "end of map flow not found") return "a '{' is not closed by a '}'";
  if (theirs == "end of map not found" || theirs == "end of sequence not found")
    return "the indentation fits nothing above";
  if (theirs == "illegal EOF in scalar") return "a quoted text does not end";
  if (theirs == "the referenced anchor is not defined") return "this alias names no value above it";
  return theirs;
}

}  // namespace

Tree::Tree(std::string_view text, Reporter& reporter) {
  const std::size_t deep = too_many_brackets(text);
  if (deep != std::string_view::npos) {
    reporter.error(mark_at(text, deep), kTooDeep);
    return;
  }
  ViewBuffer buffer(text);
  std::istream in(&buffer);
  TreeBuilder builder(*this);
  try {
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
    return;
  } catch (const Stop& stop) {
    reporter.error(stop.mark, stop.message, stop.hint);
  } catch (const YAML::DeepRecursion& e) {
    reporter.error(from(e.mark), kTooDeep);
  } catch (const YAML::Exception& e) {
    const TextMark mark = from(e.mark);
    reporter.error(mark, "not YAML: " + message_for(e.msg), hint_for(text, mark));
  }
  root_ = nullptr;
}

std::string describe(const Node& node) {
  constexpr std::size_t kLongestQuote = 40;
  switch (node.kind) {
    case NodeKind::nothing:
      return "nothing";
    case NodeKind::list:
      return node.items.empty() ? "an empty list"
                                : "a list of " + std::to_string(node.items.size());
    case NodeKind::map:
      return "a map";
    case NodeKind::scalar:
      break;
  }
  std::string text = node.text.substr(0, kLongestQuote);
  while (text.size() < node.text.size() && !text.empty() &&
         (static_cast<unsigned char>(node.text[text.size()]) & 0xC0) == 0x80)
    text.pop_back();
  if (text.size() < node.text.size()) text += "...";
  std::replace(text.begin(), text.end(), '\n', ' ');
  return node.quoted ? "\"" + text + "\"" : in_quotes(text);
}

}  // namespace overstrike::yaml
