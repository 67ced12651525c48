#pragma once
// What outlives a step, under names, in memory. Whoever has such state lists it once, in a member
// `keep(Archive&)` that is used in both directions: what is written is what is read.
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace brisance {

class Archive {
 public:
  using Doubles = std::vector<double>;
  using Integers = std::vector<std::int64_t>;
  struct Entry {
    std::variant<Doubles, Integers, std::string> data;
    std::size_t rows = 1;  ///< numbers are a table of so many rows of the same length
  };
  using Entries = std::map<std::string, Entry>;  // by path, "material steel/position"

  /// To be written.
  Archive() = default;
  /// To be read.
  explicit Archive(Entries entries) : entries_(std::move(entries)), reading_(true) {}

  bool reading() const { return reading_; }
  Entries& entries() { return entries_; }

  /// Stores the value, or sets it to what is stored. Throws std::runtime_error with one line where
  /// there is none of that name and type.
  void keep(const std::string& name, Doubles& value, std::size_t rows = 1);
  void keep(const std::string& name, Integers& value);
  void keep(const std::string& name, std::string& value);
  void keep(const std::string& name, double& value);
  void keep(const std::string& name, std::int64_t& value);
  void keep(const std::string& name, int& value);
  void keep(const std::string& name, bool& value);

  /// While it lives, names go below that of a part.
  class Part {
   public:
    Part(Archive& archive, const std::string& name);
    ~Part() { archive_.prefix_.resize(size_); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    Archive& archive_;
    std::size_t size_;
  };

 private:
  Entries entries_;
  std::string prefix_;
  bool reading_ = false;

  template <class T>
  void exchange(const std::string& name, T& value, std::size_t rows);
  template <class Stored, class T>
  void single(const std::string& name, T& value);
};

/// What has such state beside another face of its own: an exact solution that is measured along the
/// run.
class Remembers {
 public:
  virtual ~Remembers() = default;
  virtual void keep(Archive& archive) = 0;
};

}  // namespace brisance
