// What a run leaves behind that ends before its time.
#include "drivers/recording.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

/// How often a text stands in a file.
int occurrences(const fs::path& file, const std::string& text) {
  const std::string content = read_file(file);
  int count = 0;
  for (auto at = content.find(text); at != std::string::npos; at = content.find(text, at + 1))
    ++count;
  return count;
}

// Outputs that follow each other within milliseconds do not write the tables each time.
TEST(Recording, ThatEndsByAnErrorLeavesWholeTables) {
  const test::Folder folder("recording");
  const List scene = test::shortened("bomb_cased", 24, 0);
  constexpr int outputs = 5;
  const auto run = [&] {
    const auto simulation = make_simulation(scene, nullptr);
    const Ledger ledger(simulation->balance());
    TimeKeeper keeper;
    Recording recording(scene, *simulation, ledger, nullptr, keeper);
    recording.open(folder.path, scene);
    for (int k = 0; k < outputs; ++k) {
      recording.follow();
      recording.output_if_seen();
      simulation->advance(1);
    }
    throw std::runtime_error("the end");
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_EQ(occurrences(folder.path / "particles.pvd", "<DataSet"), outputs);
  EXPECT_EQ(occurrences(folder.path / "grid.pvd", "<DataSet"), outputs);
  EXPECT_EQ(occurrences(folder.path / "history.csv", "\n"), 1 + outputs);
  EXPECT_EQ(occurrences(folder.path / "gauges.csv", "\n"), 1 + outputs);
  EXPECT_GE(occurrences(folder.path / "fragments.csv", "\n"), 1 + outputs);
}

}  // namespace
}  // namespace brisance
