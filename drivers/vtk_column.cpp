#include "drivers/vtk_column.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace brisance::vtk {

template <class T>
std::string type_name() {
  const std::string kind =
      std::is_floating_point_v<T> ? "Float" : (std::is_signed_v<T> ? "Int" : "UInt");
  return kind + std::to_string(8 * sizeof(T));
}

Column::Column(std::string name, std::string type, int components, std::size_t rows,
               std::size_t bytes_of_number, Fill fill)
    : name_(std::move(name)),
      type_(std::move(type)),
      components_(components),
      rows_(rows),
      bytes_of_number_(bytes_of_number),
      fill_(std::move(fill)) {}

template <class T>
Column::Column(std::string name, int components, std::vector<T> data)
    : name_(std::move(name)),
      type_(type_name<T>()),
      components_(components),
      bytes_of_number_(sizeof(T)) {
  if (components < 1 || data.size() % static_cast<std::size_t>(components) != 0) {
    throw std::invalid_argument("column '" + name_ + "' has " + std::to_string(data.size()) +
                                " numbers for rows of " + std::to_string(components));
  }
  const std::size_t width = components;
  rows_ = data.size() / width;
  fill_ = [width, data = std::move(data)](std::size_t begin, std::size_t end, void* to) {
    std::copy(data.begin() + begin * width, data.begin() + end * width, static_cast<T*>(to));
  };
}

#define BRISANCE_COLUMN(T)             \
  template std::string type_name<T>(); \
  template Column::Column(std::string, int, std::vector<T>);
BRISANCE_COLUMN(double)
BRISANCE_COLUMN(float)
BRISANCE_COLUMN(std::int64_t)
BRISANCE_COLUMN(std::int32_t)
BRISANCE_COLUMN(std::uint8_t)
#undef BRISANCE_COLUMN

}  // namespace brisance::vtk
