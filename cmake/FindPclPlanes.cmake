# The parts of the Point Cloud Library that pcl_planes needs: the target PclPlanes::PclPlanes. PCL's own package file
# asks for VTK, a desktop's worth of packages, even where only these are wanted.
find_path(PclPlanes_INCLUDE_DIR pcl/segmentation/organized_multi_plane_segmentation.h
  PATH_SUFFIXES pcl-1.13 pcl-1.14 pcl-1.15 pcl-1.12)
set(libraries)
foreach(part common features segmentation search kdtree octree filters sample_consensus)
  find_library(PclPlanes_${part}_LIBRARY pcl_${part})
  list(APPEND libraries PclPlanes_${part}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PclPlanes REQUIRED_VARS ${libraries} PclPlanes_INCLUDE_DIR)
mark_as_advanced(PclPlanes_INCLUDE_DIR ${libraries})
if(PclPlanes_FOUND AND NOT TARGET PclPlanes::PclPlanes)
  add_library(PclPlanes::PclPlanes INTERFACE IMPORTED)
  target_include_directories(PclPlanes::PclPlanes INTERFACE ${PclPlanes_INCLUDE_DIR})
  foreach(library ${libraries})
    target_link_libraries(PclPlanes::PclPlanes INTERFACE ${${library}})
  endforeach()
  target_link_libraries(PclPlanes::PclPlanes INTERFACE Eigen3::Eigen)
endif()
