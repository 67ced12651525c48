#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/scripts.hpp"

namespace brisance {

int reproduce_command(const ReproduceRequest& request) {
  std::vector<std::string> words = {"--program", program_file().string(), "--inputs",
                                    (data_folder() / "inputs").string()};
  if (!request.folder.empty()) words.insert(words.end(), {"--out", request.folder});
  if (request.quick) words.push_back("--quick");
  if (request.list) words.push_back("--list");
  if (!request.only.empty()) {
    words.push_back("--only");
    words.insert(words.end(), request.only.begin(), request.only.end());
  }
  return run_script("reproduce.py", words);
}

}  // namespace brisance
