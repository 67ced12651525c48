#pragma once
// What the value of a parameter must obey, and how that is told to people. Knows no list and no
// file format. T is one of double, int, bool, std::string and the vectors of double, int and
// std::string.
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace brisance {

/// Something is wrong with an input. what() is one line:
///   inputs/sod.xml:14: list 'materials/air', parameter 'gamma' = 0.9: must be > 1
/// Whatever is not known is left out: file and line are filled in by Document::locate.
struct InputError : std::runtime_error {
  InputError(std::string in_list, std::string of_parameter, std::string with_value,
             std::string broken_rule, std::string in_file = {}, int on_line = 0);

  std::string list;       // path from the top, "materials/air"; empty: the top itself
  std::string parameter;  // empty: the list as a whole
  std::string value;      // as text; empty: none
  std::string rule;       // what is wrong or must hold: "is unknown", "must be > 1"
  std::string file;
  int line;
};

/// Numbers (every entry of an array) lie between two ends and are finite, texts are among the
/// choices, an array has so many entries.
struct Rule {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;
  bool high_excluded = false;
  std::vector<std::string> choices;  // empty: any text
  int entries = -1;                  // -1: any number of them
};

Rule anything();
Rule above(double low);
Rule at_least(double low);
Rule below(double high);
Rule at_most(double high);
Rule positive();
Rule at_least_zero();
Rule between(double low, double high);  // both ends belong to it
Rule one_of(std::vector<std::string> choices);
Rule entries(int count);
/// Both hold, as in `above(0) && at_most(1)` or `positive() && entries(2)`.
Rule operator&&(const Rule& a, const Rule& b);

/// What is wrong with a value, "must be > 1"; empty when the rule holds.
template <class T>
std::string broken(const Rule& rule, const T& value);

/// The rule in words for a T: "a number > 1", "2 integers", "one of: linear, cubic".
template <class T>
std::string wording(const Rule& rule);

/// The name of the type in the XML: "double", "Array(int)".
template <class T>
std::string type_name();

/// Text that reads back to the same value: 0.1, true, {1, 2}.
template <class T>
std::string text_of(const T& value);

/// "; did you mean 'gamma'?", or the names there are when none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

/// Text fit for one line of a message: control characters become blanks, what exceeds `most` is cut
/// off.
std::string one_line(std::string text, std::size_t most = 80);

}  // namespace brisance
