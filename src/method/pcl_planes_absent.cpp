#include "core/error.hpp"
#include "method/pcl_planes.hpp"

namespace facet {

std::optional<PredictedParts> yields_pcl_planes(const MethodSpec&) {
  return PredictedParts{.edges = true, .poses = true};
}

std::string_view what_pcl_planes_lack() {
  return "this binary was built without PCL: install it (scripts/bootstrap.sh --with-pcl, or libpcl-dev), "
         "configure and build again";
}

std::unique_ptr<Method> make_pcl_planes(const MethodSpec&, const MethodContext&) {
  throw Error(ErrorKind::not_measured, std::string(what_pcl_planes_lack()));
}

}  // namespace facet
