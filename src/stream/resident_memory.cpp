#include "stream/resident_memory.hpp"

#include <fstream>
#include <unistd.h>

namespace facet {

double resident_memory_mb() {
  long pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident_pages;
  return 1e-6 * static_cast<double>(resident_pages) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace facet
