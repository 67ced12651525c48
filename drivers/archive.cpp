#include "drivers/archive.hpp"

#include <stdexcept>

namespace brisance {

Archive::Part::Part(Archive& archive, const std::string& name)
    : archive_(archive), size_(archive.prefix_.size()) {
  archive.prefix_ += name + "/";
}

template <class T>
void Archive::exchange(const std::string& name, T& value, std::size_t rows) {
  const std::string path = prefix_ + name;
  if (!reading_) {
    entries_[path] = {value, rows};
    return;
  }
  const auto found = entries_.find(path);
  const T* stored = found == entries_.end() ? nullptr : std::get_if<T>(&found->second.data);
  if (!stored) throw std::runtime_error("the checkpoint lacks '" + path + "'");
  value = *stored;
}

template <class Stored, class T>
void Archive::single(const std::string& name, T& value) {
  Stored one{value};
  keep(name, one);
  if (one.size() != 1)
    throw std::runtime_error("the checkpoint has no single '" + prefix_ + name + "'");
  value = static_cast<T>(one.front());
}

void Archive::keep(const std::string& name, Doubles& value, std::size_t rows) {
  exchange(name, value, rows);
}
void Archive::keep(const std::string& name, Integers& value) { exchange(name, value, 1); }
void Archive::keep(const std::string& name, std::string& value) { exchange(name, value, 1); }
void Archive::keep(const std::string& name, double& value) { single<Doubles>(name, value); }
void Archive::keep(const std::string& name, std::int64_t& value) { single<Integers>(name, value); }
void Archive::keep(const std::string& name, int& value) { single<Integers>(name, value); }
void Archive::keep(const std::string& name, bool& value) { single<Integers>(name, value); }

}  // namespace brisance
