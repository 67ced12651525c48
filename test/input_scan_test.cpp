// Texts of scenes, good and bad, through parse_input().
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <random>

#include "drivers/input.hpp"

namespace brisance {
namespace {

const std::string good = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<!-- a tube; run it with a - b -->
<ParameterList name="riemann">
  <Parameter name="title" type="string" value="a &lt; b &amp; c"/>
  <ParameterList name="grid">  <!-- cells -->
    <Parameter name="cells" type="Array(int)" value="{10, 20}"/>
    <Parameter name='origin' type='Array(double)' value='{-1e-3,.5}'></Parameter>
  </ParameterList>
  <ParameterList name="time">
    <Parameter name="end"
               type="double" value="2.5"/>
    <Parameter name="steps" type="int" value="-7"/>
    <Parameter name="log" type="bool" value="false"/>
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

struct Fault {
  const char* name;
  std::string text;
  const char* message;
};

class EveryBadText : public testing::TestWithParam<Fault> {};

TEST_P(EveryBadText, IsToldInOneLine) {
  EXPECT_EQ(message([&] { parse_input(GetParam().text, "a.xml"); }), GetParam().message);
}

// The parameter on line 2 of a scene.
std::string with(const std::string& parameter) {
  return "<ParameterList name='s'>\n" + parameter + "\n</ParameterList>\n";
}

std::string value(const std::string& type, const std::string& text) {
  return with("<Parameter name='p' type='" + type + "' value='" + text + "'/>");
}

std::string nested(int levels) {
  std::string text;
  for (int i = 0; i < levels; ++i) text += "<ParameterList name='s'>\n";
  for (int i = 0; i < levels; ++i) text += "</ParameterList>\n";
  return text;
}

std::string attributes(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += " a" + std::to_string(i) + "=''";
  return text;
}

const Fault faults[] = {
    // numbers that Teuchos alone would accept
    {"Suffix", value("double", "1e-3s"), "a.xml:2: parameter 'p' = '1e-3s': must be a number"},
    {"Word", value("double", "abc"), "a.xml:2: parameter 'p' = 'abc': must be a number"},
    {"DecimalComma", value("double", "0,1"), "a.xml:2: parameter 'p' = '0,1': must be a number"},
    {"NotANumber", value("double", "nan"), "a.xml:2: parameter 'p' = 'nan': must be finite"},
    {"Infinity", value("double", "-inf"), "a.xml:2: parameter 'p' = '-inf': must be finite"},
    {"TooLarge", value("double", "1e999"),
     "a.xml:2: parameter 'p' = '1e999': must fit into a double"},
    {"EmptyNumber", value("double", ""), "a.xml:2: parameter 'p' = '': must be a number"},
    {"BlankNumber", value("double", " "), "a.xml:2: parameter 'p' = ' ': must be a number"},
    {"Hexadecimal", value("double", "0x10"), "a.xml:2: parameter 'p' = '0x10': must be a number"},
    {"TwoNumbers", value("double", "1 2"), "a.xml:2: parameter 'p' = '1 2': must be a number"},
    {"Fraction", value("int", "10.7"), "a.xml:2: parameter 'p' = '10.7': must be an integer"},
    {"HexadecimalInteger", value("int", "0x10"),
     "a.xml:2: parameter 'p' = '0x10': must be an integer"},
    {"HugeInteger", value("int", "99999999999"),
     "a.xml:2: parameter 'p' = '99999999999': must fit into 32 bits"},
    {"Yes", value("bool", "yes"), "a.xml:2: parameter 'p' = 'yes': must be true or false"},
    {"One", value("bool", "1"), "a.xml:2: parameter 'p' = '1': must be true or false"},
    {"WordInArray", value("Array(double)", "{0,abc}"),
     "a.xml:2: parameter 'p' = '{0,abc}': every entry must be a number"},
    {"FractionInArray", value("Array(int)", "{1, 2.5}"),
     "a.xml:2: parameter 'p' = '{1, 2.5}': every entry must be an integer"},
    {"LastComma", value("Array(int)", "{1,}"),
     "a.xml:2: parameter 'p' = '{1,}': every entry must be an integer"},
    {"NoBraces", value("Array(int)", "1,2"),
     "a.xml:2: parameter 'p' = '1,2': must be entries in braces, such as {1, 2}"},
    {"UnknownType", value("dubble", "1"),
     "a.xml:2: parameter 'p' = '1': has the unknown type 'dubble'; did you mean 'double'?"},
    // tags and attributes
    {"NoName", with("<Parameter type='int' value='1'/>"),
     "a.xml:2: Parameter needs the attribute 'name'"},
    {"NoType", with("<Parameter name='p' value='1'/>"),
     "a.xml:2: parameter 'p' needs the attribute 'type'"},
    {"NoValue", with("<Parameter name='p' type='int'/>"),
     "a.xml:2: parameter 'p' needs the attribute 'value'"},
    {"ListWithoutName", with("<ParameterList/>"),
     "a.xml:2: ParameterList needs the attribute 'name'"},
    {"UnknownAttribute", with("<Parameter name='p' tpye='int' value='1'/>"),
     "a.xml:2: parameter 'p' has the unknown attribute 'tpye'; did you mean 'type'?"},
    {"AttributeTwice", with("<Parameter name='p' name='q'/>"),
     "a.xml:2: attribute 'name' is given twice in one tag"},
    {"ManyAttributes", "<Parameter" + attributes(100000) + "/>",
     "a.xml:1: a tag has too many attributes"},
    {"BadName", with("<ParameterList name='a/b'/>"),
     "a.xml:2: 'a/b' is no name: 1 to 100 bytes, none of / = < >, no blank at the ends"},
    {"UnknownTag", with("<Paramter name='p'/>"),
     "a.xml:2: tag 'Paramter' is unknown; did you mean 'Parameter'?"},
    {"GivenTwice",
     with("<Parameter name='p' type='int' value='1'/>\n"
          "<Parameter name='p' type='int' value='2'/>"),
     "a.xml:3: parameter 'p' is given twice, first on line 2"},
    {"ListGivenTwice",
     with("<ParameterList name='l'>\n<ParameterList name='m'/>\n"
          "<ParameterList name='m'/></ParameterList>"),
     "a.xml:4: list 'l/m' is given twice, first on line 3"},
    {"ParameterWithin",
     with("<Parameter name='p' type='int' value='1'>\n<ParameterList name='q'/>"),
     "a.xml:3: a Parameter must not contain tags"},
    {"MissingQuote", with("<Parameter name='p type='int' value='1'/>"),
     "a.xml:2: tag 'Parameter' is broken: there must be an attribute or '>'"},
    {"OpenQuote", with("<Parameter name='p' type='int' value='1/>\n<Parameter name='q'/>"),
     "a.xml:2: the value of attribute 'value' contains '<': is its closing quote missing?"},
    {"NoQuotes", with("<Parameter name=p/>"),
     "a.xml:2: attribute 'name' must be followed by = and a value in quotes"},
    {"NotClosed", "<ParameterList name='s'>\n<ParameterList name='t'>\n</ParameterList>\n",
     "a.xml:1: tag 'ParameterList' is never closed"},
    {"ClosedByAnother", with("<Parameter name='p' type='int' value='1'>"),
     "a.xml:3: </ParameterList> cannot close the Parameter of line 2"},
    {"ClosesNothing", "\n</ParameterList>", "a.xml:2: </ParameterList> closes nothing"},
    {"CutOff", "<ParameterList name='s'>\n<Parameter name=",
     "a.xml:2: attribute 'name' must be followed by = and a value in quotes"},
    {"OptionInAComment", with("<!-- run it with\n --set 'time/end=1' -->"),
     "a.xml:2: '--' within a comment is no XML"},
    {"OpenComment", with("<!-- never ends"), "a.xml:2: the comment is never closed"},
    // texts as a whole
    {"Empty", "", "a.xml: is empty: there must be a <ParameterList>"},
    {"OnlyAComment", "<!-- nothing -->\n", "a.xml: is empty: there must be a <ParameterList>"},
    {"TwoRoots", nested(1) + nested(1), "a.xml:3: there must be one outermost list only"},
    {"TextAfterTheRoot", nested(1) + "end", "a.xml:3: there is text outside of a tag: 'end'"},
    {"TextBetweenTags", with("2.5"), "a.xml:2: there is text outside of a tag: '2.5 '"},
    {"ParameterAsRoot", "<Parameter name='p' type='int' value='1'/>",
     "a.xml:1: the outermost tag must be a ParameterList"},
    {"TooDeep", nested(65), "a.xml:65: lists are nested more than 64 deep"},
    {"FarTooDeep", nested(100000), "a.xml:65: lists are nested more than 64 deep"},
    {"DocumentType", "<!DOCTYPE s [<!ENTITY a 'b'>]>\n" + nested(1),
     "a.xml:1: document types, entities, CDATA and processing instructions are not allowed"},
    {"Entity", value("string", "&bomb;"),
     "a.xml:2: '&' must begin one of &lt; &gt; &amp; &quot; &apos;"},
    {"NullByte", with(std::string("\0", 1)), "a.xml:2: byte 0 is no text (UTF-8)"},
    {"Latin1", value("string", "caf\xE9"), "a.xml:2: byte 233 is no text (UTF-8)"},
    {"Utf16", "\xFF\xFE<", "a.xml:1: byte 255 is no text (UTF-8)"},
    {"BrokenDeclaration", "<?xml version='1.0' <\n?>" + nested(1),
     "a.xml:1: the XML declaration is broken"},
    {"OtherEncoding", "<?xml version='1.0' encoding='ISO-8859-1'?>\n" + nested(1),
     "a.xml:1: the encoding must be UTF-8"},
};

INSTANTIATE_TEST_SUITE_P(InputText, EveryBadText, testing::ValuesIn(faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(InputText, AGoodTextIsReadAsItStands) {
  const Document document = parse_input(good, "a.xml");
  const List& top = *document.list;
  EXPECT_EQ(top.name(), "riemann");
  EXPECT_EQ(get<std::string>(top, "title"), "a < b & c");
  EXPECT_EQ(get<std::vector<int>>(top.sublist("grid"), "cells"), (std::vector<int>{10, 20}));
  EXPECT_EQ(get<std::vector<double>>(top.sublist("grid"), "origin"),
            (std::vector<double>{-1e-3, .5}));
  EXPECT_EQ(get<int>(top.sublist("time"), "steps"), -7);
  EXPECT_FALSE(get<bool>(top.sublist("time"), "log"));
  EXPECT_EQ(path_of(top.sublist("time")), "time");
}

TEST(InputText, TeuchosReadsTheSameFromTheSameText) {
  const auto theirs = Teuchos::getParametersFromXmlString(good);
  EXPECT_TRUE(Teuchos::haveSameValues(*parse_input(good, "a.xml").list, *theirs, true));
}

TEST(InputText, AByteOrderMarkAndCarriageReturnsAreHarmless) {
  std::string text = "\xEF\xBB\xBF" + good;
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2)
    text.insert(at, 1, '\r');
  EXPECT_TRUE(
      Teuchos::haveSameValues(*parse_input(text, "a.xml").list, *parse_input(good, "a.xml").list));
}

TEST(InputText, SixtyFourLevelsAreAllowed) { EXPECT_NO_THROW(parse_input(nested(64), "a.xml")); }

// Whatever the bytes, a text is read or refused, and what was read can be written and read again.
TEST(InputText, AnyMutationOfAGoodTextIsReadOrRefused) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t end) { return std::size_t(random()) % end; };
  const std::string bits = "<>\"'/=&!-? {},.e0\n\0\xC3";
  for (int i = 0; i < 5000; ++i) {
    std::string text = good;
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
      const std::size_t at = below(text.size()), length = below(20);
      switch (below(4)) {
        case 0:
          text[at] = bits[below(bits.size())];
          break;
        case 1:
          text.insert(at, 1, char(below(256)));
          break;
        case 2:
          text.erase(at, length);
          break;
        default:
          text.insert(below(text.size()), text.substr(at, length));
      }
      if (text.empty()) text = " ";
    }
    try {
      const Document document = parse_input(text, "a.xml");
      const std::string again = input_text(*document.list, "");
      EXPECT_EQ(input_text(*parse_input(again, "b.xml").list, ""), again);
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace brisance
