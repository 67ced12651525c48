#include "drivers/hdf5.hpp"

#include <algorithm>
#include <stdexcept>

namespace brisance::hdf5 {
namespace {

constexpr std::size_t chunk = 1 << 16;      // numbers
constexpr std::size_t increment = 1 << 20;  // by which an image grows [B]

/// Where the oldest form of a file says that it is open; the library takes that back as it closes
/// it.
constexpr std::size_t being_written = 20;

/// The library prints stacks of errors of its own unless told not to, and tidies up at exit, which
/// crashes after an error.
void prepare_library() {
  static const bool done = [] {
    H5dont_atexit();
    checked(H5open(), "start");
    checked(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "quiet");
    return true;
  }();
  static_cast<void>(done);
}

Handle in_memory() {
  prepare_library();
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access");
  checked(H5Pset_fapl_core(access, increment, 0), "file in memory");
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST), "oldest form");
  return access;
}

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text");
  checked(H5Tset_size(type, std::max<std::size_t>(size, 1)), "size of a text");
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "padding of a text");
  return type;
}

void put_as(hid_t file, const char* name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "scalar");
  const Handle attribute(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         name);
  checked(H5Awrite(attribute, type, value), name);
}

/// An attribute that is read into one value must hold no more.
Handle open_single(hid_t file, const char* name) {
  Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw std::runtime_error(std::string("HDF5 fails at '") + name + "'");
  return attribute;
}

void get_as(hid_t file, const char* name, hid_t type, void* value) {
  checked(H5Aread(open_single(file, name), type, value), name);
}

}  // namespace

template <class Answer>
Answer checked(Answer answer, const char* what) {
  if (answer < 0) throw std::runtime_error(std::string("HDF5 fails at '") + what + "'");
  return answer;
}
template int checked(int, const char*);
template hid_t checked(hid_t, const char*);  // and ssize_t, which is the same

Handle new_file() {
  const Handle access = in_memory();
  return Handle(H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "new file");
}

Handle file_of(const std::string& image) {
  const Handle access = in_memory();
  checked(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()), "image");
  return Handle(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), H5Fclose, "file");
}

std::string_view image_of(hid_t file) {
  checked(H5Fflush(file, H5F_SCOPE_LOCAL), "flush");
  const auto size = checked(H5Fget_file_image(file, nullptr, 0), "size of the image");
  void* place = nullptr;  // where the pointer to the image lies
  checked(H5Fget_vfd_handle(file, H5P_DEFAULT, &place), "image");
  char* image = *static_cast<char**>(place);
  image[being_written] = 0;
  return {image, static_cast<std::size_t>(size)};
}

void put(hid_t file, const char* attribute, const std::string& value) {
  put_as(file, attribute, text_type(value.size()), value.c_str());
}
void put(hid_t file, const char* attribute, std::int64_t value) {
  put_as(file, attribute, H5T_NATIVE_INT64, &value);
}
void put(hid_t file, const char* attribute, double value) {
  put_as(file, attribute, H5T_NATIVE_DOUBLE, &value);
}

void get(hid_t file, const char* name, std::string& value) {
  const Handle attribute = open_single(file, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  // A text of any length is a pointer there, which would have to be freed.
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    throw std::runtime_error(std::string("HDF5 fails at '") + name + "'");
  value.assign(H5Tget_size(type), '\0');
  checked(H5Aread(attribute, type, value.data()), name);
  value.resize(std::min(value.size(), value.find('\0')));
}
void get(hid_t file, const char* attribute, std::int64_t& value) {
  get_as(file, attribute, H5T_NATIVE_INT64, &value);
}
void get(hid_t file, const char* attribute, double& value) {
  get_as(file, attribute, H5T_NATIVE_DOUBLE, &value);
}

void write(hid_t file, const std::string& path, hid_t type, const void* data, std::size_t rows,
           std::size_t columns) {
  const hsize_t size[2] = {rows, columns},
                part[2] = {1, std::max<std::size_t>(1, std::min(columns, chunk))};
  const Handle space(H5Screate_simple(2, size, nullptr), H5Sclose, path.c_str());
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path.c_str());
  checked(H5Pset_create_intermediate_group(links, 1), path.c_str());
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path.c_str());
  if (rows * columns > 0) {  // chunks cannot be larger than what is in them
    checked(H5Pset_chunk(layout, 2, part), path.c_str());
    checked(H5Pset_fletcher32(layout), path.c_str());
  }
  const Handle set(H5Dcreate2(file, path.c_str(), type, space, links, layout, H5P_DEFAULT),
                   H5Dclose, path.c_str());
  if (rows * columns == 0) return;
  checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), path.c_str());
}

Shape shape_of(hid_t file, const std::string& path) {
  const Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, path.c_str());
  const Handle type(H5Dget_type(set), H5Tclose, path.c_str());
  const Handle space(H5Dget_space(set), H5Sclose, path.c_str());
  hsize_t size[2] = {};
  if (H5Sget_simple_extent_ndims(space) != 2)
    throw std::runtime_error("HDF5 fails at '" + path + "'");
  checked(H5Sget_simple_extent_dims(space, size, nullptr), path.c_str());
  Shape shape;
  if (H5Tget_class(type) == H5T_INTEGER)
    shape.kind = H5Tget_size(type) == 1 ? Shape::Kind::bytes : Shape::Kind::integers;
  shape.rows = size[0];
  shape.columns = size[1];
  return shape;
}

void read(hid_t file, const std::string& path, hid_t type, void* data) {
  const Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, path.c_str());
  checked(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), path.c_str());
}

}  // namespace brisance::hdf5
