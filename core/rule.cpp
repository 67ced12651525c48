#include "core/rule.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace brisance {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string sentence(const InputError& e) {
  std::string where = e.file.empty() ? "" : one_line(e.file, 200);
  if (e.line > 0) where += ":" + std::to_string(e.line);
  std::string what;
  if (!e.list.empty()) what = "list '" + one_line(e.list) + "'";
  if (!e.parameter.empty()) {
    what += (what.empty() ? "" : ", ") + ("parameter '" + one_line(e.parameter) + "'");
  }
  if (!e.value.empty()) what += " = " + one_line(e.value) + ":";
  return (where.empty() ? "" : where + ": ") + what + (what.empty() ? "" : " ") +
         one_line(e.rule, 500);
}

std::string limits(const Rule& rule) {
  std::string text;
  if (std::isfinite(rule.low)) text = (rule.low_excluded ? "> " : ">= ") + text_of(rule.low);
  if (!std::isfinite(rule.high)) return text;
  return text + (text.empty() ? "" : " and ") + (rule.high_excluded ? "< " : "<= ") +
         text_of(rule.high);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

// Edits (insert, delete, replace, swap two neighbours) that turn a into b: optimal string
// alignment.
// Upper and lower case count as the same.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (lower(a[i - 1]) != lower(b[j - 1]));
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

template <class T>
constexpr bool is_array =
    std::is_same_v<T, std::vector<double>> || std::is_same_v<T, std::vector<int>> ||
    std::is_same_v<T, std::vector<std::string>>;

}  // namespace

// The base is made twice: the sentence needs the members.
InputError::InputError(std::string in_list, std::string of_parameter, std::string with_value,
                       std::string broken_rule, std::string in_file, int on_line)
    : std::runtime_error(""),
      list(std::move(in_list)),
      parameter(std::move(of_parameter)),
      value(std::move(with_value)),
      rule(std::move(broken_rule)),
      file(std::move(in_file)),
      line(on_line) {
  static_cast<std::runtime_error&>(*this) = std::runtime_error(sentence(*this));
}

Rule anything() { return {}; }
Rule above(double low) {
  Rule rule = at_least(low);
  rule.low_excluded = true;
  return rule;
}
Rule at_least(double low) {
  Rule rule;
  rule.low = low;
  return rule;
}
Rule below(double high) {
  Rule rule = at_most(high);
  rule.high_excluded = true;
  return rule;
}
Rule at_most(double high) {
  Rule rule;
  rule.high = high;
  return rule;
}
Rule positive() { return above(0); }
Rule at_least_zero() { return at_least(0); }
Rule between(double low, double high) { return at_least(low) && at_most(high); }
Rule one_of(std::vector<std::string> choices) {
  Rule rule;
  rule.choices = std::move(choices);
  return rule;
}
Rule entries(int count) {
  Rule rule;
  rule.entries = count;
  return rule;
}
Rule operator&&(const Rule& a, const Rule& b) {
  Rule both = a;
  if (b.low > a.low || (b.low == a.low && b.low_excluded)) {
    both.low = b.low;
    both.low_excluded = b.low_excluded;
  }
  if (b.high < a.high || (b.high == a.high && b.high_excluded)) {
    both.high = b.high;
    both.high_excluded = b.high_excluded;
  }
  if (both.choices.empty()) both.choices = b.choices;
  if (both.entries < 0) both.entries = b.entries;
  return both;
}

template <class T>
std::string broken(const Rule& rule, const T& value) {
  if constexpr (is_array<T>) {
    const int count = rule.entries;
    if (count >= 0 && value.size() != std::size_t(count)) {
      return "must have " + std::to_string(count) + (count == 1 ? " entry" : " entries");
    }
    for (const auto& entry : value) {
      const std::string wrong = broken(rule, entry);
      if (!wrong.empty()) return "every entry " + wrong;
    }
    return "";
  } else if constexpr (std::is_same_v<T, std::string>) {
    const auto& all = rule.choices;
    if (all.empty() || std::find(all.begin(), all.end(), value) != all.end()) return "";
    const std::string hint = did_you_mean(value, all);
    return "must be one of: " + joined(all) + (hint.find("mean") == hint.npos ? "" : hint);
  } else if constexpr (std::is_same_v<T, bool>) {
    return "";
  } else {
    if (!std::isfinite(double(value))) return "must be finite";
    const bool low = rule.low_excluded ? value > rule.low : value >= rule.low;
    const bool high = rule.high_excluded ? value < rule.high : value <= rule.high;
    return low && high ? "" : "must be " + limits(rule);
  }
}

template <class T>
std::string wording(const Rule& rule) {
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_same_v<T, std::string>) {
    return rule.choices.empty() ? "text" : "one of: " + joined(rule.choices);
  }
  if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    return rule.choices.empty() ? "texts" : "any of: " + joined(rule.choices);
  }
  std::string noun = std::is_same_v<T, int> ? "an integer" : "a number";
  if constexpr (is_array<T>) {
    noun = std::is_same_v<T, std::vector<int>> ? "integer" : "number";
    if (rule.entries != 1) noun += "s";
    if (rule.entries >= 0) noun = std::to_string(rule.entries) + " " + noun;
  }
  const std::string ends = limits(rule);
  return ends.empty() ? noun : noun + " " + ends;
}

template <class T>
std::string type_name() {
  if constexpr (std::is_same_v<T, double>) return "double";
  if constexpr (std::is_same_v<T, int>) return "int";
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_same_v<T, std::string>) return "string";
  if constexpr (std::is_same_v<T, std::vector<double>>) return "Array(double)";
  if constexpr (std::is_same_v<T, std::vector<std::string>>) return "Array(string)";
  return "Array(int)";
}

template <class T>
std::string text_of(const T& value) {
  if constexpr (is_array<T>) {
    std::string text;
    for (const auto& entry : value) text += (text.empty() ? "" : ", ") + text_of(entry);
    return "{" + text + "}";
  } else if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
  }
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::size_t longer = std::max(word.size(), name.size());
    if (longer - std::min(word.size(), name.size()) >= std::min(least, longer)) continue;
    const std::size_t edits = distance(word, name);
    if (edits >= std::min(least, longer)) continue;
    least = edits;
    nearest = &name;
  }
  if (nearest) return "; did you mean '" + *nearest + "'?";
  return names.empty() ? "" : "; there is: " + one_line(joined(names), 300);
}

std::string one_line(std::string text, std::size_t most) {
  if (text.size() > most) {
    std::size_t end = most - 3;
    while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // never half a UTF-8 character
    text = text.substr(0, end) + "...";
  }
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
  }
  return text;
}

#define BRISANCE_INSTANTIATE(T)                       \
  template std::string broken(const Rule&, const T&); \
  template std::string wording<T>(const Rule&);       \
  template std::string type_name<T>();                \
  template std::string text_of(const T&);
BRISANCE_INSTANTIATE(double)
BRISANCE_INSTANTIATE(int)
BRISANCE_INSTANTIATE(bool)
BRISANCE_INSTANTIATE(std::string)
BRISANCE_INSTANTIATE(std::vector<double>)
BRISANCE_INSTANTIATE(std::vector<int>)
BRISANCE_INSTANTIATE(std::vector<std::string>)
#undef BRISANCE_INSTANTIATE

}  // namespace brisance
