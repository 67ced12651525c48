#include "drivers/vtk.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "drivers/files.hpp"

namespace brisance::vtk {
namespace {

/// What is made at once of a column [B].
constexpr std::size_t piece = 1 << 18;

/// The shortest text that reads back to the same number, whatever the locale.
std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string joined(const std::array<double, 3>& values) {
  return text_of(values[0]) + ' ' + text_of(values[1]) + ' ' + text_of(values[2]);
}

/// What XML wants written differently inside of quotes.
constexpr std::pair<char, std::string_view> entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto found = std::find_if(std::begin(entities), std::end(entities),
                                    [c](const auto& entity) { return entity.first == c; });
    if (found == std::end(entities)) {
      result += c;
    } else {
      result += found->second;
    }
  }
  return result;
}

std::string unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto found =
        std::find_if(std::begin(entities), std::end(entities), [text](const auto& entity) {
          return text.substr(0, entity.second.size()) == entity.second;
        });
    const bool entity = found != std::end(entities);
    result += entity ? found->first : text.front();
    text.remove_prefix(entity ? found->second.size() : 1);
  }
  return result;
}

/// An attribute of an XML element.
std::string with(const std::string& name, const std::string& value) {
  return ' ' + name + "=\"" + escaped(value) + '"';
}

/// The head of every file; sizes of arrays are given in 64 bits.
std::string opening(const std::string& type) {
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  const std::string order = "LittleEndian";
#else
  const std::string order = "BigEndian";
#endif
  return "<?xml version='1.0'?>\n<VTKFile" + with("type", type) + with("version", "1.0") +
         with("byte_order", order) + with("header_type", "UInt64") + ">\n";
}

/// The XML header of a file and, in step with it, the arrays that are appended to it.
class Document {
 public:
  explicit Document(const std::string& type) : header_(opening(type)) {}

  void line(const std::string& text) { header_ += text + '\n'; }

  void array(const Column& column) {
    line("<DataArray" + with("type", column.type()) + with("Name", column.name()) +
         with("NumberOfComponents", std::to_string(column.components())) +
         with("format", "appended") + with("offset", std::to_string(offset_)) + "/>");
    arrays_.push_back(&column);
    offset_ += sizeof(std::uint64_t) + column.bytes();
  }

  /// PointData or CellData; the first number and the first vector are what a viewer colours and
  /// draws arrows by.
  void columns(const std::string& element, const std::vector<Column>& columns, std::size_t rows) {
    const auto first = [&](const std::string& role, int components) {
      const auto found = std::find_if(columns.begin(), columns.end(), [=](const Column& column) {
        return column.components() == components;
      });
      return found == columns.end() ? "" : with(role, found->name());
    };
    line('<' + element + first("Scalars", 1) + first("Vectors", 3) + '>');
    for (const auto& column : columns) {
      if (column.rows() != rows) {
        throw std::invalid_argument("column '" + column.name() + "' has " +
                                    std::to_string(column.rows()) + " rows instead of " +
                                    std::to_string(rows));
      }
      array(column);
    }
    line("</" + element + '>');
  }

  void write(const std::filesystem::path& path, Backlog* later) {
    AtomicFile file(path);
    file.write(header_ + "<AppendedData" + with("encoding", "raw") + ">\n_");
    std::vector<std::uint64_t> numbers;  // aligned for numbers of any type
    for (const auto* array : arrays_) {
      const std::uint64_t size = array->bytes();
      file.write(&size, sizeof size);
      const std::size_t of_row = array->bytes_of_row(),
                        rows = std::max<std::size_t>(piece / of_row, 1);
      numbers.resize(std::max(numbers.size(), rows * of_row / sizeof(std::uint64_t) + 1));
      for (std::size_t begin = 0; begin < array->rows(); begin += rows) {
        const std::size_t end = std::min(array->rows(), begin + rows);
        array->fill(begin, end, numbers.data());
        file.write(numbers.data(), (end - begin) * of_row);
      }
    }
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit(later);
  }

 private:
  std::string header_;
  std::vector<const Column*> arrays_;
  std::uint64_t offset_ = 0;
};

/// The value of one attribute of an XML element; throws if it has none of that name.
std::string attribute(std::string_view element, const std::string& name) {
  const std::string key = ' ' + name + "=\"";
  const auto at = element.find(key);
  if (at == std::string_view::npos) throw std::runtime_error("has an entry without " + name);
  element.remove_prefix(at + key.size());
  return unescaped(element.substr(0, element.find('"')));
}

std::vector<Series::Entry> entries_in(std::string_view text) {
  if (text.find("<VTKFile" + with("type", "Collection")) == std::string_view::npos ||
      text.find("</VTKFile>") == std::string_view::npos) {
    throw std::runtime_error("is no time series or is cut off");
  }
  std::vector<Series::Entry> entries;
  for (auto at = text.find("<DataSet "); at != std::string_view::npos;
       at = text.find("<DataSet ", at + 1)) {
    const auto element = text.substr(at, text.find('>', at) - at);
    const auto time = attribute(element, "timestep");
    Series::Entry entry{0, attribute(element, "file")};
    const auto read = std::from_chars(time.data(), time.data() + time.size(), entry.time);
    if (read.ec != std::errc() || read.ptr != time.data() + time.size()) {
      throw std::runtime_error("has the time '" + time + "'");
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const std::vector<double>& points,
               const std::vector<Column>& columns, Backlog* later) {
  write_vtp(path, Column("Points", 3, points), columns, later);
}

void write_vtp(const std::filesystem::path& path, const Column& places,
               const std::vector<Column>& columns, Backlog* later) {
  const std::size_t count = places.rows();
  const auto counting = [count](const char* name, std::int32_t from) {
    return Column::made<std::int32_t>(
        name, 1, count, [from](std::size_t begin, std::size_t end, std::int32_t* to) {
          std::iota(to, to + (end - begin), from + static_cast<std::int32_t>(begin));
        });
  };
  const Column connectivity = counting("connectivity", 0), offsets = counting("offsets", 1);

  const auto n = std::to_string(count);
  Document document("PolyData");
  document.line("<PolyData>");
  document.line("<Piece" + with("NumberOfPoints", n) + with("NumberOfVerts", n) +
                with("NumberOfLines", "0") + with("NumberOfStrips", "0") +
                with("NumberOfPolys", "0") + ">");
  document.columns("PointData", columns, count);
  document.line("<Points>");
  document.array(places);
  document.line("</Points>\n<Verts>");
  document.array(connectivity);
  document.array(offsets);
  document.line("</Verts>\n</Piece>\n</PolyData>");
  document.write(path, later);
}

std::size_t Box::count_points() const {
  return std::accumulate(cells.begin(), cells.end(), std::size_t{1},
                         [](std::size_t n, int along) { return n * (along + 1); });
}

std::size_t Box::count_cells() const {
  return std::accumulate(cells.begin(), cells.end(), std::size_t{1},
                         [](std::size_t n, int along) { return n * std::max(along, 1); });
}

void write_vti(const std::filesystem::path& path, const Box& box,
               const std::vector<Column>& point_columns, const std::vector<Column>& cell_columns,
               Backlog* later) {
  std::string extent;
  for (const int cells : box.cells)
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(cells);
  Document document("ImageData");
  document.line("<ImageData" + with("WholeExtent", extent) + with("Origin", joined(box.origin)) +
                with("Spacing", joined(box.spacing)) + ">");
  document.line("<Piece" + with("Extent", extent) + ">");
  document.columns("PointData", point_columns, box.count_points());
  document.columns("CellData", cell_columns, box.count_cells());
  document.line("</Piece>\n</ImageData>");
  document.write(path, later);
}

Series Series::resumed(std::filesystem::path path, double time) {
  Series series(std::move(path));
  if (!std::filesystem::exists(series.path_)) return series;
  const auto text = read_file(series.path_);
  try {
    series.entries_ = entries_in(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("'" + series.path_.string() + "' " + error.what());
  }
  const auto past = [time](const Entry& entry) { return !(entry.time < time); };
  series.entries_.erase(std::remove_if(series.entries_.begin(), series.entries_.end(), past),
                        series.entries_.end());
  return series;
}

void Series::note(double time, const std::filesystem::path& file) {
  const auto folder = std::filesystem::absolute(path_).lexically_normal().parent_path();
  const auto name = std::filesystem::absolute(file)
                        .lexically_normal()
                        .lexically_relative(folder)
                        .generic_string();
  if (name.empty() || name == "." || name.rfind("..", 0) == 0) {
    throw std::invalid_argument("'" + file.string() + "' lies outside of the folder of the series");
  }
  if (!std::isfinite(time) || (!entries_.empty() && time < entries_.back().time)) {
    throw std::invalid_argument("the series '" + path_.string() + "' cannot go on with the time " +
                                text_of(time));
  }
  if (!entries_.empty() && entries_.back().time == time) entries_.pop_back();
  entries_.push_back({time, name});
}

void Series::resume(std::vector<Entry> entries) {
  entries_ = std::move(entries);
  write();
}

void Series::write() const {
  if (entries_.empty()) return;
  std::string text = opening("Collection") + "<Collection>\n";
  for (const auto& entry : entries_) {
    text += "<DataSet" + with("timestep", text_of(entry.time)) + with("group", "") +
            with("part", "0") + with("file", entry.file) + "/>\n";
  }
  write_file(path_, text + "</Collection>\n</VTKFile>\n", later_);
}

}  // namespace brisance::vtk
