#pragma once

#include <cstddef>

namespace facet {

/// The memory of the emulated device, which only the device may touch: who else does dies of a segmentation
/// fault. It is never given back.
class DeviceArena {
 public:
  static DeviceArena& instance();
  /// Open while the device works.
  class Access {
   public:
    Access();
    ~Access();
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;
  };
  /// Null where all of it is taken.
  void* allocate(std::size_t bytes);
  bool contains(const void* address) const { return address >= base_ && address < base_ + used_; }

 private:
  DeviceArena();
  void protect(int rights) const;

  std::byte* base_ = nullptr;
  std::size_t used_ = 0;
};

}  // namespace facet
