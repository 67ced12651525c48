#include "drivers/input.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "drivers/files.hpp"
#include "drivers/input_scan.hpp"
#include "drivers/input_value.hpp"

namespace brisance {
namespace {

constexpr std::size_t most_bytes = 16 << 20;
constexpr std::size_t most_levels = 64;

std::string joined(const std::string& list, const std::string& name) {
  return list.empty() ? name : list + "/" + name;
}

// Turns tags into a list. Keeps the open tags itself, so that no input can exhaust the stack.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file)
      : scanner_(text, file), file_(file), document_(file) {}

  Document read() {
    bool done = false;
    while (scanner_.next(tag_)) {
      if (done) fail("there must be one outermost list only");
      if (tag_.opens) open();
      if (tag_.closes) close();
      done = levels_.empty();
    }
    if (!levels_.empty()) {
      throw InputError("", "", "", "tag '" + levels_.back().tag + "' is never closed", file_,
                       levels_.back().line);
    }
    if (!done) throw InputError("", "", "", "is empty: there must be a <ParameterList>", file_);
    return std::move(document_);
  }

 private:
  struct Level {
    std::string tag, path;
    List* list;  // nullptr within a parameter
    int line;
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("", "", "", what, file_, tag_.line);
  }

  // The same for the parameter or list that the tag names, if it does.
  [[noreturn]] void refuse_entry(const std::string& what, const std::string& value = "") const {
    const std::string* name = tag_.attribute("name");
    if (!name) fail(tag_.name + " " + what);
    const std::string above = levels_.empty() ? "" : levels_.back().path;
    if (tag_.name == "Parameter") throw InputError(above, *name, value, what, file_, tag_.line);
    throw InputError(joined(above, *name), "", "", what, file_, tag_.line);
  }

  void open() {
    const bool is_list = tag_.name == "ParameterList";
    if (!is_list && tag_.name != "Parameter") {
      fail("tag '" + tag_.name + "' is unknown" +
           did_you_mean(tag_.name, {"ParameterList", "Parameter"}));
    }
    if (levels_.empty()) return open_top(is_list);
    if (!levels_.back().list) fail("a Parameter must not contain tags");
    if (levels_.size() == most_levels) fail("lists are nested more than 64 deep");
    check_attributes(is_list);
    const std::string& name = *tag_.attribute("name");
    const std::string path = joined(levels_.back().path, name);
    const auto [first, fresh] = document_.places.insert({path, {file_, tag_.line}});
    if (!fresh) refuse_entry("is given twice, first on line " + std::to_string(first->second.line));
    List& list = *levels_.back().list;
    if (!is_list) put(list, name);
    levels_.push_back({tag_.name, path, is_list ? &list.sublist(name) : nullptr, tag_.line});
  }

  void open_top(bool is_list) {
    if (!is_list) fail("the outermost tag must be a ParameterList");
    check_attributes(true);
    document_.places[""] = {file_, tag_.line};
    document_.list->setName(*tag_.attribute("name"));
    levels_.push_back({tag_.name, "", document_.list.get(), tag_.line});
  }

  void check_attributes(bool is_list) const {
    using Names = std::vector<std::string>;
    const Names needed = is_list ? Names{"name"} : Names{"name", "type", "value"};
    const std::string* name = tag_.attribute("name");
    for (const auto& [key, value] : tag_.attributes) {
      if (std::find(needed.begin(), needed.end(), key) == needed.end()) {
        refuse_entry("has the unknown attribute '" + key + "'" + did_you_mean(key, needed));
      }
    }
    for (const std::string& key : needed) {
      if (!tag_.attribute(key)) refuse_entry("needs the attribute '" + key + "'");
    }
    const bool padded = name->empty() || name->front() == ' ' || name->back() == ' ';
    if (padded || name->size() > 100 || name->find_first_of("/=<>") != name->npos) {
      fail("'" + one_line(*name) +
           "' is no name: 1 to 100 bytes, none of / = < >, no blank at the ends");
    }
  }

  void put(List& list, const std::string& name) const {
    const std::string &type = *tag_.attribute("type"), &value = *tag_.attribute("value");
    const std::string wrong = put_text(list, name, type, value);
    if (!wrong.empty()) refuse_entry(wrong, "'" + value + "'");
  }

  void close() {
    if (levels_.empty()) fail("</" + tag_.name + "> closes nothing");
    const Level& level = levels_.back();
    if (level.tag != tag_.name) {
      fail("</" + tag_.name + "> cannot close the " + level.tag + " of line " +
           std::to_string(level.line));
    }
    levels_.pop_back();
  }

  Scanner scanner_;
  std::string file_;
  Document document_;
  Tag tag_;
  std::vector<Level> levels_;
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<'   ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '&' ? "&amp;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  }
  return result;
}

// Sets "list/parameter=value" with the type in the schema, else in the list. Returns the path.
std::string assign(List& list, const List& valid, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == assignment.npos) throw InputError("", "", "", "must be list/parameter=value");
  std::string name = assignment.substr(0, equals);
  const std::string value = assignment.substr(equals + 1);
  const List nothing;
  const List* schema = &valid;
  List changed = list;
  List* here = &changed;
  const auto unknown = [&] {
    std::vector<std::string> known = names(*schema);
    for (const std::string& other : names(*here))
      if (std::find(known.begin(), known.end(), other) == known.end()) known.push_back(other);
    return "is unknown" + did_you_mean(name, known);
  };
  for (std::size_t slash; (slash = name.find('/')) != name.npos;) {
    const std::string rest = name.substr(slash + 1);
    name.resize(slash);
    const List* below = find_list(*schema, name);
    if (!below && !find_list(*here, name)) {
      throw InputError(joined(path_of(*here), name), "", "", unknown());
    }
    schema = below ? below : &nothing;
    here = &here->sublist(name);
    name = rest;
  }
  const List& typed = schema->isParameter(name) ? *schema : *here;
  if (!typed.isParameter(name)) throw InputError(path_of(*here), name, "", unknown());
  if (typed.isSublist(name)) refuse(typed, name, "is a list: name a parameter of it");
  const std::string wrong = put_text(*here, name, described(typed, name).type, value);
  if (!wrong.empty()) throw InputError(path_of(*here), name, "'" + value + "'", wrong);
  std::string path = joined(path_of(*here), name);
  list = changed;
  return path;
}

void write_list(const List& list, const std::string& margin, std::string& text) {
  text += margin + "<ParameterList name=\"" + escaped(list.name()) + "\">\n";
  for (const std::string& name : names(list)) {
    const Described entry = described(list, name);
    if (entry.type == "list") {
      List part = list.sublist(name);
      write_list(part.setName(name), margin + "  ", text);
      continue;
    }
    List trial;
    const std::string wrong = put_text(trial, name, entry.type, entry.value);
    if (!wrong.empty()) refuse(list, name, wrong);
    text += margin + "  <Parameter name=\"" + escaped(name) + "\" type=\"" + entry.type +
            "\" value=\"" + escaped(entry.value) + "\"/>\n";
  }
  text += margin + "</ParameterList>\n";
}

}  // namespace

Document::Document(std::string file) : list(std::make_unique<List>("scene")) {
  places[""] = {std::move(file), 0};
}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

InputError Document::locate(const InputError& error) const {
  if (!error.file.empty()) return error;
  std::string path = error.parameter.empty() ? error.list : joined(error.list, error.parameter);
  while (!places.count(path)) {
    const std::size_t slash = path.rfind('/');
    path.erase(slash == path.npos ? 0 : slash);
  }
  const Place& place = places.at(path);
  return {error.list, error.parameter, error.value, error.rule, place.file, place.line};
}

Document parse_input(const std::string& text, const std::string& file) {
  return Reader(text, file).read();
}

Document read_input(const std::string& path) {
  namespace fs = std::filesystem;
  const auto fail = [&](const std::string& what) { throw InputError("", "", "", what, path); };
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (!fs::exists(status)) fail("there is no such file");
  if (fs::is_directory(status)) fail("is a folder, not a scene");
  if (!fs::is_regular_file(status)) fail("is not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened");
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  if (stream.bad()) fail("cannot be read");
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > most_bytes) fail("is larger than 16 MB");
  return parse_input(text, path);
}

void apply_override(Document& document, const std::string& assignment, const List& valid) {
  const std::string option = "--set '" + assignment + "'";
  try {
    document.places[assign(*document.list, valid, assignment)] = {option, 0};
  } catch (const InputError& e) {
    throw InputError(e.list, e.parameter, e.value, e.rule, option);
  }
}

std::string input_text(const List& list, const std::string& comment) {
  std::string head = comment;
  for (std::size_t at; (at = head.find("--")) != head.npos;) head.replace(at, 2, "- -");
  std::string text = "<!-- " + head + " -->\n";
  write_list(list, "", text);
  return text;
}

void write_input(const List& list, const std::string& path, const std::string& comment) {
  write_file(path, input_text(list, comment));
}

}  // namespace brisance
