#include "drivers/describe.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <ostream>
#include <sstream>

namespace brisance {
namespace {

constexpr std::size_t columns = 100;

struct Widths {
  std::size_t name = 0, value = 0, unit = 0;
};

std::string value_of(const Described& entry) {
  if (entry.required) return "required";
  return entry.value.empty() ? "''" : entry.value;
}

void measure(const List& valid, std::size_t margin, Widths& widths) {
  for (const std::string& name : names(valid)) {
    const Described entry = described(valid, name);
    if (entry.type == "list") {
      measure(valid.sublist(name), margin + 2, widths);
      continue;
    }
    widths.name = std::max(widths.name, margin + name.size() + 2);
    widths.value = std::max(widths.value, value_of(entry).size() + 2);
    widths.unit = std::max(widths.unit, entry.unit.size() + 2);
  }
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(text.size() < width ? width - text.size() : 2, ' ');
}

// Prints text after what already stands on the line, word by word, with the same margin on later
// lines.
void wrap(std::ostream& out, std::size_t margin, const std::string& text) {
  std::istringstream words(text);
  std::size_t at = margin;
  for (std::string word; words >> word; at += word.size()) {
    if (at > margin && at + 1 + word.size() > columns) {
      out << '\n' << std::string(margin, ' ');
      at = margin;
    }
    if (at > margin) {
      out << ' ';
      ++at;
    }
    out << word;
  }
  out << '\n';
}

void print(const List& valid, std::size_t margin, const Widths& widths, std::ostream& out) {
  const std::string indent(margin, ' ');
  for (const std::string& name : names(valid)) {
    const Described entry = described(valid, name);
    if (entry.type == "list") continue;
    const std::string head = padded(indent + name, widths.name) +
                             padded(value_of(entry), widths.value) +
                             padded(entry.unit, widths.unit);
    out << head;
    wrap(out, head.size(), entry.rule);
    out << std::string(widths.name, ' ');
    wrap(out, widths.name, entry.doc);
  }
  for (const std::string& name : list_names(valid)) {
    const Described entry = described(valid, name);
    out << '\n' << indent << name << (entry.optional ? " (optional): " : ": ");
    wrap(out, margin + 4, entry.doc);
    print(valid.sublist(name), margin + 2, widths, out);
  }
}

}  // namespace

void describe(const List& valid, std::ostream& out) {
  Widths widths;
  measure(valid, 0, widths);
  print(valid, 0, widths, out);
}

}  // namespace brisance
