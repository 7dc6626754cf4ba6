#pragma once

namespace facet {

/// Physical memory that this process uses [MB, 10^6 bytes]; 0 where the system does not tell.
double resident_memory_mb();

}  // namespace facet
