// The page about the checkpoint file is true: what it tells readers to do works.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cstdlib>

#include "drivers/checkpoint_file.hpp"
#include "drivers/files.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const char* const page = BRISANCE_SOURCE_DIR "/drivers/CHECKPOINT.md";

/// The program that stands on the page.
std::string program_of(const std::string& text) {
  const std::string begin = "```python\n";
  const std::size_t at = text.find(begin) + begin.size();
  return text.substr(at, text.find("```", at) - at);
}

class CheckpointPage : public testing::Test {
 protected:
  test::Folder folder{"page"};
  fs::path newest;
  void SetUp() override {
    test::run_into(folder.path / "run", test::shortened("bomb_quarter", 6, 3));
    newest = test::checkpoints_in(folder.path / "run").back();
  }
};

TEST_F(CheckpointPage, HasAProgramThatReadsOne) {
  const fs::path script = folder.path / "read.py", told = folder.path / "told.txt";
  write_file(script, program_of(read_file(page)));
  const char* python = std::getenv("BRISANCE_PYTHON");
  const std::string command = std::string(python ? python : "/usr/bin/python3") + " '" +
                              script.string() + "' '" + newest.string() + "' > '" + told.string() +
                              "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << read_file(told);
  const CheckpointHead head = read_checkpoint(newest).head;
  const std::string text = read_file(told);
  EXPECT_THAT(text, HasSubstr("format 5\n"));
  EXPECT_THAT(text, HasSubstr("written by " + head.program + " at step " +
                              std::to_string(head.step) + " time "));
  EXPECT_THAT(text, HasSubstr("<ParameterList name=\"bomb_quarter\">\n"));
  for (const char* name : {"tnt", "steel", "air", "concrete"})
    EXPECT_THAT(text, HasSubstr("material " + std::string(name) + " has "));
  EXPECT_THAT(text, HasSubstr(" particles, position 2 "));
}

/// The last part of every path stands on the page, or its first part with "...".
TEST_F(CheckpointPage, NamesEveryPart) {
  const std::string text = read_file(page);
  Checkpoint checkpoint = read_checkpoint(newest);
  for (const auto& [path, entry] : checkpoint.archive.entries()) {
    const std::string part = path.substr(0, path.find('/')),
                      last = path.substr(path.rfind('/') + 1);
    const bool named = text.find(part + "/...`") != text.npos ||
                       text.find('`' + part + '`') != text.npos ||
                       text.find(last + '`') != text.npos || path.rfind("state/outflow/", 0) == 0;
    EXPECT_TRUE(named) << path;
  }
}

}  // namespace
}  // namespace brisance
