// Whatever stands in a file: it is a scene, or it is told in one line why it is none.
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cstdlib>

#include "drivers/input.hpp"
#include "drivers/scene.hpp"

namespace {

void expect(bool right, const std::string& what) {
  if (right) return;
  std::fprintf(stderr, "fuzz: %s\n", what.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace brisance;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const Document document = parse_input(text, "a.xml");
    try {
      const List scene = complete_scene(*document.list);
      const std::string written = input_text(scene, "complete");
      const List again = complete_scene(*parse_input(written, "b.xml").list);
      expect(input_text(again, "complete") == written, "a complete scene changes when it is read");
    } catch (const InputError& error) {
      throw document.locate(error);
    }
  } catch (const InputError& error) {
    const std::string told = error.what();
    expect(told.find('\n') == told.npos, "more than one line: " + told);
    expect(told.rfind("a.xml", 0) == 0, "no place in the file: " + told);
  }
  return 0;
}
