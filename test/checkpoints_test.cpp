// When checkpoints are written, and which of them stay.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "drivers/checkpoint.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::checkpoints_in;
using test::Folder;
using test::run_into;
using test::shortened;

TEST(Checkpoints, KeepOnlyTheNewest) {
  const Folder folder("keep");
  List scene = shortened("sod", 40, 3);
  scene.sublist("checkpoint").set("keep", 3);
  run_into(folder.path, scene);
  EXPECT_EQ(checkpoints_in(folder.path).size(), 3u);
}

TEST(Checkpoints, OfAnEarlierRunArePutAside) {
  const Folder folder("aside");
  const List scene = shortened("sod", 20, 5);
  run_into(folder.path, scene);
  const std::size_t number = checkpoints_in(folder.path).size();
  List plain = scene;
  plain.remove("checkpoint");
  run_into(folder.path, plain);
  EXPECT_FALSE(fs::exists(folder.path / "checkpoints"));
  std::size_t aside = 0;
  for (const auto& entry : fs::directory_iterator(folder.path / "checkpoints.before"))
    aside += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(aside, number);
}

TEST(Checkpoints, ComeAtIntervalsOfSimulatedTime) {
  const Folder folder("by_time");
  List scene = shortened("sod", 40, 0);
  const double end = get<double>(scene.sublist("time"), "end");
  scene.sublist("checkpoint").set("simulated time", end / 4);
  run_into(folder.path, scene);
  const auto checkpoints = checkpoints_in(folder.path);
  ASSERT_EQ(checkpoints.size(), 4u);  // and the one at the end
  const double dt = end / 30;
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(read_checkpoint(checkpoints[k]).head.time, (k + 1) * end / 4, dt);
}

}  // namespace
}  // namespace brisance
