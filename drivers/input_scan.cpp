#include "drivers/input_scan.hpp"

#include <algorithm>

#include "core/rule.hpp"

namespace brisance {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t most_attributes = 16;  // keeps the search for duplicates short

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == ':';
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return result;
}

// The length of the UTF-8 character at the front; 0 when it is none. Table 3-7 of the Unicode
// standard.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < length) return 0;
  const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  return length;
}

}  // namespace

std::size_t first_bad_byte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const bool control = (c >= 0 && c < ' ' && blanks.find(c) == blanks.npos) || c == 127;
    const std::size_t length = control ? 0 : utf8_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return text.npos;
}

const std::string* Tag::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes) {
    if (key == wanted) return &value;
  }
  return nullptr;
}

Scanner::Scanner(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  take("\xEF\xBB\xBF");  // a byte order mark, as some editors write
  text_.remove_prefix(at_);
  at_ = 0;
  const std::size_t bad = first_bad_byte(text_);
  if (bad == text_.npos) return;
  const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(bad), '\n');
  fail("byte " + std::to_string(static_cast<unsigned char>(text_[bad])) + " is no text (UTF-8)",
       int(line));
}

bool Scanner::next(Tag& tag) {
  for (;;) {
    skip_blanks();
    if (at_ == text_.size()) return false;
    const int line = line_;
    if (starts_with("<!--")) {
      skip(4);
      const std::string comment(take_through("-->", "the comment"));
      if ((comment + "-").find("--") != comment.npos) fail("'--' within a comment is no XML", line);
    } else if (at_ == 0 && take("<?xml ")) {
      read_declaration();
    } else if (starts_with("<!") || starts_with("<?")) {
      fail("document types, entities, CDATA and processing instructions are not allowed", line);
    } else if (!take("<")) {
      const std::size_t end = std::min(text_.find('<', at_), at_ + 40);
      fail("there is text outside of a tag: '" + std::string(text_.substr(at_, end - at_)) + "'",
           line);
    } else {
      read_tag(tag);
      return true;
    }
  }
}

void Scanner::read_declaration() {
  Tag tag;
  for (skip_blanks(); !take("?>"); skip_blanks()) {
    const bool attribute = at_ < text_.size() && is_letter(text_[at_]);
    if (!attribute) fail("the XML declaration is broken", line_);
    read_attribute(tag);
    const std::string& key = tag.attributes.back().first;
    const bool known = key == "version" || key == "encoding" || key == "standalone";
    if (!known) fail("the XML declaration is broken", line_);
  }
  const std::string* encoding = tag.attribute("encoding");
  const std::string name = encoding ? lower(*encoding) : "utf-8";
  if (name != "utf-8" && name != "us-ascii") fail("the encoding must be UTF-8", line_);
}

void Scanner::read_tag(Tag& tag) {
  tag = Tag{};
  tag.line = line_;
  tag.closes = take("/");
  tag.opens = !tag.closes;
  tag.name = take_name();
  if (tag.name.empty()) fail("'<' must be followed by the name of a tag", tag.line);
  for (;;) {
    const bool apart = skip_blanks();
    if (take(">")) return;
    if (tag.opens && take("/>")) {
      tag.closes = true;
      return;
    }
    const bool attribute = at_ < text_.size() && is_letter(text_[at_]);
    if (!attribute || !apart) {
      fail("tag '" + tag.name + "' is broken: there must be an attribute or '>'", line_);
    }
    if (!tag.opens) fail("the closing tag '" + tag.name + "' must not have attributes", line_);
    read_attribute(tag);
  }
}

void Scanner::read_attribute(Tag& tag) {
  const int line = line_;
  const std::string name = take_name();
  if (tag.attributes.size() == most_attributes) fail("a tag has too many attributes", line);
  if (tag.attribute(name)) fail("attribute '" + name + "' is given twice in one tag", line);
  skip_blanks();
  const bool equals = take("=");
  skip_blanks();
  const std::string quote = take("\"") ? "\"" : take("'") ? "'" : "";
  if (!equals || quote.empty()) {
    fail("attribute '" + name + "' must be followed by = and a value in quotes", line);
  }
  const std::string_view raw = take_through(quote, "the value of attribute '" + name + "'");
  if (raw.find('<') != raw.npos) {
    fail("the value of attribute '" + name + "' contains '<': is its closing quote missing?", line);
  }
  tag.attributes.emplace_back(name, decoded(raw, line));
}

// Line ends and tabs within a value count as blanks, as XML demands.
std::string Scanner::decoded(std::string_view raw, int line) const {
  static constexpr std::pair<std::string_view, char> entities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string text;
  while (!raw.empty()) {
    std::size_t used = 1;
    char c = raw[0];
    if (c == '&') {
      const auto known = std::find_if(std::begin(entities), std::end(entities), [&](const auto& e) {
        return raw.substr(0, e.first.size()) == e.first;
      });
      if (known == std::end(entities)) {
        fail("'&' must begin one of &lt; &gt; &amp; &quot; &apos;", line);
      }
      used = known->first.size();
      c = known->second;
    } else if (blanks.find(c) != blanks.npos) {
      c = ' ';
    }
    text += c;
    raw.remove_prefix(used);
  }
  return text;
}

void Scanner::fail(const std::string& what, int line) const {
  throw InputError("", "", "", what, file_, line);
}

bool Scanner::starts_with(std::string_view word) const {
  return text_.substr(at_, word.size()) == word;
}

bool Scanner::take(std::string_view word) {
  if (!starts_with(word)) return false;
  skip(word.size());
  return true;
}

void Scanner::skip(std::size_t count) {
  const auto from = text_.begin() + std::ptrdiff_t(at_);
  line_ += int(std::count(from, from + std::ptrdiff_t(count), '\n'));
  at_ += count;
}

bool Scanner::skip_blanks() {
  const std::size_t end = std::min(text_.find_first_not_of(blanks, at_), text_.size());
  const bool any = end > at_;
  skip(end - at_);
  return any;
}

std::string_view Scanner::take_through(std::string_view end, const std::string& what) {
  const std::size_t found = text_.find(end, at_);
  if (found == text_.npos) fail(what + " is never closed", line_);
  const std::string_view part = text_.substr(at_, found - at_);
  skip(part.size() + end.size());
  return part;
}

std::string Scanner::take_name() {
  std::size_t end = at_;
  while (end < text_.size() && is_name(text_[end])) ++end;
  const std::string name(text_.substr(at_, end - at_));
  at_ = end;
  return is_letter(name.empty() ? ' ' : name[0]) ? name : "";
}

}  // namespace brisance
