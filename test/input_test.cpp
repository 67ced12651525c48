#include "drivers/input.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace brisance {
namespace {

const std::string scene = R"xml(
<!-- a tube -->
<ParameterList name="riemann">
  <Parameter name="title" type="string" value=""/>
  <ParameterList name="grid">
    <Parameter name="cells" type="Array(int)" value="{10, 20}"/>
  </ParameterList>

  <ParameterList name="time">
    <Parameter name="end" type="double" value="2.5"/>
    <Parameter name="steps" type="int" value="-7"/>
  </ParameterList>
</ParameterList>
)xml";

template <class F>
std::string message(const F& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Input, LaterErrorsGetTheLineOfTheParameterOrOfTheListAroundIt) {
  const Document document = parse_input(scene, "a.xml");
  const auto located = [&](const char* list, const char* parameter) {
    return std::string(document.locate({list, parameter, "", "is wrong"}).what());
  };
  EXPECT_EQ(located("time", "end"), "a.xml:10: list 'time', parameter 'end' is wrong");
  EXPECT_EQ(located("time", "CFL"), "a.xml:9: list 'time', parameter 'CFL' is wrong");
  EXPECT_EQ(located("time/none", "x"), "a.xml:9: list 'time/none', parameter 'x' is wrong");
  EXPECT_EQ(located("materials", ""), "a.xml:3: list 'materials' is wrong");
  EXPECT_EQ(located("", "title"), "a.xml:4: parameter 'title' is wrong");
}

class InputFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string refused(const std::string& path) const {
    const std::string text = message([&] { read_input(path); });
    return text.substr(0, path.size() + 2) == path + ": " ? text.substr(path.size() + 2) : text;
  }

  const std::string folder = testing::TempDir() + "brisance_input";
};

TEST_F(InputFile, MustBeARegularFile) {
  EXPECT_EQ(refused(folder + "/none.xml"), "there is no such file");
  EXPECT_EQ(refused(folder), "is a folder, not a scene");
  ASSERT_EQ(mkfifo((folder + "/pipe").c_str(), 0600), 0);
  EXPECT_EQ(refused(folder + "/pipe"), "is not a regular file");
  EXPECT_EQ(refused("/dev/zero"), "is not a regular file");
  EXPECT_EQ(refused(""), "there is no such file");
}

TEST_F(InputFile, MustNotBeLargerThan16MB) {
  const std::string path = folder + "/large.xml";
  std::ofstream(path) << scene;
  std::filesystem::resize_file(path, (16 << 20) + 1);
  EXPECT_EQ(refused(path), "is larger than 16 MB");
}

TEST_F(InputFile, WrittenAndReadAgainHasTheSameValuesToTheLastBit) {
  const std::string path = folder + "/used.xml";
  List list("scene");
  const std::vector<double> numbers = {1.0 / 3, 1e-310, -0.0, 1.7976931348623157e308, 5e-324, 100};
  list.set("numbers", Teuchos::Array<double>(numbers));
  list.set("nothing", Teuchos::Array<double>());
  list.set("third", 1.0 / 3).set("least", std::numeric_limits<int>::min()).set("yes", true);
  list.sublist("a \"quoted\" & 'named' list").set("text", std::string(" <a> & \"b\" 'c' "));
  write_input(list, path, "completed -- with -- defaults");
  const Document document = read_input(path);
  EXPECT_TRUE(Teuchos::haveSameValues(*document.list, list));
  const auto read = get<std::vector<double>>(*document.list, "numbers");
  EXPECT_TRUE(std::signbit(read[2]));
  EXPECT_EQ(read, numbers);
  EXPECT_EQ(input_text(*document.list, ""), input_text(list, ""));
}

TEST_F(InputFile, WhatCannotBeReadBackIsNotWritten) {
  List list("scene");
  list.set("end", std::numeric_limits<double>::infinity());
  EXPECT_EQ(message([&] { input_text(list, ""); }), "parameter 'end' = inf: must be finite");
  EXPECT_THROW(write_input(List("scene"), folder, ""), std::runtime_error);
}

// ---- --set ----

List schema() {
  List valid("scene");
  declare(valid, "title", "", anything(), "what the scene shows [-]");
  List& time = declare_list(valid, "time", "how far and how fast");
  declare_required<double>(time, "end", positive(), "when the run stops [s]");
  declare(time, "CFL", 0.5, above(0) && at_most(1), "cells that a wave may cross in a step [-]");
  List& viscosity = declare_optional_list(time, "artificial viscosity", "spreads shocks");
  declare(viscosity, "form", "linear", one_of({"linear", "quadratic"}), "its dependence [-]");
  return valid;
}

TEST(Override, ReplacesOrAddsAValueWithItsType) {
  Document document = parse_input(scene, "a.xml");
  apply_override(document, "time/end=1e-3", schema());
  apply_override(document, "time/CFL=1", schema());
  apply_override(document, "grid/cells={5,6}", schema());
  apply_override(document, "title=a=b", schema());
  apply_override(document, "time/artificial viscosity/form=quadratic", schema());
  const List& time = document.list->sublist("time");
  EXPECT_EQ(get<double>(time, "end"), 1e-3);
  EXPECT_EQ(get<double>(time, "CFL"), 1.0);
  EXPECT_EQ(get<std::vector<int>>(document.list->sublist("grid"), "cells"),
            (std::vector<int>{5, 6}));
  EXPECT_EQ(get<std::string>(*document.list, "title"), "a=b");
  EXPECT_EQ(get<std::string>(time.sublist("artificial viscosity"), "form"), "quadratic");
  EXPECT_EQ(path_of(time.sublist("artificial viscosity")), "time/artificial viscosity");
  EXPECT_STREQ(document.locate({"time", "end", "-1", "must be > 0"}).what(),
               "--set 'time/end=1e-3': list 'time', parameter 'end' = -1: must be > 0");
}

TEST(Override, ErrorsNameTheOptionAndLeaveTheSceneAlone) {
  Document document = parse_input(scene, "a.xml");
  const auto refused = [&](const std::string& assignment) {
    const std::string text = message([&] { apply_override(document, assignment, schema()); });
    const std::string option = "--set '" + assignment + "': ";
    return text.substr(0, option.size()) == option ? text.substr(option.size()) : text;
  };
  EXPECT_EQ(refused("time/edn=1"), "list 'time', parameter 'edn' is unknown; did you mean 'end'?");
  EXPECT_EQ(refused("tme/end=1"), "list 'tme' is unknown; did you mean 'time'?");
  EXPECT_EQ(refused("time/end"), "must be list/parameter=value");
  EXPECT_EQ(refused("time=1"), "list 'time' is a list: name a parameter of it");
  EXPECT_EQ(refused("title/x=1"), "parameter 'title' = '': must be a list, not a parameter");
  EXPECT_EQ(refused("time/end=soon"), "list 'time', parameter 'end' = 'soon': must be a number");
  EXPECT_EQ(refused("time/steps=1.5"),
            "list 'time', parameter 'steps' = '1.5': must be an integer");
  EXPECT_EQ(refused("grid/cells=1"),
            "list 'grid', parameter 'cells' = '1': must be entries in braces, such as {1, 2}");
  EXPECT_EQ(refused("title=a\nb"),
            "--set 'title=a b': parameter 'title' = 'a b': must be one line "
            "of text (UTF-8)");
  EXPECT_NE(refused("=1"), "no error");
  EXPECT_NE(refused("//=1"), "no error");
  EXPECT_TRUE(Teuchos::haveSameValues(*document.list, *parse_input(scene, "a.xml").list));
}

}  // namespace
}  // namespace brisance
