#pragma once
// The tags of an input, one by one: the strict part of XML that a scene needs. No recursion, no
// entity but the five of XML, no document type; comments may stand anywhere between tags.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brisance {

struct Tag {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;  // decoded
  bool opens = false;                                           // <a> and <a/>
  bool closes = false;                                          // </a> and <a/>
  int line = 0;

  /// The value of an attribute; nullptr when it is not there.
  const std::string* attribute(std::string_view wanted) const;
};

/// Goes through a text; throws InputError with file and line for whatever is not a well-formed tag.
class Scanner {
 public:
  /// Refuses control characters and what is not UTF-8. The text must outlive the scanner.
  Scanner(std::string_view text, std::string file);

  /// The next tag; false at the end of the text.
  bool next(Tag& tag);

 private:
  [[noreturn]] void fail(const std::string& what, int line) const;
  bool starts_with(std::string_view word) const;
  bool take(std::string_view word);
  void skip(std::size_t count);
  bool skip_blanks();
  std::string_view take_through(std::string_view end, const std::string& what);
  std::string take_name();
  void read_declaration();
  void read_tag(Tag& tag);
  void read_attribute(Tag& tag);
  std::string decoded(std::string_view raw, int line) const;

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Where the first byte stands that is neither printable UTF-8 nor a blank, tab or line end; npos:
/// nowhere.
std::size_t first_bad_byte(std::string_view text);

}  // namespace brisance
