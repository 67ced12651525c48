#include "test/mutations.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

namespace brisance::test {
namespace {

/// A tag of the text, [begin, end).
struct Element {
  std::size_t begin, end;
  std::string name, type, value;
  std::string within{};  // the list around it
  int level = 0;         // lists around it
  bool list = false, closing = false;
};

std::string attribute(const std::string& tag, const std::string& key) {
  const std::size_t at = tag.find(key + "=\"");
  if (at == tag.npos) return "";
  const std::size_t from = at + key.size() + 2;
  return tag.substr(from, tag.find('"', from) - from);
}

std::vector<Element> elements_of(const std::string& text) {
  std::vector<Element> all;
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      continue;
    }
    const std::size_t end = text.find('>', at) + 1;
    const std::string tag = text.substr(at, end - at);
    Element e{at, end, attribute(tag, "name"), attribute(tag, "type"), attribute(tag, "value")};
    e.list = tag.find("ParameterList") != tag.npos;
    e.closing = tag[1] == '/';
    if (e.closing) open.pop_back();
    e.level = static_cast<int>(open.size());
    e.within = open.empty() ? "" : open.back();
    if (e.list && !e.closing) open.push_back(e.name);
    all.push_back(e);
  }
  return all;
}

class Mutator {
 public:
  Mutator(const std::string& scene, unsigned seed)
      : scene_(scene), all_(elements_of(scene)), random_(seed) {}

  std::vector<Broken> every() {
    of_tags();
    of_values();
    of_structure();
    const std::size_t first = all_.front().begin, last = all_.back().begin;
    for (Broken& broken : mutations_of_bytes(scene_, first, last, static_cast<unsigned>(random_())))
      broken_.push_back(std::move(broken));
    return std::move(broken_);
  }

 private:
  static constexpr int places = 1;  // of each mutation; there are many scenes

  const std::string& scene_;
  const std::vector<Element> all_;
  std::mt19937 random_;
  std::vector<Broken> broken_;

  std::string with(const Element& e, const std::string& tag) const {
    std::string text = scene_;
    return text.replace(e.begin, e.end - e.begin, tag);
  }
  std::string tag(const Element& e) const { return scene_.substr(e.begin, e.end - e.begin); }
  static std::string parameter(const std::string& name, const std::string& type,
                               const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
  }

  /// A mutation at some of the elements that it fits: `mutate` returns the text.
  template <class Fits, class Mutate>
  void add(const std::string& name, const Fits& fits, const Mutate& mutate, bool set_up = false) {
    std::vector<const Element*> chosen;
    for (const Element& e : all_)
      if (fits(e)) chosen.push_back(&e);
    for (int k = 0; k < places && !chosen.empty(); ++k) {
      const std::size_t at = random_() % chosen.size();
      broken_.push_back({name, mutate(*chosen[at]), set_up});
      chosen.erase(chosen.begin() + static_cast<long>(at));
    }
  }

  /// The same with another tag for a parameter.
  template <class Fits, class Retag>
  void retag(const std::string& name, const Fits& fits, const Retag& change) {
    add(
        name, [&](const Element& e) { return !e.list && fits(e); },
        [&](const Element& e) { return with(e, change(e)); });
  }
  /// Another value for parameters that fit.
  template <class Fits>
  void value(const std::string& name, const Fits& fits, const std::string& changed,
             bool set_up = false) {
    add(
        name, [&](const Element& e) { return !e.list && fits(e); },
        [&](const Element& e) { return with(e, parameter(e.name, e.type, changed)); }, set_up);
  }

  static bool any(const Element&) { return true; }

  void of_tags() {
    retag("name misspelt", any,
          [](const Element& e) { return parameter(e.name + "qz", e.type, e.value); });
    retag("name empty", any, [](const Element& e) { return parameter("", e.type, e.value); });
    retag("name of 200 letters", any,
          [](const Element& e) { return parameter(std::string(200, 'n'), e.type, e.value); });
    retag("name with a slash", any,
          [](const Element& e) { return parameter("a/" + e.name, e.type, e.value); });
    retag("type unknown", any,
          [](const Element& e) { return parameter(e.name, "dubble", e.value); });
    retag("no type", any, [](const Element& e) {
      return "<Parameter name=\"" + e.name + "\" value=\"" + e.value + "\"/>";
    });
    retag("no value", any, [](const Element& e) {
      return "<Parameter name=\"" + e.name + "\" type=\"" + e.type + "\"/>";
    });
    retag("no name", any, [](const Element& e) {
      return "<Parameter type=\"" + e.type + "\" value=\"" + e.value + "\"/>";
    });
    retag("given twice", any, [&](const Element& e) { return tag(e) + tag(e); });
    retag("not closed", any,
          [&](const Element& e) { return tag(e).replace(tag(e).size() - 2, 2, ">"); });
    retag("tag within", any, [&](const Element& e) {
      return tag(e).replace(tag(e).size() - 2, 2, ">") + tag(e) + "</Parameter>";
    });
    retag("unknown attribute", any,
          [&](const Element& e) { return tag(e).insert(10, " unit=\"m\""); });
    retag("attribute twice", any,
          [&](const Element& e) { return tag(e).insert(10, " type=\"int\""); });
    retag("list for a parameter", any,
          [](const Element& e) { return "<ParameterList name=\"" + e.name + "\"/>"; });
    retag(
        "text for a number", [](const Element& e) { return e.type != "string"; },
        [](const Element& e) { return parameter(e.name, "string", e.value); });
    retag(
        "number for an array", [](const Element& e) { return e.type == "Array(double)"; },
        [](const Element& e) { return parameter(e.name, "double", "1"); });
    retag(
        "array for a number", [](const Element& e) { return e.type == "double"; },
        [](const Element& e) { return parameter(e.name, "Array(double)", "{" + e.value + "}"); });
    retag(
        "truth for a number",
        [](const Element& e) { return e.type == "double" || e.type == "int"; },
        [](const Element& e) { return parameter(e.name, "bool", "true"); });
    retag(
        "number for text", [](const Element& e) { return e.type == "string"; },
        [](const Element& e) { return parameter(e.name, "double", "1"); });
    for (const char* lost : {"<", ">", "\"", "="})
      retag(std::string("without ") + lost, any, [&](const Element& e) {
        const std::string whole = tag(e);
        return std::string(whole).erase(whole.find(lost), 1);
      });
  }

  void of_values() {
    const auto number = [](const Element& e) { return e.type == "double" || e.type == "int"; };
    for (const char* bad :
         {"", " ", "nan", "-inf", "1e999", "1,5", "0x1F", "1.5.2", "--3", "1e", "1e-3 m", "\u0663"})
      value(std::string("number '") + bad + "'", number, bad);
    const auto array = [](const Element& e) { return e.type.find("Array") == 0; };
    for (const char* bad :
         {"", "{1, nan}", "{1,,2}", "{1, 2", "1, 2}", "{{1}}", "{1; 2}", "{0, 0, 0, 0, 1e999}"})
      value(std::string("array '") + bad + "'", array, bad);
    static const std::set<std::string> of_places = {"origin", "low",   "high",
                                                    "centre", "place", "point"};
    value(
        "place of five entries",
        [&](const Element& e) { return array(e) && of_places.count(e.name) > 0; },
        "{0, 0, 0, 0, 0}");
    value(
        "place of none",
        [&](const Element& e) {
          return array(e) && of_places.count(e.name) > 0 && e.within != "exact";
        },
        "{}");
    static const std::set<std::string> positive = {
        "cell size",       "end",          "density",          "gamma", "bulk modulus",
        "Young's modulus", "yield stress", "detonation speed", "CFL",   "particles per cell",
        "outer radius",    "inner face"};
    const auto is_positive = [&](const Element& e) {
      return number(e) && positive.count(e.name) > 0;
    };
    value("zero", is_positive, "0");
    value("negative", is_positive, "-1");
    value(
        "choice unknown", [](const Element& e) { return e.type == "string" && e.name != "title"; },
        "qz");
    const auto named = [](const char* name) {
      return [=](const Element& e) { return e.name == name; };
    };
    const auto of_grid = [](const Element& e) {
      return e.name == "cell size" && e.within == "grid";
    };
    value("a thousand particles", named("particles per cell"), "1000");
    value(
        "integer of 64 bits", [](const Element& e) { return e.type == "int"; }, "4294967299");
    value(
        "cells without memory",
        [](const Element& e) { return e.name == "cells" && e.within == "grid"; },
        "{2147483647, 2147483647}");
    value("cells of no size", of_grid, "1e-300");
    value("cells of all size", of_grid, "1e300");
    value(
        "run without end", [](const Element& e) { return e.name == "end" && e.within == "time"; },
        "1e300", true);
    value("Courant number of 2", named("CFL"), "2");
    value("interval of nothing", named("interval"), "1e-300");
    value(
        "gauge elsewhere", [](const Element& e) { return e.name == "place"; }, "{1e9, 1e9}");
    retag(
        "range turned round",
        [](const Element& e) { return e.name == "most" && std::stod(e.value) < 1e300; },
        [](const Element& e) {
          return parameter("least", "double", "1e305") + parameter("most", "double", e.value);
        });
  }

  void of_structure() {
    const auto opens = [](const Element& e) { return e.list && !e.closing; };
    const auto part = [&](const Element& e) { return opens(e) && e.level == 1; };
    const auto whole = [&](const Element& e) {
      int depth = 0;
      for (const Element& other : all_) {
        if (other.begin < e.begin || !other.list) continue;
        depth += other.closing ? -1 : 1;
        if (depth == 0) return other.end;
      }
      return scene_.size();
    };
    add(
        "list not closed", [](const Element& e) { return e.closing; },
        [&](const Element& e) { return with(e, ""); });
    add("list not opened", opens, [&](const Element& e) { return with(e, ""); });
    add(
        "list closed as another", [](const Element& e) { return e.closing; },
        [&](const Element& e) { return with(e, "</Parameter>"); });
    add("list misspelt", part,
        [&](const Element& e) { return with(e, "<ParameterList name=\"" + e.name + "qz\">"); });
    add("list without name", opens, [&](const Element& e) { return with(e, "<ParameterList>"); });
    add("tag misspelt", opens,
        [&](const Element& e) { return with(e, "<Parameterlist name=\"" + e.name + "\">"); });
    add("list given twice", part, [&](const Element& e) {
      return std::string(scene_).insert(e.begin, scene_.substr(e.begin, whole(e) - e.begin));
    });
    add("list within itself", part, [&](const Element& e) {
      return std::string(scene_).insert(e.end, scene_.substr(e.begin, whole(e) - e.begin));
    });
    static const std::set<std::string> needed = {"grid", "time", "materials", "bodies"};
    const auto must_be = [&](const Element& e) { return part(e) && needed.count(e.name) > 0; };
    add("list left out", must_be,
        [&](const Element& e) { return std::string(scene_).erase(e.begin, whole(e) - e.begin); });
    add("list emptied", must_be, [&](const Element& e) {
      return std::string(scene_).replace(e.begin, whole(e) - e.begin,
                                         "<ParameterList name=\"" + e.name + "\"/>");
    });
    add("parameter for a list", part, [&](const Element& e) {
      return std::string(scene_).replace(e.begin, whole(e) - e.begin,
                                         parameter(e.name, "int", "1"));
    });
    std::string deep;
    for (int k = 0; k < 70; ++k) deep += "<ParameterList name=\"a\">";
    for (int k = 0; k < 70; ++k) deep += "</ParameterList>";
    for (const std::string& inserted :
         {deep, std::string("2.5"), std::string("<![CDATA[ ]]>"), std::string("<?run ?>"),
          std::string("<!-- a -- b -->"), std::string("<ParameterList name=\"qz\"/>"),
          std::string("</ParameterList>")})
      add("'" + inserted.substr(0, 20) + "' between", part,
          [&](const Element& e) { return std::string(scene_).insert(e.begin, inserted); });
  }
};

}  // namespace

std::vector<Broken> mutations(const std::string& scene, unsigned seed) {
  return Mutator(scene, seed).every();
}

}  // namespace brisance::test
