#include "drivers/input_value.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <charconv>
#include <cmath>

#include "drivers/input_scan.hpp"

namespace brisance {
namespace {

// Each read() returns what is wrong with the text, empty when nothing is.

std::string read(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) {
    return "must be a number";
  }
  if (error == std::errc::result_out_of_range) return "must fit into a double";
  return std::isfinite(value) ? "" : "must be finite";
}

std::string read(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) {
    return "must be an integer";
  }
  return error == std::errc{} ? "" : "must fit into 32 bits";
}

std::string read(std::string_view text, bool& value) {
  value = text == "true";
  return value || text == "false" ? "" : "must be true or false";
}

std::string read(std::string_view text, std::string& value) {
  if (first_bad_byte(text) != text.npos || text.find_first_of("\t\r\n") != text.npos) {
    return "must be one line of text (UTF-8)";
  }
  value = text;
  return "";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == text.npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

template <class T>
std::string read(std::string_view text, Teuchos::Array<T>& values) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') {
    return "must be entries in braces, such as {1, 2}";
  }
  text = text.substr(1, text.size() - 2);
  if (trimmed(text).empty()) return "";
  for (std::size_t comma = 0; comma != text.npos; text.remove_prefix(comma + 1)) {
    comma = text.find(',');
    T value{};
    const std::string wrong = read(trimmed(text.substr(0, comma)), value);
    if (!wrong.empty()) return "every entry " + wrong;
    values.push_back(value);
    if (comma == text.npos) break;
  }
  return "";
}

template <class T>
std::string put(List& list, const std::string& name, const std::string& text) {
  T value{};
  std::string wrong = read(text, value);
  if (wrong.empty()) list.set(name, value);
  return wrong;
}

}  // namespace

const std::vector<std::string>& value_types() {
  static const std::vector<std::string> types = {
      "double", "int", "bool", "string", "Array(double)", "Array(int)", "Array(string)"};
  return types;
}

std::string put_text(List& list, const std::string& name, const std::string& type,
                     const std::string& text) {
  if (type == "double") return put<double>(list, name, text);
  if (type == "int") return put<int>(list, name, text);
  if (type == "bool") return put<bool>(list, name, text);
  if (type == "string") return put<std::string>(list, name, text);
  if (type == "Array(double)") return put<Teuchos::Array<double>>(list, name, text);
  if (type == "Array(int)") return put<Teuchos::Array<int>>(list, name, text);
  if (type == "Array(string)") return put<Teuchos::Array<std::string>>(list, name, text);
  return "has the unknown type '" + type + "'" + did_you_mean(type, value_types());
}

}  // namespace brisance
