#include "drivers/checkpoint_file.hpp"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "drivers/at_once.hpp"
#include "drivers/files.hpp"
#include "drivers/hdf5.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

constexpr char mark[24] = "brisance complete";
constexpr std::size_t seal_size = sizeof mark + sizeof(std::uint64_t);
constexpr const char* input_path = "input";
constexpr const char* contents_path = "contents";

/// Each step of it is a bijection of what came before: one wrong byte is always found. Source:
/// Fowler, Noll & Vo (1991), 64 bits.
std::uint64_t fnv1a(const char* data, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t k = 0; k < size; ++k)
    hash = (hash ^ static_cast<unsigned char>(data[k])) * 0x100000001b3;
  return hash;
}

/// Every attribute of the root, in either direction; the format first.
template <class Head, class F>
void each_attribute(Head& head, F&& f) {
  f("format", head.format);
  f("program", head.program);
  f("commit", head.commit);
  f("scene", head.scene);
  f("title", head.title);
  f("step", head.step);
  f("time", head.time);
  f("threads", head.threads);
}

void write_entry(hid_t file, const std::string& path, const Archive::Entry& entry) {
  const auto table = [&](hid_t type, const auto& data) {
    const std::size_t rows = std::max<std::size_t>(entry.rows, 1);
    hdf5::write(file, path, type, data.data(), rows, data.size() / rows);
  };
  if (const auto* doubles = std::get_if<Archive::Doubles>(&entry.data))
    table(H5T_NATIVE_DOUBLE, *doubles);
  if (const auto* integers = std::get_if<Archive::Integers>(&entry.data))
    table(H5T_NATIVE_INT64, *integers);
  if (const auto* text = std::get_if<std::string>(&entry.data)) table(H5T_NATIVE_UINT8, *text);
}

/// Nothing is compressed: no table has more numbers than the file has bytes.
Archive::Entry read_entry(hid_t file, const std::string& path, std::size_t bytes) {
  const hdf5::Shape shape = hdf5::shape_of(file, path);
  if (shape.rows > 0 && shape.columns > bytes / shape.rows)
    throw std::runtime_error("is damaged: '" + path + "' is larger than the file");
  Archive::Entry entry;
  entry.rows = shape.rows;
  const auto fill = [&](auto data, hid_t type) {
    data.resize(shape.rows * shape.columns);
    if (!data.empty()) hdf5::read(file, path, type, data.data());
    entry.data = std::move(data);
  };
  switch (shape.kind) {
    case hdf5::Shape::Kind::doubles:
      fill(Archive::Doubles(), H5T_NATIVE_DOUBLE);
      break;
    case hdf5::Shape::Kind::integers:
      fill(Archive::Integers(), H5T_NATIVE_INT64);
      break;
    case hdf5::Shape::Kind::bytes:
      fill(std::string(), H5T_NATIVE_UINT8);
      break;
  }
  return entry;
}

std::string read_text(hid_t file, const std::string& path, std::size_t bytes) {
  const Archive::Entry entry = read_entry(file, path, bytes);
  const auto* text = std::get_if<std::string>(&entry.data);
  if (!text) throw std::runtime_error("has no text '" + path + "'");
  return *text;
}

hdf5::Handle content_of(const CheckpointHead& head, Archive&& archive) {
  hdf5::Handle file = hdf5::new_file();
  each_attribute(head, [&](const char* name, const auto& value) { hdf5::put(file, name, value); });
  write_entry(file, input_path, {head.input});
  auto& entries = archive.entries();
  std::string contents;
  for (const auto& entry : entries) contents += entry.first + "\n";
  write_entry(file, contents_path, {contents});
  while (!entries.empty()) {
    write_entry(file, entries.begin()->first, entries.begin()->second);
    entries.erase(entries.begin());
  }
  return file;
}

}  // namespace

std::string seal_of(std::string_view content) {
  std::string seal(mark, sizeof mark);
  const std::uint64_t sum = fnv1a(content.data(), content.size());
  seal.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return seal;
}

std::string bytes_of(const CheckpointHead& head, Archive&& archive) {
  return std::string(hdf5::image_of(content_of(head, std::move(archive))));
}

void write_checkpoint(const fs::path& path, const CheckpointHead& head, Archive&& archive) {
  const hdf5::Handle content = content_of(head, std::move(archive));
  const std::string_view image = hdf5::image_of(content);
  expect_room(path.parent_path(), "'" + path.string() + "'", static_cast<double>(image.size()));
  AtomicFile file(path);
  std::string seal;
  at_once([&] { file.write(image); }, [&] { seal = seal_of(image); });
  file.write(seal);
  file.commit();
}

Checkpoint read_checkpoint(const fs::path& path) { return checkpoint_of(read_file(path)); }

Checkpoint checkpoint_of(std::string content) {
  if (content.size() < seal_size ||
      std::memcmp(content.data() + content.size() - seal_size, mark, sizeof mark) != 0)
    throw std::runtime_error("is cut off, or no checkpoint");
  const std::string seal = content.substr(content.size() - seal_size);
  content.resize(content.size() - seal_size);
  if (seal != seal_of(content)) throw std::runtime_error("is damaged");

  const hdf5::Handle file = hdf5::file_of(content);
  Checkpoint checkpoint;
  const std::int64_t known = checkpoint.head.format;
  hdf5::get(file, "format", checkpoint.head.format);
  if (checkpoint.head.format != known)
    throw std::runtime_error("has the format " + std::to_string(checkpoint.head.format) +
                             " of another version; this one reads " + std::to_string(known));
  each_attribute(checkpoint.head,
                 [&](const char* name, auto& value) { hdf5::get(file, name, value); });
  checkpoint.head.input = read_text(file, input_path, content.size());
  Archive::Entries entries;
  std::istringstream contents(read_text(file, contents_path, content.size()));
  for (std::string name; std::getline(contents, name);)
    entries[name] = read_entry(file, name, content.size());
  checkpoint.archive = Archive(std::move(entries));
  return checkpoint;
}

}  // namespace brisance
