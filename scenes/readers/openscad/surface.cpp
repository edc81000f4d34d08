#include "scenes/readers/openscad/surface.h"

#include <png.h>

#include <algorithm>
#include <charconv>

#include "scenes/readers/mesh_build.h"
#include "scenes/readers/mesh_file.h"

namespace overstrike::openscad {
namespace {

/// As many facets as core draws of one curved shape, four times: of a map they are all seen.
constexpr std::size_t kMostCells = std::size_t{1} << 20;

struct HeightMap {
  std::size_t columns = 0, rows = 0;
  std::vector<double> heights;  ///< row by row, from y = 0 up
  double at(std::size_t x, std::size_t y) const { return heights[y * columns + x]; }
};

void any_size(std::string_view, std::uint64_t, const std::string&) {}

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }

struct FreeImage {
  void operator()(png_image* image) const { png_image_free(image); }
};

HeightMap read_png(std::string_view bytes, const std::string& name, bool invert) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, FreeImage> owner(&image);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    fail_mesh(name, std::string("cannot be read: ") + image.message);
  const std::size_t columns = image.width, rows = image.height;
  if (columns > kMostCells / rows) fail_mesh(name, "the picture is too large for a surface");
  image.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> pixels(4 * columns * rows);
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
    fail_mesh(name, std::string("cannot be read: ") + image.message);
  HeightMap map{columns, rows, {}};
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const png_byte* const p = &pixels[4 * ((rows - 1 - y) * columns + x)];
      const double luma = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
      // OpenSCAD's turned pictures reach from 1/255 down.
      map.heights.push_back(100.0 / 255 * (invert ? 1 - luma : luma));
    }
  return map;
}

/// One row of a .dat file; lines that begin with # are comments.
std::vector<double> read_row(std::string_view line, const std::string& name, int number) {
  std::vector<double> row;
  for (std::size_t i = 0; i < line.size();) {
    const auto start = line.find_first_not_of(" \t\r", i);
    if (start == std::string_view::npos || line[start] == '#') break;
    const auto end = std::min(line.find_first_of(" \t\r", start), line.size());
    double value = 0;
    const auto [stop, error] = std::from_chars(line.data() + start, line.data() + end, value);
    if (error != std::errc{} || stop != line.data() + end || !std::isfinite(value))
      throw InputError(Place{name, number, static_cast<int>(start) + 1},
                       "expected a height, found " +
                           in_quotes(line.substr(start, std::min<std::size_t>(end - start, 40))));
    row.push_back(value);
    i = end;
  }
  return row;
}

/// Rows that are shorter end in zeros.
HeightMap read_dat(std::string_view text, const std::string& name) {
  std::vector<std::vector<double>> rows;
  HeightMap map;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::vector<double> row = read_row(text.substr(0, end), name, number);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.empty()) continue;
    map.columns = std::max(map.columns, row.size());
    rows.push_back(std::move(row));
    if (map.columns * rows.size() > kMostCells) fail_mesh(name, "has too many heights");
  }
  map.rows = rows.size();
  for (std::vector<double>& row : rows) {
    row.resize(map.columns, 0);
    map.heights.insert(map.heights.end(), row.begin(), row.end());
  }
  return map;
}

class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(const HeightMap& map) : map_(map) {}

  Polyhedron build() {
    const Index columns = static_cast<Index>(map_.columns), rows = static_cast<Index>(map_.rows);
    for (Index y = 0; y < rows; ++y)
      for (Index x = 0; x < columns; ++x) p_.add_vertex(Vec3(x, y, map_.at(x, y)));
    for (Index y = 0; y + 1 < rows; ++y)
      for (Index x = 0; x + 1 < columns; ++x) add_cell(y * columns + x, columns);
    const double floor =
        std::fmin(0, *std::min_element(map_.heights.begin(), map_.heights.end()) - 1);
    const Index low[4] = {
        p_.add_vertex(Vec3(0, 0, floor)), p_.add_vertex(Vec3(columns - 1, 0, floor)),
        p_.add_vertex(Vec3(columns - 1, rows - 1, floor)), p_.add_vertex(Vec3(0, rows - 1, floor))};
    p_.add_face({low[3], low[2], low[1], low[0]});
    add_side(low[0], low[1], 0, 1, columns);
    add_side(low[1], low[2], columns - 1, columns, rows);
    add_side(low[2], low[3], rows * columns - 1, 0 - Index{1}, columns);
    add_side(low[3], low[0], (rows - 1) * columns, 0 - columns, rows);
    return std::move(p_);
  }

 private:
  void add_cell(Index a, Index columns) {
    const Index b = a + 1, c = a + columns + 1, d = a + columns;
    const Vec3 sum = p_.vertices[a] + p_.vertices[b] + p_.vertices[c] + p_.vertices[d];
    const Index middle = p_.add_vertex(sum / 4.0);
    p_.add_face({a, b, middle});
    p_.add_face({b, c, middle});
    p_.add_face({c, d, middle});
    p_.add_face({d, a, middle});
  }

  /// From one corner of the floor to the next, and back along the border of the map.
  void add_side(Index from, Index to, Index first, Index step, Index count) {
    std::vector<Index> side{from, to};
    for (Index i = count; i-- > 0;) side.push_back(first + i * step);
    p_.add_face(side);
  }

  const HeightMap& map_;
  Polyhedron p_;
};

}  // namespace

std::vector<Part> surface(const Arguments& a, const std::filesystem::path& path) {
  const std::string bytes = read_mesh_file(path, any_size);
  const std::string name = path.string();
  const HeightMap map =
      is_png(bytes) ? read_png(bytes, name, a.boolean("invert", false)) : read_dat(bytes, name);
  if (map.columns < 2 || map.rows < 2) return {};
  Part part{std::make_shared<const Shape>(Mesh{SurfaceBuilder(map).build(), {}, {}, 0}), {}, 0};
  if (a.boolean("center", false))
    part.place.offset = Vec3(-0.5 * static_cast<double>(map.columns - 1),
                             -0.5 * static_cast<double>(map.rows - 1), 0);
  return {std::move(part)};
}

}  // namespace overstrike::openscad
