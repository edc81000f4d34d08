#include "scenes/readers/openscad/tree.h"

#include <algorithm>
#include <cstdlib>

#include "scenes/readers/openscad/tokens.h"

namespace overstrike::openscad {
namespace {

/// Words that begin a statement of a program.
constexpr std::string_view kStatements[] = {"module", "function", "use", "include"};

class Parser {
 public:
  Parser(std::string_view text, Reporter& reporter) : tokens_(text, reporter), reporter_(reporter) {
    take();
  }

  Tree parse() {
    tree_.nodes.push_back({"group", {1, 1, 0}, 0, 0, 0, false, false});
    open_.push_back(0);
    while (token_.kind != TokenKind::end) {
      if (token_.is('}')) {
        close();
      } else {
        node();
      }
    }
    if (open_.size() > 1)
      fail(token_.at, "expected '}' for the '{' of " + in_quotes(tree_.nodes[open_.back()].name) +
                          " in line " + std::to_string(tree_.nodes[open_.back()].at.line) +
                          ", found the end of the file");
    tree_.nodes[0].end = static_cast<Index>(tree_.nodes.size());
    return std::move(tree_);
  }

 private:
  void take() { token_ = tokens_.next(); }

  [[noreturn]] void fail(const TextMark& at, std::string message, std::string hint = {}) {
    reporter_.error(at, std::move(message), std::move(hint));
    reporter_.throw_errors();
    std::abort();  // an error was reported
  }

  void expect(char mark, std::string_view after) {
    if (!token_.is(mark))
      fail(token_.at, std::string("expected '") + mark + "' after " + std::string(after) +
                          ", found " + describe(token_));
    take();
  }

  void close() {
    if (open_.size() == 1) fail(token_.at, "'}' without '{'");
    tree_.nodes[open_.back()].end = static_cast<Index>(tree_.nodes.size());
    open_.pop_back();
    take();
  }

  void node() {
    Node node;
    bool root = false;
    while (token_.is('%') || token_.is('#') || token_.is('*') || token_.is('!')) {
      node.background = node.background || token_.is('%');
      node.disabled = node.disabled || token_.is('*');
      root = root || token_.is('!');
      take();
    }
    if (token_.is(';')) return take();
    if (token_.kind != TokenKind::word)
      fail(token_.at, "expected a node such as cube(...), found " + describe(token_));
    node.name = token_.source;
    node.at = token_.at;
    take();
    if (!token_.is('(')) refuse_statement(node);
    arguments(node);
    const Index number = static_cast<Index>(tree_.nodes.size());
    if (root) tree_.root = number;
    node.end = number + 1;
    const bool has_block = token_.is('{');
    if (!has_block && !token_.is(';'))
      fail(token_.at, "expected ';' or '{' after " + in_quotes(node.name + "(...)") + ", found " +
                          describe(token_));
    take();
    tree_.nodes.push_back(std::move(node));
    if (has_block) open_.push_back(number);
  }

  [[noreturn]] void refuse_statement(const Node& node) {
    const bool statement = std::find(std::begin(kStatements), std::end(kStatements), node.name) !=
                           std::end(kStatements);
    if (statement || token_.is('='))
      fail(node.at, in_quotes(node.name) + " belongs to a program, not to a .csg file",
           "name the file .scad, and OpenSCAD is asked what it makes");
    fail(token_.at, "expected '(' after " + in_quotes(node.name) + ", found " + describe(token_));
  }

  void arguments(Node& node) {
    take();
    node.first_argument = static_cast<Index>(tree_.arguments.size());
    while (!token_.is(')')) {
      argument();
      if (token_.is(')')) break;
      expect(',', "an argument of " + in_quotes(node.name));
    }
    take();
    node.end_argument = static_cast<Index>(tree_.arguments.size());
  }

  void argument() {
    Argument argument{{}, static_cast<Index>(tree_.values.size()), token_.at};
    if (token_.kind == TokenKind::word && token_.source != "true" && token_.source != "false" &&
        token_.source != "undef") {
      argument.name = token_.source;
      take();
      expect('=', in_quotes(argument.name));
    }
    value();
    tree_.arguments.push_back(std::move(argument));
  }

  /// One value, nested as deeply as it may be.
  void value() {
    std::vector<Index> lists;
    do {
      const Index number = static_cast<Index>(tree_.values.size());
      if (token_.is('[')) {
        lists.push_back(number);
        tree_.values.push_back({ValueKind::list, 0, 0, 0, token_.at});
        take();
      } else {
        scalar();
        end_item(lists);
      }
      while (!lists.empty() && token_.is(']')) {
        tree_.values[lists.back()].end = static_cast<Index>(tree_.values.size());
        lists.pop_back();
        take();
        end_item(lists);
      }
    } while (!lists.empty());
  }

  void end_item(const std::vector<Index>& lists) {
    if (!lists.empty() && !token_.is(']')) expect(',', "an item of the list");
  }

  void scalar() {
    Value value{ValueKind::undefined, static_cast<Index>(tree_.values.size() + 1), 0, 0, token_.at};
    if (token_.kind == TokenKind::number) {
      value.kind = ValueKind::number;
      value.number = token_.number;
      value.precision = token_.precision;
    } else if (token_.kind == TokenKind::text) {
      value.kind = ValueKind::text;
      value.number = static_cast<double>(tree_.texts.size());
      tree_.texts.push_back(std::move(token_.text));
    } else if (token_.kind == TokenKind::word && token_.source != "undef") {
      if (token_.source != "true" && token_.source != "false")
        fail(token_.at, "expected a value, found " + describe(token_),
             "a .csg file has no variables");
      value.kind = ValueKind::boolean;
      value.number = token_.source == "true" ? 1 : 0;
    } else if (token_.kind != TokenKind::word) {
      fail(token_.at, "expected a value, found " + describe(token_));
    }
    tree_.values.push_back(value);
    take();
  }

  Tokens tokens_;
  Reporter& reporter_;
  Token token_;
  Tree tree_;
  std::vector<Index> open_;
};

}  // namespace

Tree parse(std::string_view text, Reporter& reporter) { return Parser(text, reporter).parse(); }

}  // namespace overstrike::openscad
