// A corpus of broken scenes: mutations of every scene in inputs/, and some made by hand. Each ends
// with one line, soon.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>

#include "drivers/commands.hpp"
#include "drivers/exact.hpp"
#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "drivers/simulation.hpp"
#include "test/mutations.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Broken;
using test::Folder;

/// Reads a scene and sets it up if asked to. Returns what is told of its fault; anything but that
/// fails the test.
void expect_one_line(const Broken& broken, const fs::path& file) {
  SCOPED_TRACE(broken.name);
  std::ofstream(file, std::ios::binary) << broken.text;
  const auto started = std::chrono::steady_clock::now();
  try {
    const List scene = load_scene({file.string(), {}, {}});
    if (broken.set_up) {
      const List* exact_list = find_list(scene, "exact");
      const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
      make_simulation(scene, exact.get());
    }
    ADD_FAILURE() << "is accepted";
  } catch (const InputError& raw) {
    const InputError error = raw.file.empty() ? locate({file.string(), {}, {}}, raw) : raw;
    const std::string told = error.what();
    EXPECT_EQ(std::count_if(told.begin(), told.end(), [](char c) { return c >= 0 && c < ' '; }), 0)
        << told;
    EXPECT_LT(told.size(), 1200u) << told;
    EXPECT_FALSE(error.rule.empty()) << told;
    EXPECT_EQ(told.rfind(file.string() + ":", 0), 0u) << told;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "is told as no fault of the input: " << error.what();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
  EXPECT_LT(taken.count(), 10);
}

std::vector<std::string> scenes() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs"))
    if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// The same on every machine, another for each scene (FNV-1a).
unsigned seed_of(const std::string& file) {
  unsigned seed = 2166136261U;
  for (const char c : fs::path(file).stem().string())
    seed = (seed ^ static_cast<unsigned char>(c)) * 16777619U;
  return seed;
}

class MutationsOf : public testing::TestWithParam<std::string> {};

TEST_P(MutationsOf, AreEachToldInOneLine) {
  const Folder folder("corpus_" + fs::path(GetParam()).stem().string());
  const auto all = test::mutations(read_file(GetParam()), seed_of(GetParam()));
  EXPECT_GT(all.size(), 80u);
  for (const Broken& broken : all) expect_one_line(broken, folder.path / "a.xml");
}

INSTANTIATE_TEST_SUITE_P(Corpus, MutationsOf, testing::ValuesIn(scenes()),
                         [](const auto& p) { return fs::path(p.param).stem().string(); });

// ---- By hand ----

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

/// Sod's tube with one place changed.
Broken tube(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = read_file(data_folder() / "inputs/sod.xml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  if (at != text.npos) text.replace(at, from.size(), to);
  return {name, text};
}

TEST(Corpus, ThatIsNoSceneAtAllIsToldInOneLine) {
  const Folder folder("corpus_texts");
  const Broken texts[] = {
      {"nothing", ""},
      {"a million blanks", std::string(1 << 20, ' ')},
      {"a million line ends", std::string(1 << 20, '\n')},
      {"a million zeros", std::string(1 << 20, '\0')},
      {"a million brackets", std::string(1 << 20, '<')},
      {"a million quotes", "<ParameterList name=" + std::string(1 << 20, '"')},
      {"a million ampersands", "<ParameterList name=\"" + std::string(1 << 20, '&') + "\"/>"},
      {"a million dashes", "<!--" + std::string(1 << 20, '-') + "-->"},
      {"a hundred thousand lists", repeated("<ParameterList name='a'>", 100000)},
      {"a hundred thousand ends", repeated("</ParameterList>", 100000)},
      {"a mark of byte order", "\xEF\xBB\xBF"},
      {"half a mark", "\xEF\xBB"},
      {"a bracket", "<"},
      {"brackets", "<>"},
      {"an end without name", "</>"},
      {"half a comment", "<!-"},
      {"a comment that overlaps itself", "<!-->"},
      {"half a declaration", "<?xml version='1.0'"},
      {"a declaration alone", "<?xml version='1.0'?>"},
      {"JSON", "{\"grid\": {\"cells\": [200]}}"},
      {"YAML", "grid:\n  cells: [200]\n"},
      {"HTML", "<html><body>404</body></html>"},
      {"a table", "time,mass\n0,1\n"},
      {"a program",
       "\x7F"
       "ELF\x02\x01\x01"},
      {"a picture", "\x89PNG\r\n\x1A\n"},
      {"a packed file", "PK\x03\x04"},
      {"an empty list", "<ParameterList name=\"a\"/>"},
      {"a nameless list", "<ParameterList name=\"\"/>"}};
  for (const Broken& broken : texts) expect_one_line(broken, folder.path / "a.xml");
}

TEST(Corpus, OfSizesAndValuesThatNobodyMeansIsToldInOneLine) {
  const Folder folder("corpus_values");
  const std::string end = "type=\"double\" value=\"0.2\"", time = "<ParameterList name=\"time\">",
                    gas = "<ParameterList name=\"gas\">", gamma = "value=\"1.4\"";
  const Broken scenes[] = {
      tube("a number of a million digits", end,
           "type=\"double\" value=\"" + std::string(1 << 20, '9') + "\""),
      tube("a text of a million letters", end,
           "type=\"string\" value=\"" + std::string(1 << 20, 'a') + "\""),
      tube("an array of a million cells", "{200}", "{200" + repeated(",1", 1 << 20) + "}"),
      tube("an array of a million braces", "{200}", std::string(1 << 20, '{')),
      tube(
          "a hundred thousand parameters", time,
          time +
              [] {
                std::string all;
                for (int k = 0; k < 100000; ++k)
                  all +=
                      "<Parameter name=\"a" + std::to_string(k) + "\" type=\"int\" value=\"1\"/>\n";
                return all;
              }()),
      tube("ten thousand empty materials", gas,
           [] {
             std::string all;
             for (int k = 0; k < 10000; ++k)
               all += "<ParameterList name=\"a" + std::to_string(k) + "\"/>\n";
             return all;
           }() +
               gas),
      tube("a list in a material", gas, gas + "<ParameterList name=\"gas\"/>"),
      tube("a name in capitals", "name=\"end\"", "name=\"END\""),
      tube("a tag in small letters", "<ParameterList name=\"grid\">",
           "<parameterlist name=\"grid\">"),
      tube("quotes of a word processor", end, "type=\"double\" value=\u201D0.2\u201D"),
      tube("a minus of a word processor", end, "type=\"double\" value=\"\u22120.2\""),
      tube("digits of another script", end, "type=\"double\" value=\"\uFF10.2\""),
      tube("a blank that does not break", end, "type=\"double\" value=\"0.2\u00A0\""),
      tube("a name with an end of line", "name=\"end\"", "name=\"en\nd\""),
      tube("a unit", end, "type=\"double\" value=\"200 ms\""),
      tube("a formula", end, "type=\"double\" value=\"1/5\""),
      tube("an exponent of Fortran", end, "type=\"double\" value=\"2d-1\""),
      tube("a plus", end, "type=\"double\" value=\"+ 0.2\""),
      tube("gamma of a liquid drop", gamma, "value=\"1\""),
      tube("gamma that is infinite", gamma, "value=\"infinity\""),
      tube("no cells", "{200}", "{0}"),
      tube("cells of a mirror", "{200}", "{-200}"),
      tube("half a cell", "{200}", "{200.5}"),
      tube("a number for the geometry", "type=\"string\" value=\"line\"",
           "type=\"int\" value=\"1\""),
      tube("three directions", "value=\"line\"", "value=\"space\""),
      tube("a plane of one direction", "value=\"line\"", "value=\"plane strain\"")};
  for (const Broken& broken : scenes) expect_one_line(broken, folder.path / "a.xml");
}

}  // namespace
}  // namespace brisance
