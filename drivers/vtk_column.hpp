#pragma once
// One array of a VTK file, whose numbers are kept or made as they are written: what is written of
// a run would else be copied as a whole first.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace brisance::vtk {

/// The name that VTK has for a type of number: Float64. Of double, float, int64, int32 and uint8.
template <class T>
std::string type_name();

/// One named array of a file: the numbers of all rows, row after row. A plain vector converts into
/// it.
class Column {
 public:
  /// Throws std::invalid_argument if the numbers do not fill rows of that many components.
  template <class T>
  Column(std::string name, int components, std::vector<T> data);
  template <class T>
  Column(std::string name, std::vector<T> data) : Column(std::move(name), 1, std::move(data)) {}

  /// Numbers that are made as they are written: fill(begin, end, to) puts those of the rows from
  /// `begin` to before `end` at `to`.
  template <class T, class F>
  static Column made(std::string name, int components, std::size_t rows, F fill) {
    return Column(std::move(name), type_name<T>(), components, rows, sizeof(T),
                  [fill](std::size_t begin, std::size_t end, void* to) {
                    fill(begin, end, static_cast<T*>(to));
                  });
  }

  const std::string& name() const { return name_; }
  const std::string& type() const { return type_; }
  int components() const { return components_; }
  std::size_t rows() const { return rows_; }
  std::size_t bytes_of_row() const { return components_ * bytes_of_number_; }
  std::size_t bytes() const { return rows_ * bytes_of_row(); }
  void fill(std::size_t begin, std::size_t end, void* to) const { fill_(begin, end, to); }

 private:
  using Fill = std::function<void(std::size_t, std::size_t, void*)>;
  Column(std::string name, std::string type, int components, std::size_t rows,
         std::size_t bytes_of_number, Fill fill);

  std::string name_, type_;
  int components_;
  std::size_t rows_ = 0, bytes_of_number_;
  Fill fill_;
};

}  // namespace brisance::vtk
