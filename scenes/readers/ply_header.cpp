#include "scenes/readers/ply_header.h"

#include <algorithm>
#include <iterator>

#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/mesh_text.h"
#include "scenes/readers/nearest.h"

namespace overstrike {
namespace {

constexpr PlyType kTypes[] = {
    {"char", "int8", 1, false, true},    {"uchar", "uint8", 1, false, false},
    {"short", "int16", 2, false, true},  {"ushort", "uint16", 2, false, false},
    {"int", "int32", 4, false, true},    {"uint", "uint32", 4, false, false},
    {"float", "float32", 4, true, true}, {"double", "float64", 8, true, true},
};
constexpr std::string_view kTypeNames[] = {"char", "uchar", "short", "ushort",
                                           "int",  "uint",  "float", "double"};
constexpr std::string_view kKeywords[] = {"format",  "comment",  "obj_info",
                                          "element", "property", "end_header"};
constexpr std::string_view kEnd = "end_header";
// No header is longer.
constexpr std::size_t kLongestHeader = 65536;

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : text_(bytes, name) {}

  PlyHeader read(std::uint64_t size) {
    if (const std::string_view word = text_.word_of_any_line(); word != "ply") {
      text_.error(word, "expected 'ply', found " + found(word));
      text_.reporter().throw_errors();
    }
    while (text_.next_line()) {
      const std::string_view keyword = text_.word();
      if (keyword == kEnd) break;
      if (!keyword.empty()) statement(keyword);
    }
    header_.size = text_.offset_of_next_line();
    if (!has_format_) text_.error({}, "the header has no 'format'");
    need_faces();
    text_.reporter().throw_errors();
    if (size > 0) check_size(size);
    text_.reporter().throw_errors();
    return std::move(header_);
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "format") {
      format();
    } else if (keyword == "element") {
      element();
    } else if (keyword == "property") {
      property();
    } else if (keyword != "comment" && keyword != "obj_info") {
      text_.error(keyword, "unknown statement " + found(keyword), did_you_mean(keyword, kKeywords));
    }
  }

  void format() {
    const std::string_view word = text_.word();
    has_format_ = true;
    if (word == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (word == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (word == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      text_.error(word,
                  "the format must be ascii, binary_little_endian or binary_big_endian, found " +
                      found(word));
    }
    const std::string_view version = text_.word();
    if (version != "1.0") text_.error(version, "the version must be 1.0, found " + found(version));
  }

  void element() {
    PlyElement& e = header_.elements.emplace_back();
    e.name = text_.word();
    const std::string_view word = text_.word();
    e.mark = text_.mark(word);
    const auto count = text_.whole_number(word, "the count of an element");
    if (count && *count < 0)
      text_.error(word, "the count of an element must not be negative, found " + found(word));
    e.count = static_cast<std::uint64_t>(count.value_or(0));
  }

  const PlyType* type(std::string_view word) {
    for (const PlyType& t : kTypes)
      if (word == t.name || word == t.other_name) return &t;
    text_.error(word, "unknown type " + found(word), did_you_mean(word, kTypeNames));
    return &kTypes[0];
  }

  void property() {
    PlyProperty p;
    std::string_view word = text_.word();
    if (word == "list") {
      word = text_.word();
      p.count_type = type(word);
      if (p.count_type->real) text_.error(word, "the length of a list must be of a whole type");
      word = text_.word();
    }
    p.type = type(word);
    const std::string_view name = text_.word();
    p.name = name;
    if (header_.elements.empty()) return text_.error(name, "a property must follow an element");
    if (header_.elements.back().find(name) != nullptr)
      text_.error(
          name, "a second property " + found(name) + " of '" + header_.elements.back().name + "'");
    header_.elements.back().properties.push_back(std::move(p));
  }

  void need_faces() {
    const PlyElement* const vertex = header_.find("vertex");
    const PlyElement* const face = header_.find("face");
    if (!vertex || vertex->count == 0) text_.error({}, "the file has no vertices");
    if (!face || face->count == 0) text_.error({}, "the file has no faces");
    if (vertex)
      for (const char* axis : {"x", "y", "z"})
        if (const PlyProperty* p = vertex->find(axis); !p || p->count_type)
          text_.error_at(vertex->mark, "vertices have no property '" + std::string(axis) + "'");
    if (!face) return;
    const PlyProperty* list = face->find("vertex_indices");
    if (!list) list = face->find("vertex_index");
    if (!list || !list->count_type || list->type->real)
      text_.error_at(face->mark, "faces have no list 'vertex_indices' of whole numbers");
  }

  void check_size(std::uint64_t size) {
    std::uint64_t left = size - header_.size;
    for (const PlyElement& e : header_.elements) {
      std::uint64_t bytes = e.fewest_bytes(header_.encoding);
      if (e.count == 0) continue;
      if (bytes == 0) return text_.error_at(e.mark, "'" + e.name + "' has no properties");
      if (header_.encoding == PlyEncoding::ascii) ++bytes;  // the end of the line
      const std::uint64_t most = (left + 1) / bytes;        // the last line needs none
      if (e.count > most)
        return text_.error_at(e.mark, "the file ends after at most " + in_thousands(most) + " of " +
                                          in_thousands(e.count) + " entries of '" + e.name + "'");
      left -= std::min(left, e.count * bytes);
    }
  }

  MeshText text_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
  for (const PlyProperty& p : properties)
    if (p.name == property) return &p;
  return nullptr;
}

std::uint64_t PlyElement::fewest_bytes(PlyEncoding encoding) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += p.count_type ? p.count_type->size : p.type->size;
  // A digit each, and blanks between them.
  return encoding == PlyEncoding::ascii && !properties.empty() ? 2 * properties.size() - 1 : bytes;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const PlyElement& e : elements)
    if (e.name == element) return &e;
  return nullptr;
}

PlyHeader read_ply_header(std::string_view bytes, std::uint64_t size, const std::string& name) {
  check_text(bytes.substr(0, 3), size, name);
  const std::string_view head = bytes.substr(0, kLongestHeader);
  const std::size_t end = head.find(kEnd);
  if (head.starts_with("ply") && end == std::string_view::npos)
    throw InputError(Place{name, 1, 1}, "the header has no 'end_header'");
  const std::size_t line_end = head.find('\n', std::min(end, head.size()));
  check_text(head.substr(0, std::min(end, head.size())), size, name);
  return HeaderReader(bytes.substr(0, std::min(line_end, head.size() - 1) + 1), name).read(size);
}

}  // namespace overstrike
