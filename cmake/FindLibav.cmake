# FFmpeg's libavformat, which demultiplexes recordings, and what it stands on: the target Libav::avformat.
find_path(LIBAV_INCLUDE_DIR libavformat/avformat.h)
foreach(part avformat avcodec avutil)
  find_library(LIBAV_${part}_LIBRARY ${part})
endforeach()
if(LIBAV_INCLUDE_DIR AND EXISTS ${LIBAV_INCLUDE_DIR}/libavformat/version_major.h)
  file(STRINGS ${LIBAV_INCLUDE_DIR}/libavformat/version_major.h LIBAV_VERSION REGEX "define LIBAVFORMAT_VERSION_MAJOR")
  string(REGEX MATCH "[0-9]+" LIBAV_VERSION "${LIBAV_VERSION}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Libav
  REQUIRED_VARS LIBAV_avformat_LIBRARY LIBAV_avcodec_LIBRARY LIBAV_avutil_LIBRARY LIBAV_INCLUDE_DIR
  VERSION_VAR LIBAV_VERSION)
mark_as_advanced(LIBAV_INCLUDE_DIR LIBAV_avformat_LIBRARY LIBAV_avcodec_LIBRARY LIBAV_avutil_LIBRARY)
if(Libav_FOUND AND NOT TARGET Libav::avformat)
  add_library(Libav::avformat INTERFACE IMPORTED)
  target_include_directories(Libav::avformat SYSTEM INTERFACE ${LIBAV_INCLUDE_DIR})
  target_link_libraries(Libav::avformat INTERFACE ${LIBAV_avformat_LIBRARY} ${LIBAV_avcodec_LIBRARY} ${LIBAV_avutil_LIBRARY})
endif()
