#include "bodies/contact_wall.h"

#include <mutex>

#include "geometry/triangle_surface.h"

namespace vasorod {

struct ContactWall::State {
  explicit State(const TriangleSurface& surface)
      : rest(surface),
        now(rest.moved(surface.points)),
        carried(rest.moved(surface.points)),
        mean_edge(mean_edge_length(surface)),
        areas(vertex_areas(surface)) {}

  const ClosestPoint& moved(ClosestPoint& surface, const Points& points) {
    const std::lock_guard lock(moving);
    surface.refit(points);
    return surface;
  }

  ClosestPoint rest, now, carried;
  double mean_edge;
  Eigen::VectorXd areas;
  std::mutex moving;
};

ContactWall::ContactWall(const TriangleSurface& rest) : state_(std::make_shared<State>(rest)) {}

const TriangleSurface& ContactWall::rest() const {
  return state_->rest.surface();
}
const ClosestPoint& ContactWall::at_rest() const {
  return state_->rest;
}
double ContactWall::mean_edge() const {
  return state_->mean_edge;
}
const Eigen::VectorXd& ContactWall::areas() const {
  return state_->areas;
}
const ClosestPoint& ContactWall::now_at(const Points& points) {
  return state_->moved(state_->now, points);
}
const ClosestPoint& ContactWall::carried_to(const Points& points) {
  return state_->moved(state_->carried, points);
}

}  // namespace vasorod
