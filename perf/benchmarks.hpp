#pragma once
// The benchmarks by subject. Their names begin with machine/, law/, kernel/, step/, weak/, scene/.
// They count particle-steps, particles or points a second; kernels, and the machine, also GB and
// GFLOP a second.

namespace brisance::perf {

void register_machine();
void register_laws();
void register_kernels();
/// `threads`: of the runtime, for boxes that grow with them.
void register_steps(int threads);
void register_scenes();

}  // namespace brisance::perf
