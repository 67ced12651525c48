#pragma once
// Scenes as files: the strict front of a Teuchos parameter list in XML. Nothing is guessed: every
// number is read whole, nothing is given twice, and every complaint names file and line.
#include <map>
#include <memory>
#include <string>

#include "core/parameters.hpp"

namespace brisance {

/// A scene as it was given, and where each part of it was given.
struct Document {
  /// A file, or the option of the command line that replaced the value; then line is 0.
  struct Place {
    std::string file;
    int line = 0;
  };

  explicit Document(std::string file);
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();

  /// The same error with the place of its parameter, or of the nearest list around it.
  InputError locate(const InputError& error) const;

  std::unique_ptr<List> list;
  std::map<std::string, Place> places;  // by path, "time/end"; the top is ""
};

/// Reads an XML file of at most 16 MB. Throws InputError with file and line.
Document read_input(const std::string& path);

/// The same for a text; `file` is the name in messages.
Document parse_input(const std::string& text, const std::string& file);

/// Carries out --set 'list/parameter=value'. The type is the one in `valid`, the schema of the
/// scene, else the one that was given. Throws InputError that names the option.
void apply_override(Document& document, const std::string& assignment, const List& valid);

/// A list as XML that parse_input() reads back to the same values. The comment stands at its head.
std::string input_text(const List& list, const std::string& comment);

/// Writes input_text() to a file, whole or not at all. Throws std::runtime_error when it cannot.
void write_input(const List& list, const std::string& path, const std::string& comment);

}  // namespace brisance
