// The page of Hu & Chen (2006), made the way people make it; of its problems only the quickest
// runs.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;

TEST(Reproduce, ListNamesEveryTableAndFigure) {
  const Ran ran = run_program("reproduce --list");
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* exhibit :
       {"Fig. 6:", "Table 1:", "Fig. 8:", "Fig. 11:", "Fig. 12:", "Table 2:", "Fig. 14:",
        "Fig. 16:", "Table 3:", "Fig. 18:", "Fig. 19:", "Fig. 20:", "Fig. 21:"})
    EXPECT_NE(ran.out.find(exhibit), ran.out.npos) << exhibit;
}

TEST(Reproduce, RefusesAnUnknownProblemInOneLine) {
  const Ran ran = run_program("reproduce --only reimann");
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_NE(ran.err.find("riemann"), ran.err.npos) << ran.err;
}

class OnlyRiemann : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder("reproduce");
    first = reproduce("");
    page_of_first = read_file(page());
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static fs::path page() { return folder->path / "reproduce.html"; }
  static Ran reproduce(const std::string& more) {
    return run_program("reproduce --only riemann --out '" + folder->path.string() + "' " + more);
  }

  static Folder* folder;
  static Ran first;
  static std::string page_of_first;
};
Folder* OnlyRiemann::folder = nullptr;
Ran OnlyRiemann::first;
std::string OnlyRiemann::page_of_first;

TEST_F(OnlyRiemann, WritesAPageWithVerdictsThatNeedsNoNetwork) {
  EXPECT_EQ(first.status, 0) << first.err << first.out;
  for (const char* part :
       {"Fig. 6", ">reached<", "14.43", "13.45", "data:image/png;base64,", "Misprints and gaps"})
    EXPECT_NE(page_of_first.find(part), page_of_first.npos) << part;
  // Neither links nor sources elsewhere; a picture's base64 has no colon.
  EXPECT_EQ(page_of_first.find("://"), page_of_first.npos);
  for (const char* part : {">missed<", ">missing<", "--quick"})
    EXPECT_EQ(page_of_first.find(part), page_of_first.npos) << part;
}

TEST_F(OnlyRiemann, SaysWhichRunsWereTakenUp) {
  const Ran again = reproduce("--quick");
  EXPECT_EQ(again.status, 0) << again.err << again.out;
  EXPECT_NE(again.out.find("riemann: re-used"), again.out.npos) << again.out;
  EXPECT_NE(read_file(page()).find("2 of 2 runs were not run again"), std::string::npos);
}

TEST_F(OnlyRiemann, AMissedCheckShowsInPageAndStatus) {
  const fs::path path = folder->path / "runs/riemann/summary.json";
  const std::string before = read_file(path);
  auto summary = nlohmann::json::parse(before);
  summary["checks"][0]["verdict"] = "missed";
  write_file(path, summary.dump());
  const Ran missed = reproduce("--quick");
  write_file(path, before);
  EXPECT_EQ(missed.status, 1);
  EXPECT_NE(read_file(page()).find(">missed<"), std::string::npos);
}

TEST_F(OnlyRiemann, ARunOfAnotherSceneIsNotTakenUp) {
  const fs::path path = folder->path / "runs/riemann/reproduced.json";
  auto origin = nlohmann::json::parse(read_file(path));
  origin["scene"] = "of another scene";
  write_file(path, origin.dump());
  const Ran again = reproduce("--quick");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("riemann ..."), again.out.npos) << again.out;
  EXPECT_NE(again.out.find("riemann_paper: re-used"), again.out.npos) << again.out;
}

TEST(Reproduce, AMissingSceneShowsInPageAndStatus) {
  const Folder folder("reproduce_missing");
  const std::string command = "/usr/bin/python3 '" + script_file("reproduce.py").string() +
                              "' --program '" + BRISANCE_PROGRAM + "' --inputs '" +
                              folder.path.string() + "' --only riemann --out '" +
                              folder.path.string() + "' >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 1);
  EXPECT_NE(read_file(folder.path / "reproduce.html").find("scene missing"), std::string::npos);
}

}  // namespace
}  // namespace brisance
