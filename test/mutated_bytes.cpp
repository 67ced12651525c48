// Mutations that break the bytes of a text, or what is around it.
#include <algorithm>
#include <random>

#include "test/mutations.hpp"

namespace brisance::test {

std::vector<Broken> mutations_of_bytes(const std::string& scene, std::size_t first,
                                       std::size_t last, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Broken> broken;
  const auto text = [&](const std::string& name, const std::string& changed) {
    broken.push_back({name, changed});
  };
  text("two roots", scene + scene.substr(first));
  text("closed once more", scene + "</ParameterList>");
  text("without an end", scene.substr(0, last));
  text("text at its end", scene + "end");
  text("two marks of byte order", "\xEF\xBB\xBF\xEF\xBB\xBF" + scene);
  text("of another encoding", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + scene);
  text("with a document type", "<!DOCTYPE a [<!ENTITY b \"c\">]>" + scene);
  for (const int width : {2, 4})
    for (const bool big : {false, true})
      for (const bool mark : {false, true}) {
        std::string wide;
        const auto put = [&](int low, int high) {
          std::string unit(static_cast<std::size_t>(width), '\0');
          unit[0] = static_cast<char>(low);
          unit[1] = static_cast<char>(high);
          if (big) std::reverse(unit.begin(), unit.end());
          wide += unit;
        };
        if (mark) put(0xFF, 0xFE);
        for (const char c : scene) put(c, 0);
        text("in UTF-" + std::to_string(8 * width) + (big ? " BE" : " LE") +
                 (mark ? ", marked" : ""),
             wide);
      }
  const auto somewhere = [&] { return first + random() % (last - first); };
  text("cut off", scene.substr(0, somewhere()));
  for (const char* bytes :
       {"\xE9 ", "\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\x07", "\x7F"})
    text("bytes that are no text", std::string(scene).insert(somewhere(), bytes));
  text("a byte 0", std::string(scene).insert(somewhere(), 1, '\0'));
  return broken;
}

}  // namespace brisance::test
