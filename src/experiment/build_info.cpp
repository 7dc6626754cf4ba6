#include "experiment/build_info.hpp"

#include "dataset/checksum.hpp"
#include "experiment/build_info_values.hpp"
#include "method/backend.hpp"

namespace facet {

const BuildInfo& build_info() {
  static const BuildInfo info{FACET_VERSION,
                              FACET_COMMIT,
                              FACET_DIRTY,
                              FACET_COMPILER,
                              FACET_BUILD_TYPE,
                              FACET_FLAGS,
                              cuda_compiler().empty() ? "none: built without CUDA" : cuda_compiler()};
  return info;
}

std::string build_identity() {
  const BuildInfo& info = build_info();
  if (!info.dirty && info.commit != "unknown") return info.name();
  static const std::string executable = sha256_of_file("/proc/self/exe").substr(0, 8);
  return info.name() + '-' + executable;
}

}  // namespace facet
