// What people type wrong: each mistake ends the program with status 2 and one line that says where
// and what, before anything is written.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <ostream>

#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;

std::string sod() { return (data_folder() / "inputs/sod.xml").string(); }

/// The text of the scene with one place changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = read_file(sod());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// Runs the program, which must end with that status and tell why in one line.
void expect_told(const std::string& arguments, int status, const std::string& told) {
  SCOPED_TRACE(arguments);
  const Ran ran = run_program(arguments);
  EXPECT_EQ(ran.status, status);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_NE(ran.err.find(told), ran.err.npos) << ran.err;
}

void expect_refused(const std::string& arguments, const fs::path& out, const std::string& told) {
  expect_told(arguments + " --out '" + out.string() + "'", 2, told);
  EXPECT_FALSE(fs::exists(out)) << arguments;
}

/// A change of the scene, a part of the changed text that stands on the line to be named, and what
/// is to be told of it.
struct Mistake {
  std::string name, from, to, on_line_of, told;
  friend std::ostream& operator<<(std::ostream& out, const Mistake& m) { return out << m.name; }
};

class MistakeInAScene : public testing::TestWithParam<Mistake> {};

TEST_P(MistakeInAScene, IsToldInOneLineWithFileAndLine) {
  const Mistake& m = GetParam();
  const Folder folder("mistake");
  const fs::path file = folder.path / "a.xml";
  const std::string text = changed(m.from, m.to);
  std::ofstream(file) << text;
  const std::size_t at = text.find(m.on_line_of);
  ASSERT_NE(at, text.npos);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  expect_refused("run '" + file.string() + "'", folder.path / "out",
                 file.string() + ":" + std::to_string(line) + ": " + m.told);
}

const std::string end_given = "<Parameter name=\"end\" type=\"double\" value=\"0.2\"/>",
                  time_list = "<ParameterList name=\"time\">";

const Mistake mistakes[] = {
    {"UnknownParameter", "name=\"end\"", "name=\"ende\"", "\"ende\"",
     "list 'time', parameter 'ende' is unknown; did you mean 'end'?"},
    {"UnknownList", time_list, "<ParameterList name=\"tiem\">", "\"tiem\"",
     "list 'tiem' is unknown; did you mean 'time'?"},
    {"MissingParameter", end_given, "", time_list, "list 'time', parameter 'end' is missing"},
    {"NotANumber", "value=\"0.2\"", "value=\"0,2\"", "\"0,2\"",
     "list 'time', parameter 'end' = '0,2': must be a number"},
    {"NumberOutOfItsRange", "value=\"0.2\"", "value=\"-1\"", "\"-1\"",
     "list 'time', parameter 'end' = -1: must be > 0"},
    {"NotFinite", "value=\"0.2\"", "value=\"inf\"", "\"inf\"",
     "list 'time', parameter 'end' = 'inf': must be finite"},
    {"WrongType", "type=\"double\" value=\"0.2\"", "type=\"string\" value=\"0.2\"", "\"0.2\"",
     "list 'time', parameter 'end' = '0.2': must be a number"},
    {"UnknownLaw", "perfect gas", "perfect gsa", "perfect gsa",
     "list 'materials/gas', parameter 'law' = 'perfect gsa': must be one of"},
    {"LawOutOfItsRange", "value=\"1.4\"", "value=\"0.9\"", "\"0.9\"",
     "list 'materials/gas', parameter 'gamma' = 0.9: must be > 1"},
    {"UnknownMaterial", "name=\"material\" type=\"string\" value=\"gas\"",
     "name=\"material\" type=\"string\" value=\"air\"", "\"air\"",
     "list 'bodies/gas', parameter 'material' = 'air': must be one of: gas"},
    {"TooManyEntries", "{200}", "{200, 3}", "{200, 3}",
     "list 'grid', parameter 'cells' = {200, 3}: must have 1 entry"},
    {"UnknownMeasure", "\"L1 density\"", "\"L2 density\"", "\"L2 density\"",
     "list 'checks/L2 density' is unknown; did you mean 'L1 density'?"},
    {"UnknownSolution", "value=\"riemann\"", "value=\"reimann\"", "\"reimann\"",
     "list 'exact', parameter 'solution' = 'reimann': must be one of"},
    {"TagNeverClosed", "</ParameterList>\n</ParameterList>", "</ParameterList>", "name=\"sod\"",
     ""},
    {"GivenTwice", end_given, end_given + "\n" + end_given + "<!-- again -->", "again", ""},
    {"OneEndPeriodic", time_list,
     "<ParameterList name=\"boundaries\"><Parameter name=\"x low\" type=\"string\" "
     "value=\"periodic\"/></ParameterList>" +
         time_list,
     "boundaries", "list 'boundaries', parameter 'x high' = 'wall': must be periodic too"}};

INSTANTIATE_TEST_SUITE_P(Kinds, MistakeInAScene, testing::ValuesIn(mistakes),
                         [](const auto& mistake) { return mistake.param.name; });

TEST(MistakeOnTheCommandLine, IsToldInOneLine) {
  const Folder folder("usage");
  const fs::path out = folder.path / "out";
  const std::string run = "run '" + sod() + "' ";
  expect_refused("run none.xml", out, "none.xml: there is no such file");
  expect_refused("run '" + folder.path.string() + "'", out, "is a folder");
  expect_refused(run + "--set time/ende=1", out, "--set 'time/ende=1'");
  expect_refused(run + "--set time/end=soon", out, "must be a number");
  expect_refused(run + "--set time", out, "list/parameter=value");
  expect_refused(run + "--preset best", out, "one of: paper, fast, balanced, accurate");
  expect_refused(run + "--set scheme/transfer=APIC", out, "needs the shape");
}

TEST(MistakeInAScene, ThatShowsWhenItIsSetUpIsToldWithItsLine) {
  const Folder folder("set_up");
  const fs::path file = folder.path / "a.xml";
  const std::string text = changed("value=\"0.2\"", "value=\"1e300\"");
  std::ofstream(file) << text;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find("1e300")),
                                   '\n');
  for (const std::string command : {"run ", "check ", "verify "})
    expect_told(command + "'" + file.string() + "'", 2,
                file.string() + ":" + std::to_string(line) +
                    ": list 'time', parameter 'end' = 1e+300: takes about");
}

TEST(MistakeOnTheCommandLine, InUsageEndsWithStatus2) {
  for (const char* arguments :
       {"", "rnu a.xml", "run", "run a.xml --no-such-option", "run a.xml --threads 0",
        "run a.xml --threads many", "export somewhere"}) {
    const Ran ran = run_program(arguments);
    EXPECT_EQ(ran.status, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_NE(ran.err, "") << arguments;
    EXPECT_LE(std::count(ran.err.begin(), ran.err.end(), '\n'), 2) << ran.err;
  }
}

TEST(MistakeAboutFolders, IsToldInOneLine) {
  const Folder folder("folders");
  std::ofstream(folder.path / "file") << "in the way";
  // A file where the folder should be cannot be overcome, whoever runs this.
  const std::string path = folder.path.string();
  expect_told("run '" + sod() + "' --out '" + path + "/file/out'", 1, "file");
  expect_told("export '" + path + "' --csv '" + path + "/a.csv'", 1, path);
  expect_told("plot '" + path + "'", 2, path);
  expect_told("plot /no/such/folder", 2, "/no/such/folder");
  expect_told("watch '" + path + "'", 2, path);
  expect_told("watch --once /no/such/folder", 2, "/no/such/folder");
}

TEST(MistakeAboutFolders, ThatAreReadOnlyIsToldInOneLine) {
  const Folder folder("readonly");
  const fs::path out = folder.path / "out";
  fs::create_directory(out);
  // Root writes everywhere, except where a file that cannot be replaced is in the way.
  if (::geteuid() == 0)
    fs::create_directories(out / "input.xml/in the way");
  else
    ::chmod(out.c_str(), 0500);
  expect_told("run '" + sod() + "' --out '" + out.string() + "'", 1, out.string());
  ::chmod(out.c_str(), 0700);
}

}  // namespace
}  // namespace brisance
