#include "core/parameters.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <ostream>
#include <type_traits>
#include <utility>

namespace brisance {
namespace {

using Teuchos::ParameterEntry;

// How Teuchos stores a T, and back.
template <class T>
const T& stored(const T& value) {
  return value;
}
template <class T>
Teuchos::Array<T> stored(const std::vector<T>& value) {
  return Teuchos::Array<T>(value);
}
template <class T>
using Stored = std::decay_t<decltype(stored(std::declval<const T&>()))>;

template <class T>
const T& unstored(const T& value) {
  return value;
}
template <class T>
std::vector<T> unstored(const Teuchos::Array<T>& value) {
  return value.toVector();
}

template <class T, class F>
bool visit_as(const ParameterEntry& entry, const F& f) {
  if (!entry.isType<Stored<T>>()) return false;
  f(unstored(Teuchos::any_cast<Stored<T>>(entry.getAny(false))));
  return true;
}

// f(value) with the value's own type, if that is one of the seven.
template <class F>
bool visit(const ParameterEntry& entry, const F& f) {
  return visit_as<double>(entry, f) || visit_as<int>(entry, f) || visit_as<bool>(entry, f) ||
         visit_as<std::string>(entry, f) || visit_as<std::vector<double>>(entry, f) ||
         visit_as<std::vector<int>>(entry, f) || visit_as<std::vector<std::string>>(entry, f);
}

std::string type_of(const ParameterEntry& entry) {
  std::string type = entry.isList() ? "list" : "";
  visit(entry, [&](const auto& value) { type = type_name<std::decay_t<decltype(value)>>(); });
  return type;
}

// A value in a message: texts in quotes.
std::string quoted(const List& list, const std::string& name) {
  const Described entry = described(list, name);
  return entry.type == "string" ? "'" + one_line(entry.value, 78) + "'" : entry.value;
}

std::string joined_path(const std::string& list, const std::string& name) {
  return list.empty() ? name : list + "/" + name;
}

// Carries the rule on an entry of a schema, so that Teuchos's own validation obeys it too.
struct RuleValidator : Teuchos::ParameterEntryValidator {
  RuleValidator(Rule r, bool need) : rule(std::move(r)), required(need) {}

  const std::string getXMLTypeName() const override { return "rule"; }
  void printDoc(const std::string& doc, std::ostream& out) const override { out << doc << '\n'; }
  ValidStringsList validStringValues() const override {
    if (rule.choices.empty()) return Teuchos::null;
    return Teuchos::rcp(new Teuchos::Array<std::string>(rule.choices));
  }
  void validate(const ParameterEntry& entry, const std::string& name,
                const std::string& list) const override {
    visit(entry, [&](const auto& value) {
      const std::string wrong = broken(rule, value);
      if (!wrong.empty()) throw InputError(path_of(List(list)), name, text_of(value), wrong);
    });
  }

  Rule rule;
  bool required;  // without default; false on a list: it may be absent
};

const RuleValidator* rule_on(const ParameterEntry& entry) {
  return dynamic_cast<const RuleValidator*>(entry.validator().get());
}

template <class T>
void put(List& valid, const std::string& name, const T& value, const Rule& rule, bool required,
         const std::string& doc) {
  if (doc.empty() || doc.back() != ']' || doc.rfind('[') == doc.npos) {
    throw std::logic_error("the documentation of '" + name + "' must end with its unit in [ ]");
  }
  const auto validator = Teuchos::rcp(new RuleValidator(rule, required));
  const ParameterEntry entry(stored(value), !required, false, doc, validator);
  if (!required) validator->validate(entry, name, valid.name());
  valid.setEntry(name, entry);
}

// The given value in the type of the schema: integers count as numbers.
ParameterEntry converted(const ParameterEntry& given, const std::string& type) {
  ParameterEntry result;
  result.setAnyValue(given.getAny(false));
  if (type == type_name<double>()) {
    visit_as<int>(given, [&](int value) { result.setValue(double(value)); });
  } else if (type == type_name<std::vector<double>>()) {
    visit_as<std::vector<int>>(given, [&](const std::vector<int>& values) {
      result.setValue(Teuchos::Array<double>(values.begin(), values.end()));
    });
  }
  return result;
}

// One parameter of the schema as it was given, or its default.
ParameterEntry completed(const List& given, const List& valid, const std::string& name) {
  const Described model = described(valid, name);
  const ParameterEntry* found = given.getEntryPtr(name);
  if (!found) {
    if (model.required) refuse(given, name, "is missing: it must be " + model.rule);
    ParameterEntry standard;
    standard.setAnyValue(valid.getEntry(name).getAny(false), true);
    return standard;
  }
  const ParameterEntry result = converted(*found, model.type);
  if (type_of(result) != model.type) refuse(given, name, "must be " + model.rule);
  if (const RuleValidator* validator = rule_on(valid.getEntry(name))) {
    visit(result, [&](const auto& value) {
      const std::string wrong = broken(validator->rule, value);
      if (!wrong.empty()) refuse(given, name, wrong);
    });
  }
  return result;
}

void complete(const List& given, const List& valid, List& result) {
  for (const std::string& name : names(given)) {
    if (valid.isParameter(name)) continue;
    const std::string path = path_of(given);
    const std::string unknown = "is unknown" + did_you_mean(name, names(valid));
    if (given.isSublist(name)) throw InputError(joined_path(path, name), "", "", unknown);
    throw InputError(path, name, "", unknown);
  }
  for (const std::string& name : names(valid)) {
    if (!valid.isSublist(name)) {
      result.setEntry(name, completed(given, valid, name));
      continue;
    }
    const List* part = find_list(given, name);
    if (!part && described(valid, name).optional) continue;
    const List nothing(given.name() + "->" + name);
    complete(part ? *part : nothing, valid.sublist(name), result.sublist(name));
  }
}

}  // namespace

template <class T>
void declare(List& valid, const std::string& name, const T& standard, const Rule& rule,
             const std::string& doc) {
  put(valid, name, standard, rule, false, doc);
}

void declare(List& valid, const std::string& name, const char* standard, const Rule& rule,
             const std::string& doc) {
  declare(valid, name, std::string(standard), rule, doc);
}

template <class T>
void declare_required(List& valid, const std::string& name, const Rule& rule,
                      const std::string& doc) {
  put(valid, name, T{}, rule, true, doc);
}

List& declare_list(List& valid, const std::string& name, const std::string& doc) {
  return valid.sublist(name, false, doc);
}

List& declare_optional_list(List& valid, const std::string& name, const std::string& doc) {
  List& list = valid.sublist(name, false, doc);
  valid.getEntryRCP(name)->setValidator(Teuchos::rcp(new RuleValidator({}, false)));
  return list;
}

List check(const List& given, const List& valid) {
  List result(given.name());
  complete(given, valid, result);
  return result;
}

template <class T>
T peek(const List& given, const List& valid, const std::string& name) {
  List one(given.name());
  one.setEntry(name, completed(given, valid, name));
  return get<T>(one, name);
}

template <class T>
T get(const List& list, const std::string& name) {
  const ParameterEntry* entry = list.getEntryPtr(name);
  if (!entry) refuse(list, name, "is missing");
  if (!entry->isType<Stored<T>>()) refuse(list, name, "must be " + wording<T>({}));
  return unstored(Teuchos::any_cast<Stored<T>>(entry->getAny()));
}

const List* find_list(const List& list, const std::string& name) {
  if (!list.isParameter(name)) return nullptr;
  if (!list.isSublist(name)) refuse(list, name, "must be a list, not a parameter");
  return &list.sublist(name);
}

std::vector<std::string> names(const List& list) {
  std::vector<std::string> all;
  for (auto it = list.begin(); it != list.end(); ++it) all.push_back(list.name(it));
  return all;
}

std::vector<std::string> list_names(const List& list) {
  std::vector<std::string> all;
  for (const std::string& name : names(list)) {
    if (list.isSublist(name)) all.push_back(name);
  }
  return all;
}

std::string path_of(const List& list) {
  const std::string arrow = "->";  // Teuchos names a sublist "top->materials->air"
  std::string path = list.name();
  const std::size_t top = path.find(arrow);
  if (top == path.npos) return "";
  path.erase(0, top + arrow.size());
  for (std::size_t at; (at = path.find(arrow)) != path.npos;) path.replace(at, arrow.size(), "/");
  return path;
}

void refuse(const List& list, const std::string& name, const std::string& rule) {
  const std::string path = path_of(list);
  if (list.isSublist(name)) throw InputError(joined_path(path, name), "", "", rule);
  throw InputError(path, name, list.isParameter(name) ? quoted(list, name) : "", rule);
}

Described described(const List& list, const std::string& name) {
  const ParameterEntry& entry = list.getEntry(name);
  const RuleValidator* validator = rule_on(entry);
  Described result;
  result.type = type_of(entry);
  visit(entry, [&](const auto& value) {
    result.value = text_of(value);
    result.rule = wording<std::decay_t<decltype(value)>>(validator ? validator->rule : Rule{});
  });
  result.doc = entry.docString();
  const std::size_t unit = entry.isList() ? result.doc.npos : result.doc.rfind('[');
  if (unit != result.doc.npos) {
    result.unit = result.doc.substr(unit);
    result.doc.erase(result.doc.find_last_not_of(' ', unit - 1) + 1);
  }
  result.required = validator && validator->required;
  result.optional = validator && entry.isList();
  return result;
}

#define BRISANCE_INSTANTIATE(T)                                                                  \
  template void declare(List&, const std::string&, const T&, const Rule&, const std::string&);   \
  template void declare_required<T>(List&, const std::string&, const Rule&, const std::string&); \
  template T peek<T>(const List&, const List&, const std::string&);                              \
  template T get<T>(const List&, const std::string&);
BRISANCE_INSTANTIATE(double)
BRISANCE_INSTANTIATE(int)
BRISANCE_INSTANTIATE(bool)
BRISANCE_INSTANTIATE(std::string)
BRISANCE_INSTANTIATE(std::vector<double>)
BRISANCE_INSTANTIATE(std::vector<int>)
BRISANCE_INSTANTIATE(std::vector<std::string>)
#undef BRISANCE_INSTANTIATE

}  // namespace brisance
