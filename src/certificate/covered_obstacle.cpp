#include "covered_obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limber {

namespace {

using Complex = std::complex<double>;

double dot(Complex a, Complex b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

/// > 0 if b points to the left of a.
double cross(Complex a, Complex b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// Of the edge from a to b.
Complex nearest_point(Complex p, Complex a, Complex b) {
  const Complex edge = b - a;
  const double length = std::norm(edge);
  const double along = length > 0.0 ? std::clamp(dot(p - a, edge) / length, 0.0, 1.0) : 0.0;
  return a + along * edge;
}

/// One edge's part in the winding number about p.
int winding_of(Complex a, Complex b, Complex p) {
  const double side = cross(b - a, p - a);  // > 0: p is left of the edge
  if (a.imag() <= p.imag() && b.imag() > p.imag() && side > 0.0) {
    return 1;
  }
  return a.imag() > p.imag() && b.imag() <= p.imag() && side < 0.0 ? -1 : 0;
}

/// Whether a closed outline turns to one side only, and once around in all.
bool turns_once(const std::vector<Complex>& corners) {
  constexpr double kRoundingRad = 1e-3;
  const std::size_t count = corners.size() - 1;
  double turned = 0.0;
  double turned_either_way = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Complex before = corners[i + 1] - corners[i];
    const Complex after = corners[(i + 1) % count + 1] - corners[i + 1];
    const double turn = std::atan2(cross(before, after), dot(before, after));
    turned += turn;
    turned_either_way += std::abs(turn);
    if (turned_either_way != std::abs(turned)) {
      return false;
    }
  }
  return std::abs(turned_either_way - 2.0 * std::numbers::pi) < kRoundingRad;
}

Reading reading_of(const Circle& circle, Complex p) {
  const Complex offset = p - Complex(circle.x_m, circle.y_m);
  const double apart = std::sqrt(std::norm(offset));
  return {apart - circle.radius_m, apart > 0.0 ? offset / apart : Complex(0.0)};
}

Reading reading_of(const Rectangle& rectangle, Complex p) {
  const Complex turn(std::cos(rectangle.angle_rad), std::sin(rectangle.angle_rad));
  const Complex own = (p - Complex(rectangle.x_m, rectangle.y_m)) * std::conj(turn);
  const double x = std::abs(own.real()) - rectangle.width_m / 2.0;
  const double y = std::abs(own.imag()) - rectangle.height_m / 2.0;
  double distance = std::max(x, y);
  Complex away = x > y ? Complex(1.0, 0.0) : Complex(0.0, 1.0);
  if (x > 0.0 && y > 0.0) {
    distance = std::sqrt(x * x + y * y);
    away = Complex(x, y) / distance;
  }
  const Complex seen(std::copysign(away.real(), own.real()),
                     std::copysign(away.imag(), own.imag()));
  return {distance, seen * turn};
}

Reading reading_of(const PolygonOutline& outline, Complex p) {
  return outline.read(p);
}

CoveringBox box_about(const Circle& circle) {
  CoveringBox box;
  const Complex centre(circle.x_m, circle.y_m);
  const Complex corner(circle.radius_m, circle.radius_m);
  box.cover(centre - corner);
  box.cover(centre + corner);
  return box;
}

CoveringBox box_about(const Rectangle& rectangle) {
  CoveringBox box;
  const Complex turn = std::polar(1.0, rectangle.angle_rad);
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      box.cover(Complex(rectangle.x_m, rectangle.y_m) +
                turn * Complex(x * rectangle.width_m, y * rectangle.height_m));
    }
  }
  return box;
}

CoveringBox box_about(const PolygonOutline& outline) {
  return outline.box();
}

std::variant<Circle, Rectangle, PolygonOutline> readable(const Obstacle& obstacle) {
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return *circle;
  }
  if (const auto* rectangle = std::get_if<Rectangle>(&obstacle)) {
    return *rectangle;
  }
  return PolygonOutline(std::get<Polygon>(obstacle));
}

}  // namespace

void CoveringBox::cover(Complex p) {
  low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
  high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
}

void CoveringBox::cover(const CoveringBox& other) {
  cover(other.low);
  cover(other.high);
}

double CoveringBox::distance_m(Complex p) const {
  const double x = std::max(low.real() - p.real(), p.real() - high.real());
  const double y = std::max(low.imag() - p.imag(), p.imag() - high.imag());
  return x > 0.0 && y > 0.0 ? std::sqrt(x * x + y * y) : std::max(x, y);
}

double CoveringBox::squared_distance(const CoveringBox& other) const {
  const double x = std::max({low.real() - other.high.real(), other.low.real() - high.real(), 0.0});
  const double y = std::max({low.imag() - other.high.imag(), other.low.imag() - high.imag(), 0.0});
  return x * x + y * y;
}

struct PolygonOutline::Nearest {
  double squared = std::numeric_limits<double>::infinity();
  Complex point;
};

PolygonOutline::PolygonOutline(const Polygon& polygon) {
  for (const Eigen::Vector2d& p : polygon.points_m) {
    corners_.emplace_back(p.x(), p.y());
  }
  corners_.push_back(corners_.front());
  add_node(0, corners_.size() - 1);
  is_convex_ = turns_once(corners_);
}

std::size_t PolygonOutline::add_node(std::size_t first, std::size_t end) {
  const std::size_t index = nodes_.size();
  nodes_.push_back({{}, first, end});
  CoveringBox box;
  if (end - first <= kEdgesPerLeaf) {
    for (std::size_t i = first; i <= end; ++i) {
      box.cover(corners_[i]);
    }
  } else {
    const std::size_t middle = first + (end - first) / 2;
    box.cover(nodes_[add_node(first, middle)].box);
    const std::size_t second = add_node(middle, end);
    box.cover(nodes_[second].box);
    nodes_[index].second_child = second;
  }
  nodes_[index].box = box;
  return index;
}

void PolygonOutline::find_nearest(std::size_t node, Complex p, Nearest& nearest) const {
  const Node& here = nodes_[node];
  if (here.second_child == 0) {
    for (std::size_t i = here.first; i < here.end; ++i) {
      const Complex point = nearest_point(p, corners_[i], corners_[i + 1]);
      const double squared = std::norm(p - point);
      if (squared < nearest.squared) {
        nearest = {squared, point};
      }
    }
    return;
  }
  const CoveringBox at_p{p, p};
  std::size_t children[2] = {node + 1, here.second_child};
  double squared[2] = {nodes_[children[0]].box.squared_distance(at_p),
                       nodes_[children[1]].box.squared_distance(at_p)};
  if (squared[1] < squared[0]) {
    std::swap(children[0], children[1]);
    std::swap(squared[0], squared[1]);
  }
  for (const int i : {0, 1}) {
    if (squared[i] < nearest.squared) {
      find_nearest(children[i], p, nearest);
    }
  }
}

int PolygonOutline::winding_number(std::size_t node, Complex p) const {
  const Node& here = nodes_[node];
  // Edges count where the ray from p along x meets them.
  if (p.imag() < here.box.low.imag() || p.imag() > here.box.high.imag() ||
      p.real() > here.box.high.real()) {
    return 0;
  }
  if (p.real() < here.box.low.real()) {
    // The ray crosses all of it: what matters is from which side to which its edges lead.
    return int{corners_[here.end].imag() > p.imag()} - int{corners_[here.first].imag() > p.imag()};
  }
  if (here.second_child != 0) {
    return winding_number(node + 1, p) + winding_number(here.second_child, p);
  }
  int winding = 0;
  for (std::size_t i = here.first; i < here.end; ++i) {
    winding += winding_of(corners_[i], corners_[i + 1], p);
  }
  return winding;
}

Reading PolygonOutline::read(Complex p) const {
  Nearest nearest;
  find_nearest(0, p, nearest);
  const double distance = std::sqrt(nearest.squared);
  const double sign = winding_number(0, p) != 0 ? -1.0 : 1.0;
  const Complex away =
      is_convex_ && distance > 0.0 ? sign * (p - nearest.point) / distance : Complex(0.0);
  return {sign * distance, away};
}

CoveredObstacle::CoveredObstacle(const Obstacle& obstacle)
    : shape(readable(obstacle)),
      box(std::visit([](const auto& s) { return box_about(s); }, shape)) {}

Reading CoveredObstacle::read(Complex p) const {
  return std::visit([p](const auto& s) { return reading_of(s, p); }, shape);
}

}  // namespace limber
