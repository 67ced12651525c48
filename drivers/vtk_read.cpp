#include "drivers/vtk_read.hpp"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "drivers/files.hpp"

namespace brisance::vtk {
namespace {

/// The value of an attribute within one tag, or nothing.
std::string attribute(const std::string& tag, const std::string& name) {
  const auto start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return {};
  const auto value = start + name.size() + 3;
  return tag.substr(value, tag.find('"', value) - value);
}

template <class T>
std::vector<double> numbers(const char* bytes, std::size_t size) {
  std::vector<double> values(size / sizeof(T));
  for (std::size_t k = 0; k < values.size(); ++k) {
    T value;
    std::memcpy(&value, bytes + k * sizeof(T), sizeof(T));
    values[k] = static_cast<double>(value);
  }
  return values;
}

std::vector<double> numbers_of(const std::string& type, const char* bytes, std::size_t size) {
  if (type == "Float64") return numbers<double>(bytes, size);
  if (type == "Float32") return numbers<float>(bytes, size);
  if (type == "Int64") return numbers<std::int64_t>(bytes, size);
  if (type == "Int32") return numbers<std::int32_t>(bytes, size);
  if (type == "UInt8") return numbers<std::uint8_t>(bytes, size);
  throw std::runtime_error("numbers of type '" + type + "'");
}

/// All arrays of a file, and the XML in front of them.
std::vector<ReadColumn> read_arrays(const std::filesystem::path& path, const std::string& kind,
                                    std::string& head) {
  const std::string file = read_file(path);
  const auto fail = [&](const std::string& why) {
    return std::runtime_error("'" + path.string() + "' is not a " + kind + " file of ours: " + why);
  };
  const auto appended = file.find("<AppendedData");
  const auto underscore = file.find('_', appended == std::string::npos ? 0 : appended);
  if (appended == std::string::npos || underscore == std::string::npos)
    throw fail("it has no appended data");
  if (file.find("</AppendedData>", underscore) == std::string::npos) throw fail("it is cut off");
  head = file.substr(0, appended);
  const std::size_t data = underscore + 1;

  std::vector<ReadColumn> columns;
  const auto end_of_verts = head.find("<Verts>");
  for (auto at = head.find("<DataArray"); at != std::string::npos;
       at = head.find("<DataArray", at + 1)) {
    const std::string tag = head.substr(at, head.find('>', at) - at);
    const auto closing = head.find("</Verts>");
    if (end_of_verts != std::string::npos && at > end_of_verts && at < closing)
      continue;  // connectivity
    const std::string offset = attribute(tag, "offset"),
                      components = attribute(tag, "NumberOfComponents");
    if (offset.empty() || offset.find_first_not_of("0123456789") != std::string::npos)
      throw fail("bad offset");
    const std::size_t begin = data + std::stoull(offset);
    std::uint64_t size = 0;
    if (begin + sizeof size > file.size()) throw fail("it is cut off");
    std::memcpy(&size, file.data() + begin, sizeof size);
    if (size > file.size() - begin - sizeof size) throw fail("it is cut off");
    ReadColumn column;
    column.name = attribute(tag, "Name");
    column.components = components.empty() ? 1 : std::stoi(components);
    column.values = numbers_of(attribute(tag, "type"), file.data() + begin + sizeof size, size);
    const bool points = head.rfind("<Points>", at) != std::string::npos &&
                        head.rfind("<Points>", at) > head.rfind("</Points>", at) + 1;
    if (points || column.name == "Points") {
      column.name = "points";
      columns.insert(columns.begin(), column);
    } else {
      columns.push_back(column);
    }
  }
  return columns;
}

}  // namespace

std::vector<ReadColumn> read_vtp(const std::filesystem::path& path) {
  std::string head;
  return read_arrays(path, "particle", head);
}

ReadGrid read_vti(const std::filesystem::path& path) {
  std::string head;
  ReadGrid grid;
  grid.columns = read_arrays(path, "grid", head);
  int low[3], high[3];
  const std::string extent = attribute(head, "WholeExtent");
  if (std::sscanf(extent.c_str(), "%d %d %d %d %d %d", &low[0], &high[0], &low[1], &high[1],
                  &low[2], &high[2]) != 6)
    throw std::runtime_error("'" + path.string() + "' is not a grid file of ours: it has no extent");
  for (int d = 0; d < 3; ++d) grid.cells[d] = high[d] - low[d];
  return grid;
}

}  // namespace brisance::vtk
