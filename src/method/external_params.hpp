#pragma once

#include <string>

namespace facet {

enum class ProgramCall {
  frame,  ///< one run of the program per frame
  batch,  ///< one run per data set: the placeholders are folders
};

/// How anyone's program is run (see method/external.hpp).
struct ExternalParams {
  std::string command;  ///< for /bin/sh, with {depth}, {color}, {intrinsics} and {out} in it
  ProgramCall per = ProgramCall::frame;
  float timeout_s = 60;     ///< of one run; then it and all that it started is killed, 0.01..86400
  float depth_unit_mm = 1;  ///< what 1 means in the depth images that it is given, 0.01..100
};

}  // namespace facet
