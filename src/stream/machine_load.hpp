#pragma once

namespace facet {

/// Processor time used over a while, in cores.
struct MachineLoad {
  double own_cores = 0;    ///< by this process
  double other_cores = 0;  ///< by all other programs, the host's too where that shows
  int cores = 0;           ///< that this process may use
};

/// Measures the load from its construction on.
class LoadMeter {
 public:
  LoadMeter();
  MachineLoad load() const;

 private:
  double wall_s_, own_s_, busy_s_;
};

}  // namespace facet
