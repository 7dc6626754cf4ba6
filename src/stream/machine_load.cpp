#include "stream/machine_load.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sched.h>
#include <string>
#include <unistd.h>

namespace facet {
namespace {

double wall_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double own_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// All processors together, from the first line of /proc/stat: user nice system idle iowait irq softirq
/// steal.
double busy_s() {
  std::ifstream file("/proc/stat");
  std::string name;
  file >> name;
  double busy = 0, value = 0;
  for (int column = 0; column < 8 && file >> value; ++column)
    if (column != 3 && column != 4) busy += value;
  return busy / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

}  // namespace

LoadMeter::LoadMeter() : wall_s_(wall_s()), own_s_(own_s()), busy_s_(busy_s()) {}

MachineLoad LoadMeter::load() const {
  const double wall = std::max(wall_s() - wall_s_, 1e-9), own = own_s() - own_s_;
  cpu_set_t cores;
  const int count = sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 0;
  return {own / wall, std::max(busy_s() - busy_s_ - own, 0.0) / wall, count};
}

}  // namespace facet
