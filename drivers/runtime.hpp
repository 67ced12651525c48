#pragma once
#include "core/parameters.hpp"

namespace brisance {

/// The parallel runtime while a command needs it.
class Runtime {
 public:
  /// -1 threads: all there are, or what the environment says.
  explicit Runtime(int threads);
  ~Runtime();
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;
};

/// How many threads the runtime has started.
int running_threads();

/// As many threads as a complete scene has work for: starting the others would cost more than they
/// do.
int paying_threads(const List& scene);

/// The same, or -1 where the environment says how many.
int threads_for(const List& scene);

}  // namespace brisance
