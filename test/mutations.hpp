#pragma once
// Scenes broken on purpose: mutations of a good text, each of which no reader of it may accept.
#include <string>
#include <vector>

namespace brisance::test {

struct Broken {
  std::string name;  ///< of the mutation
  std::string text;
  bool set_up = false;  ///< shows only when the scene is set up: a matter of steps or memory
};

/// Mutations of the text of a scene, the places of each chosen at random; same seed, same texts.
std::vector<Broken> mutations(const std::string& scene, unsigned seed);

/// Those of them that break bytes, encoding or what is around: of a text whose first tag begins at
/// `first` and whose last one at `last`.
std::vector<Broken> mutations_of_bytes(const std::string& scene, std::size_t first,
                                       std::size_t last, unsigned seed);

}  // namespace brisance::test
