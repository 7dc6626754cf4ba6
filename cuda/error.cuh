#pragma once

#include <cuda_runtime_api.h>
#include <string>

#include "core/error.hpp"

namespace facet {

/// Whether a status tells of a fault in a kernel of ours rather than of the machine: a bad access, a failed
/// assertion, a launch that cannot be.
inline bool is_kernel_fault(cudaError_t status) {
  switch (status) {
    case cudaErrorIllegalAddress:
    case cudaErrorMisalignedAddress:
    case cudaErrorIllegalInstruction:
    case cudaErrorInvalidAddressSpace:
    case cudaErrorInvalidPc:
    case cudaErrorHardwareStackError:
    case cudaErrorLaunchFailure:
    case cudaErrorAssert:
    case cudaErrorInvalidValue:
    case cudaErrorInvalidConfiguration:
    case cudaErrorInvalidResourceHandle:
      return true;
    default:
      return false;
  }
}

/// Throws what a call of the CUDA runtime reports: Error{internal} where the fault is ours, else
/// Error{not_measured}: no device, no memory, no code for this device. `what` says what was to be done.
inline void check_cuda(cudaError_t status, const char* what) {
  if (status == cudaSuccess) return;
  static_cast<void>(cudaGetLastError());  // so that the next call does not report it again
  throw Error(is_kernel_fault(status) ? ErrorKind::internal : ErrorKind::not_measured,
              std::string("CUDA cannot ") + what + ": " + cudaGetErrorString(status) + " (" +
                  cudaGetErrorName(status) + ")");
}

}  // namespace facet
