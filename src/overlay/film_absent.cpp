// What stands in where OpenCV's videoio was not found when the program was built.
#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "overlay/film.hpp"

namespace facet {

std::string film_obstacle() {
  return "this binary was built without OpenCV's videoio, which writes films; install libopencv-dev and "
         "build "
         "again";
}

int write_film(const std::filesystem::path& film, const std::vector<std::filesystem::path>&, double) {
  throw Error(ErrorKind::not_measured, printable(film) + ": " + film_obstacle());
}

}  // namespace facet
