// Bytes as a checkpoint. Whole files of any content are read or refused. Of a small state of any
// content the file is read as it was written, refused with any byte changed, and read or refused
// where it is sealed, but its attributes and tables are not those of a checkpoint. Under a seal
// that fits HDF5's own tables are not changed: the library is not made for that, which is why there
// is a seal.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "drivers/checkpoint_file.hpp"
#include "drivers/hdf5.hpp"

namespace {

using namespace brisance;

void expect(bool right, const char* what) {
  if (right) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

bool is_read(const std::string& file) {
  try {
    checkpoint_of(file);
    return true;
  } catch (const std::runtime_error& error) {
    expect(!std::strchr(error.what(), '\n'), "more than one line");
    return false;
  }
}

Archive::Entry some_entry(FuzzedDataProvider& in) {
  Archive::Entry entry;
  entry.rows = in.ConsumeIntegralInRange<std::size_t>(1, 4);
  const std::size_t size = entry.rows * in.ConsumeIntegralInRange<std::size_t>(0, 20);
  switch (in.ConsumeIntegralInRange(0, 2)) {
    case 0:
      entry.data = Archive::Doubles(size, in.ConsumeFloatingPoint<double>());
      break;
    case 1:
      entry.data = Archive::Integers(size, in.ConsumeIntegral<std::int64_t>());
      break;
    default:
      entry.rows = 1;
      entry.data = in.ConsumeRandomLengthString(20);
  }
  return entry;
}

std::string bytes_of(const Archive::Entry& entry) {
  return std::visit(
      [](const auto& data) {
        return std::string(reinterpret_cast<const char*>(data.data()),
                           data.size() * sizeof(data[0]));
      },
      entry.data);
}

void read_what_is_written(FuzzedDataProvider& in) {
  CheckpointHead head;
  head.step = in.ConsumeIntegral<std::int64_t>();
  head.input = in.ConsumeRandomLengthString(40);
  Archive::Entries entries;
  for (const char* name : {"state/time", "state/material gas/mass"}) entries[name] = some_entry(in);
  Archive archive;
  archive.entries() = entries;
  std::string content = brisance::bytes_of(head, std::move(archive));
  content += seal_of(content);
  Checkpoint again = checkpoint_of(content);
  expect(again.head.step == head.step && again.head.input == head.input, "another head is read");
  expect(again.archive.entries().size() == entries.size(), "other entries are read");
  for (const auto& [name, entry] : entries)
    expect(bytes_of(again.archive.entries().at(name)) == bytes_of(entry), "other numbers are read");
  const auto at = in.ConsumeIntegralInRange<std::size_t>(0, content.size() - 1);
  content[at] = static_cast<char>(content[at] ^ in.ConsumeIntegralInRange(1, 255));
  expect(!is_read(content), "a byte that was changed is not seen");
}

/// An attribute of any type, or none.
void put_something(FuzzedDataProvider& in, hid_t file, const char* name) {
  switch (in.ConsumeIntegralInRange(0, 4)) {
    case 0:
      return hdf5::put(file, name, in.ConsumeRandomLengthString(20));
    case 1:
      return hdf5::put(file, name, in.ConsumeFloatingPoint<double>());
    case 2: {  // many of them
      const hsize_t count = in.ConsumeIntegralInRange<hsize_t>(0, 9);
      const std::int64_t values[9] = {};
      const hdf5::Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, name),
          attribute(H5Acreate2(file, name, H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose, name);
      hdf5::checked(H5Awrite(attribute, H5T_NATIVE_INT64, values), name);
      return;
    }
    case 3:
      return;
    default:
      hdf5::put(file, name, std::int64_t{1});
  }
}

void write_something(FuzzedDataProvider& in, hid_t file, const std::string& name) {
  const hid_t types[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_UINT8, H5T_NATIVE_FLOAT,
                         H5T_NATIVE_INT16};
  const std::string text = in.ConsumeRandomLengthString(40);
  char data[8 * 40] = {};
  std::copy(text.begin(), text.end(), data);
  const hid_t type = types[in.ConsumeIntegralInRange(0, 4)];
  hdf5::write(file, name, type, data, in.ConsumeIntegralInRange<std::size_t>(0, 2),
              in.ConsumeBool() ? text.size() / 2 : 20);
}

void read_another_file(FuzzedDataProvider& in) {
  const hdf5::Handle file = hdf5::new_file();
  for (const char* name :
       {"format", "program", "commit", "scene", "title", "step", "time", "threads"})
    if (in.ConsumeBool())
      put_something(in, file, name);
    else if (std::strcmp(name, "time") == 0)
      hdf5::put(file, name, 1.0);
    else if (std::strchr("pct", name[0]) || std::strcmp(name, "scene") == 0)
      hdf5::put(file, name, std::string("x"));
    else
      hdf5::put(file, name, std::int64_t{1});
  for (const char* name : {"input", "contents", "a", "b/c"}) write_something(in, file, name);
  const std::string content(hdf5::image_of(file));
  is_read(content + seal_of(content));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size > 4 && std::memcmp(data + 1, "HDF", 3) == 0) {
    is_read(std::string(reinterpret_cast<const char*>(data), size));
    return 0;
  }
  FuzzedDataProvider in(data, size);
  if (in.ConsumeBool())
    read_what_is_written(in);
  else
    read_another_file(in);
  return 0;
}
