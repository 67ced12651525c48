// Every scene in inputs/, whatever it shows.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <filesystem>
#include <regex>

#include "drivers/checks.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/locations.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> every_input() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs"))
    if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class EveryInput : public testing::TestWithParam<std::string> {
 protected:
  std::string text = read_file(GetParam());
};

TEST_P(EveryInput, CompletedAndWrittenReadsBackTheSame) {
  const List scene = load_scene({GetParam(), {}, {}});
  const fs::path path =
      fs::path(testing::TempDir()) / ("brisance_" + fs::path(GetParam()).filename().string());
  write_input(scene, path.string(), "completed");
  List again = load_scene({path.string(), {}, {}});
  again.setName(scene.name());  // a scene is named after its file
  EXPECT_TRUE(Teuchos::haveSameValues(again, scene, true));
  EXPECT_EQ(input_text(again, ""), input_text(scene, ""));
  fs::remove(path);
}

TEST_P(EveryInput, IsNamedLikeItsFileAndHasATitle) {
  const Document document = read_input(GetParam());
  EXPECT_EQ(document.list->name(), fs::path(GetParam()).stem().string());
  EXPECT_FALSE(get<std::string>(*document.list, "title").empty());
}

// A year of a source, the paper's name, or a derivation in place.
TEST_P(EveryInput, SaysWhereItComesFrom) {
  ASSERT_EQ(text.compare(0, 5, "<!-- "), 0);
  const std::string comment = text.substr(0, text.find("-->"));
  EXPECT_TRUE(std::regex_search(comment,
                                std::regex("[( ](19|20)[0-9][0-9][,.;)]|Hu & Chen|To first order")))
      << comment;
}

TEST_P(EveryInput, ChecksTheBooksAndAnAnswer) {
  const List scene = load_scene({GetParam(), {}, {}});
  const List* checks = find_list(scene, "checks");
  ASSERT_NE(checks, nullptr);
  const auto quantities = list_names(*checks);
  EXPECT_EQ(std::count(quantities.begin(), quantities.end(), "mass error"), 1);
  for (const auto& quantity : quantities) {
    const Verdict v = judge_one(checks->sublist(quantity), quantity, 0, "-");
    EXPECT_NE(v.limit(), "any") << quantity;
    EXPECT_LT(v.least, v.most) << quantity;
  }
}

TEST_P(EveryInput, CanBeSetUp) {
  const List scene = load_scene({GetParam(), {}, {}});
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  EXPECT_GT(simulation->particle_count(), 0);
  EXPECT_GT(simulation->dt(), 0);
  EXPECT_LT(get<double>(scene.sublist("time"), "end") / simulation->dt(), 2e5);
}

INSTANTIATE_TEST_SUITE_P(Inputs, EveryInput, testing::ValuesIn(every_input()),
                         [](const auto& p) { return fs::path(p.param).stem().string(); });

TEST(Inputs, CoverThePapersTwoGasProblems) {
  const auto files = every_input();
  for (const char* name : {"riemann.xml", "sedov_table1.xml", "sedov_as_printed.xml"})
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [&](const std::string& f) {
      return fs::path(f).filename() == name;
    })) << name;
}

}  // namespace
}  // namespace brisance
