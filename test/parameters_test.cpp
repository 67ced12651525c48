#include "core/parameters.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <limits>

namespace brisance {
namespace {

using Numbers = std::vector<double>;
using Integers = std::vector<int>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// An initializer list for Teuchos::Array, which lacks one: its {10, 20} are ten times 20.
template <class T>
Teuchos::Array<T> array(std::vector<T> values) {
  return Teuchos::Array<T>(values);
}

List schema() {
  List valid("scene");
  declare(valid, "title", "", anything(), "what the scene shows [-]");
  declare(valid, "geometry", "line", one_of({"line", "plane strain"}), "the symmetry [-]");
  List& grid = declare_list(valid, "grid", "the background cells");
  declare(grid, "origin", Numbers{0, 0}, entries(2), "the lower corner [m]");
  declare_required<Integers>(grid, "cells", positive() && entries(2), "along each axis [-]");
  declare(grid, "levels", Integers{}, between(0, 5), "refinements [-]");
  List& time = declare_list(valid, "time", "how far and how fast");
  declare_required<double>(time, "end", positive(), "when the run stops [s]");
  declare(time, "CFL", 0.5, above(0) && at_most(1), "cells that a wave may cross in a step [-]");
  declare(time, "steps", 1000, at_least(1), "the most there may be [-]");
  declare(time, "log", true, anything(), "whether to print the steps [-]");
  List& viscosity = declare_optional_list(time, "artificial viscosity", "spreads shocks");
  declare(viscosity, "linear", 0.5, at_least_zero(), "its first coefficient [-]");
  declare(viscosity, "factor", 0.5, at_least(0) && below(1), "its second coefficient [-]");
  return valid;
}

List scene() {
  List given("riemann");
  given.sublist("grid").set("cells", array<int>({10, 20}));
  given.sublist("time").set("end", 2.5);
  return given;
}

struct Fault {
  const char* name;
  std::function<void(List&)> edit;
  const char* message;
};

class EveryFault : public testing::TestWithParam<Fault> {};

TEST_P(EveryFault, IsToldInOneLine) {
  List given = scene();
  GetParam().edit(given);
  try {
    check(given, schema());
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), GetParam().message);
  }
}

template <class T>
std::function<void(List&)> in(const char* list, const char* name, T value) {
  return [=](List& given) { (*list ? given.sublist(list) : given).set(name, value); };
}

std::function<void(List&)> without(const char* list, const char* name) {
  return [=](List& given) { given.sublist(list).remove(name); };
}

const Fault faults[] = {
    {"UnknownParameter", in("time", "edn", 1.0),
     "list 'time', parameter 'edn' is unknown; did you mean 'end'?"},
    {"OtherCase", in("time", "cfl", 1.0),
     "list 'time', parameter 'cfl' is unknown; did you mean 'CFL'?"},
    {"UnknownAtTheTop", in("", "titel", std::string("x")),
     "parameter 'titel' is unknown; did you mean 'title'?"},
    {"UnknownList", in("tyme", "end", 1.0), "list 'tyme' is unknown; did you mean 'time'?"},
    {"UnknownOptionalList", [](List& l) { l.sublist("time").sublist("artificial viscosty"); },
     "list 'time/artificial viscosty' is unknown; did you mean 'artificial viscosity'?"},
    {"DeepUnknown",
     [](List& l) { l.sublist("time").sublist("artificial viscosity").set("quadratic", 1.0); },
     "list 'time/artificial viscosity', parameter 'quadratic' is unknown; there is: linear, "
     "factor"},
    {"MissingParameter", without("time", "end"),
     "list 'time', parameter 'end' is missing: it must be a number > 0"},
    {"MissingArray", without("grid", "cells"),
     "list 'grid', parameter 'cells' is missing: it must be 2 integers > 0"},
    {"MissingList", [](List& l) { l.remove("time"); },
     "list 'time', parameter 'end' is missing: it must be a number > 0"},
    {"TextForNumber", in("time", "end", std::string("soon")),
     "list 'time', parameter 'end' = 'soon': must be a number > 0"},
    {"TrueForNumber", in("time", "CFL", true),
     "list 'time', parameter 'CFL' = true: must be a number > 0 and <= 1"},
    {"NumberForInteger", in("time", "steps", 10.0),
     "list 'time', parameter 'steps' = 10: must be an integer >= 1"},
    {"IntegerForBool", in("time", "log", 1),
     "list 'time', parameter 'log' = 1: must be true or false"},
    {"NumberForText", in("", "title", 7.5), "parameter 'title' = 7.5: must be text"},
    {"NumberForArray", in("grid", "cells", 10),
     "list 'grid', parameter 'cells' = 10: must be 2 integers > 0"},
    {"NumbersForIntegers", in("grid", "cells", array<double>({1.5, 2})),
     "list 'grid', parameter 'cells' = {1.5, 2}: must be 2 integers > 0"},
    {"ArrayForNumber", in("time", "end", array<double>({1})),
     "list 'time', parameter 'end' = {1}: must be a number > 0"},
    {"StrangeType", in("time", "end", 1LL), "list 'time', parameter 'end' must be a number > 0"},
    {"ListForParameter", [](List& l) { l.sublist("time").sublist("CFL"); },
     "list 'time/CFL' must be a number > 0 and <= 1"},
    {"ParameterForList", in("", "grid", 1.0),
     "parameter 'grid' = 1: must be a list, not a parameter"},
    {"EndExcluded", in("time", "end", 0.0), "list 'time', parameter 'end' = 0: must be > 0"},
    {"AboveTheEnd", in("time", "CFL", 1.5),
     "list 'time', parameter 'CFL' = 1.5: must be > 0 and <= 1"},
    {"IntegerTooSmall", in("time", "steps", 0), "list 'time', parameter 'steps' = 0: must be >= 1"},
    {"IntegerForNumberTooSmall", in("time", "end", -1),
     "list 'time', parameter 'end' = -1: must be > 0"},
    {"OptionalListObeysToo",
     [](List& l) { l.sublist("time").sublist("artificial viscosity").set("factor", 1.0); },
     "list 'time/artificial viscosity', parameter 'factor' = 1: must be >= 0 and < 1"},
    {"Infinite", in("time", "end", infinity), "list 'time', parameter 'end' = inf: must be finite"},
    {"NotANumber", in("time", "end", not_a_number),
     "list 'time', parameter 'end' = nan: must be finite"},
    {"InfiniteEntry", in("grid", "origin", array<double>({0, -infinity})),
     "list 'grid', parameter 'origin' = {0, -inf}: every entry must be finite"},
    {"TooFewEntries", in("grid", "cells", array<int>({10})),
     "list 'grid', parameter 'cells' = {10}: must have 2 entries"},
    {"TooManyEntries", in("grid", "origin", array<double>({0, 0, 0})),
     "list 'grid', parameter 'origin' = {0, 0, 0}: must have 2 entries"},
    {"BadEntry", in("grid", "cells", array<int>({10, 0})),
     "list 'grid', parameter 'cells' = {10, 0}: every entry must be > 0"},
    {"BadEntryOfClosedInterval", in("grid", "levels", array<int>({6})),
     "list 'grid', parameter 'levels' = {6}: every entry must be >= 0 and <= 5"},
    {"WrongChoice", in("", "geometry", std::string("plane strian")),
     "parameter 'geometry' = 'plane strian': must be one of: line, plane strain; did you mean "
     "'plane strain'?"},
    {"FarFromEveryChoice", in("", "geometry", std::string("torus")),
     "parameter 'geometry' = 'torus': must be one of: line, plane strain"},
    {"LineEndInAValue", in("", "geometry", std::string("a\nb\x1b")),
     "parameter 'geometry' = 'a b ': must be one of: line, plane strain"},
};

INSTANTIATE_TEST_SUITE_P(Parameters, EveryFault, testing::ValuesIn(faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(Parameters, DefaultsAreFilledInInTheOrderOfTheSchema) {
  const List used = check(scene(), schema());
  EXPECT_EQ(names(used), (std::vector<std::string>{"title", "geometry", "grid", "time"}));
  EXPECT_EQ(get<std::string>(used, "geometry"), "line");
  EXPECT_EQ(get<double>(used.sublist("time"), "CFL"), 0.5);
  EXPECT_EQ(get<int>(used.sublist("time"), "steps"), 1000);
  EXPECT_TRUE(get<bool>(used.sublist("time"), "log"));
  EXPECT_EQ(get<Numbers>(used.sublist("grid"), "origin"), (Numbers{0, 0}));
  EXPECT_EQ(get<Integers>(used.sublist("grid"), "cells"), (Integers{10, 20}));
  EXPECT_EQ(used.name(), "riemann");
  EXPECT_TRUE(Teuchos::haveSameValues(check(used, schema()), used));
}

TEST(Parameters, TheCheckedListCarriesNoRulesAndIsIndependentOfTheSchema) {
  List used = check(scene(), schema());
  EXPECT_TRUE(used.sublist("time").getEntry("CFL").validator().is_null());
  EXPECT_TRUE(used.sublist("time").getEntry("CFL").docString().empty());
}

TEST(Parameters, AnIntegerGivenForANumberBecomesOne) {
  List given = scene();
  given.sublist("time").set("end", 3);
  given.sublist("grid").set("origin", array<int>({1, -2}));
  const List used = check(given, schema());
  EXPECT_EQ(get<double>(used.sublist("time"), "end"), 3.0);
  EXPECT_EQ(get<Numbers>(used.sublist("grid"), "origin"), (Numbers{1, -2}));
}

TEST(Parameters, AnOptionalListIsThereOnlyWhenItWasGiven) {
  const char* name = "artificial viscosity";
  List given = scene();
  EXPECT_EQ(find_list(check(given, schema()).sublist("time"), name), nullptr);
  given.sublist("time").sublist(name);
  const List used = check(given, schema());
  ASSERT_NE(find_list(used.sublist("time"), name), nullptr);
  EXPECT_EQ(get<double>(used.sublist("time").sublist(name), "linear"), 0.5);
}

TEST(Parameters, ASchemaThatIsAssignedKeepsRulesAndOptionalLists) {
  List valid("scene"), given("riemann");
  declare_list(valid, "inner", "a whole scene") = schema();
  given.sublist("inner") = scene();
  given.sublist("inner").setName("riemann->inner");
  const List used = check(given, valid);
  EXPECT_FALSE(used.sublist("inner").sublist("time").isParameter("artificial viscosity"));
  given.sublist("inner").sublist("time").set("end", -1.0);
  EXPECT_THROW(check(given, valid), InputError);
}

TEST(Parameters, OneParameterIsReadBeforeTheSchemaIsComplete) {
  List given = scene();
  EXPECT_EQ(peek<std::string>(given, schema(), "geometry"), "line");
  given.set("geometry", "plane strain");
  EXPECT_EQ(peek<std::string>(given, schema(), "geometry"), "plane strain");
  given.set("geometry", "torus");
  EXPECT_THROW(peek<std::string>(given, schema(), "geometry"), InputError);
}

TEST(Parameters, ReadingWhatIsNotThereNamesIt) {
  const List used = check(scene(), schema());
  const auto message = [](const auto& f) {
    try {
      f();
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([&] { get<double>(used.sublist("time"), "start"); }),
            "list 'time', parameter 'start' is missing");
  EXPECT_EQ(message([&] { get<double>(used.sublist("time"), "steps"); }),
            "list 'time', parameter 'steps' = 1000: must be a number");
  EXPECT_EQ(message([&] { refuse(used.sublist("time"), "end", "must be after the start"); }),
            "list 'time', parameter 'end' = 2.5: must be after the start");
  EXPECT_EQ(message([&] { refuse(used.sublist("time"), "", "is too short"); }),
            "list 'time' is too short");
}

TEST(Parameters, ADefaultThatBreaksItsRuleAndADocumentationWithoutUnitAreRefused) {
  List valid;
  EXPECT_THROW(declare(valid, "gamma", 0.5, above(1), "ratio [-]"), InputError);
  EXPECT_THROW(declare(valid, "gamma", 1.5, above(1), "ratio"), std::logic_error);
  EXPECT_THROW(declare(valid, "law", "gas", one_of({"solid"}), "its kind [-]"), InputError);
}

TEST(Parameters, TeuchosItselfObeysTheRulesOfASchema) {
  List valid = schema();
  EXPECT_THROW(valid.sublist("time").set("CFL", 2.0), InputError);
  EXPECT_NO_THROW(valid.sublist("time").set("CFL", 1.0));
}

TEST(Parameters, TheSchemaTellsWhatItKnows) {
  const List valid = schema();
  const Described end = described(valid.sublist("time"), "end");
  EXPECT_EQ(end.type + "|" + end.rule + "|" + end.doc + "|" + end.unit,
            "double|a number > 0|when the run stops|[s]");
  EXPECT_TRUE(end.required);
  const Described cells = described(valid.sublist("grid"), "origin");
  EXPECT_EQ(cells.type + "|" + cells.value + "|" + cells.rule, "Array(double)|{0, 0}|2 numbers");
  EXPECT_TRUE(described(valid.sublist("time"), "artificial viscosity").optional);
  EXPECT_FALSE(described(valid, "time").optional);
}

TEST(Parameters, BothRulesHoldWhenJoined) {
  EXPECT_EQ(wording<double>(at_least(0) && above(0)), "a number > 0");
  EXPECT_EQ(wording<double>(at_most(1) && below(1)), "a number < 1");
  EXPECT_EQ(wording<Integers>(between(-1, 1) && entries(1)), "1 integer >= -1 and <= 1");
  EXPECT_EQ(wording<std::string>(one_of({"a", "b"})), "one of: a, b");
}

TEST(Parameters, NamesMayBeManyOutOfSome) {
  using Names = std::vector<std::string>;
  List valid, given;
  declare(valid, "columns", Names{}, one_of({"mass", "pressure"}), "what is written [-]");
  EXPECT_EQ(get<Names>(check(given, valid), "columns"), Names{});
  given.set("columns", array<std::string>({"pressure", "mass"}));
  EXPECT_EQ(get<Names>(check(given, valid), "columns"), (Names{"pressure", "mass"}));
  const Described told = described(valid, "columns");
  EXPECT_EQ(told.type + "|" + told.value + "|" + told.rule,
            "Array(string)|{}|any of: mass, pressure");
  EXPECT_EQ(broken(one_of({"mass", "pressure"}), Names{"mass", "presure"}),
            "every entry must be one of: mass, pressure; did you mean 'pressure'?");
}

TEST(Parameters, AMessageIsClippedBetweenCharacters) {
  EXPECT_EQ(one_line("abc\tdef", 20), "abc def");
  EXPECT_EQ(one_line("aaaa\xC3\xA9zzzz", 8), "aaaa...");
}

}  // namespace
}  // namespace brisance
