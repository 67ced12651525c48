#pragma once
// Handles of the HDF5 library that close themselves, and statuses that nobody can forget to look
// at. Files are images in memory: what reaches the disk, and how, is ours to decide, since the
// library's own writing ends in a crash or a broken file where the disk is full.
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace brisance::hdf5 {

/// Throws std::runtime_error if the library has answered with an error.
template <class Answer>
Answer checked(Answer answer, const char* what);

class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle(hid_t id, Closer close, const char* what) : id_(checked(id, what)), close_(close) {}
  ~Handle() { release(); }
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  void release() {
    if (id_ >= 0) close_(id_);
  }
  hid_t id_;
  Closer close_;
};

/// A new file in memory, and one made of an image.
Handle new_file();
Handle file_of(const std::string& image);
/// All that has been written so far, where it lies: until the file is used again.
std::string_view image_of(hid_t file);

void put(hid_t file, const char* attribute, const std::string& value);
void put(hid_t file, const char* attribute, std::int64_t value);
void put(hid_t file, const char* attribute, double value);
void get(hid_t file, const char* attribute, std::string& value);
void get(hid_t file, const char* attribute, std::int64_t& value);
void get(hid_t file, const char* attribute, double& value);

/// A table of numbers or, of one row, a text; groups in the path are made.
void write(hid_t file, const std::string& path, hid_t type, const void* data, std::size_t rows,
           std::size_t columns);

/// Whether the data are doubles, integers or bytes, and how they are shaped.
struct Shape {
  enum class Kind { doubles, integers, bytes } kind = Kind::doubles;
  std::size_t rows = 1, columns = 0;
};
Shape shape_of(hid_t file, const std::string& path);
void read(hid_t file, const std::string& path, hid_t type, void* data);

}  // namespace brisance::hdf5
