#include "report/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vasorod {

namespace {

constexpr int samples = 2;  // per pixel and direction
constexpr std::uint32_t nothing = 0xFFFFFFFFU;

using Vec3f = Eigen::Vector3f;

struct Vertex {
  float x, y,
      nearness;  // sample grid; 1 / distance from the eye, linear over a triangle on the screen
  Vec3f normal;  // camera axes
};

struct Corner {
  std::uint32_t vertex[3];
  std::uint16_t body;
};

// Depth and triangle of the nearest body at each sample.
struct Layer {
  std::vector<float> nearness;
  std::vector<std::uint32_t> triangle;
  explicit Layer(std::size_t count) : nearness(count, 0.0F), triangle(count, nothing) {}
};

struct Canvas {
  int columns, rows;  // of samples
  std::vector<Vertex> vertices;
  std::vector<Corner> triangles;

  std::size_t sample(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }
};

void add_vertices(Canvas& canvas, const DrawnSurface& surface, const Camera& camera) {
  const auto first = canvas.vertices.size();
  const double per_unit = 0.5 * canvas.rows / camera.half_height;
  const auto n = surface.points->rows();
  canvas.vertices.reserve(first + static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec3 at = camera.axes * (surface.points->row(i).transpose() - camera.centre);
    const double away = camera.distance - at.z();
    const double shrink = camera.distance / away * per_unit;
    Vertex vertex;
    vertex.x = static_cast<float>(0.5 * (1 - camera.shift) * canvas.columns + shrink * at.x());
    vertex.y = static_cast<float>(0.5 * canvas.rows - shrink * at.y());
    vertex.nearness = static_cast<float>(camera.distance / away);
    if (!(away > 1e-3 * camera.distance) || !at.allFinite())
      vertex.nearness = 0;  // behind the eye: not drawn
    vertex.normal.setZero();
    canvas.vertices.push_back(vertex);
  }
  // Normals weighted by area: at this size they look the same as normals weighted by angle, and
  // they take a tenth of the time.
  for (Eigen::Index t = 0; t < surface.triangles->rows(); ++t) {
    const auto corner = surface.triangles->row(t);
    const Vec3 a = surface.points->row(corner[0]), b = surface.points->row(corner[1]),
               c = surface.points->row(corner[2]);
    const Vec3 ab = camera.axes * (b - a), ac = camera.axes * (c - a);
    const Vec3f normal = Vec3(ab.y() * ac.z() - ab.z() * ac.y(), ab.z() * ac.x() - ab.x() * ac.z(),
                              ab.x() * ac.y() - ab.y() * ac.x())
                             .cast<float>();
    for (int k = 0; k < 3; ++k)
      canvas.vertices[first + static_cast<std::size_t>(corner[k])].normal += normal;
  }
  for (std::size_t i = first; i < canvas.vertices.size(); ++i)
    canvas.vertices[i].normal.normalize();
}

void add(Canvas& canvas, const DrawnSurface& surface, std::size_t body, const Camera& camera) {
  const auto first = static_cast<std::uint32_t>(canvas.vertices.size());
  add_vertices(canvas, surface, camera);
  for (Eigen::Index t = 0; t < surface.triangles->rows(); ++t) {
    Corner corner{};
    for (int k = 0; k < 3; ++k)
      corner.vertex[k] = first + static_cast<std::uint32_t>((*surface.triangles)(t, k));
    corner.body = static_cast<std::uint16_t>(body);
    canvas.triangles.push_back(corner);
  }
}

void draw(const Canvas& canvas, std::uint32_t index, Layer& layer) {
  const Corner& corner = canvas.triangles[index];
  const Vertex *a = &canvas.vertices[corner.vertex[0]], *b = &canvas.vertices[corner.vertex[1]],
               *c = &canvas.vertices[corner.vertex[2]];
  if (a->nearness <= 0 || b->nearness <= 0 || c->nearness <= 0) return;
  float area = (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
  if (area == 0) return;
  if (area < 0) {
    std::swap(b, c);
    area = -area;
  }
  const auto first = [](float v) { return static_cast<int>(std::ceil(std::max(v, 0.0F) - 0.5F)); };
  const auto last = [](float v, int count) {
    return static_cast<int>(std::ceil(std::min(v, static_cast<float>(count)) - 0.5F));
  };
  const int left = std::max(0, first(std::min({a->x, b->x, c->x}))),
            top = std::max(0, first(std::min({a->y, b->y, c->y})));
  const int right = last(std::max({a->x, b->x, c->x}), canvas.columns),
            bottom = last(std::max({a->y, b->y, c->y}), canvas.rows);
  const float inverse = 1 / area;
  // Barycentric coordinates of b and c are linear in the sample's place.
  const float ub = (c->y - a->y) * inverse, vb = -(c->x - a->x) * inverse;
  const float uc = -(b->y - a->y) * inverse, vc = (b->x - a->x) * inverse;
  const float to_b = b->nearness - a->nearness, to_c = c->nearness - a->nearness;
  constexpr float slack = -1e-5F;  // no gaps along shared edges
  const float x = a->x, near = a->nearness;
  for (int row = top; row < bottom; ++row) {
    const float dy = static_cast<float>(row) + 0.5F - a->y;
    float* nearness = layer.nearness.data() + canvas.sample(0, row);
    std::uint32_t* triangle = layer.triangle.data() + canvas.sample(0, row);
    // Without branches, so that compilers take several samples at once.
    for (int column = left; column < right; ++column) {
      const float dx = static_cast<float>(column) + 0.5F - x;
      const float at_b = ub * dx + vb * dy, at_c = uc * dx + vc * dy;
      const float here = near + at_b * to_b + at_c * to_c, before = nearness[column];
      const bool hidden =
          (at_b < slack) | (at_c < slack) | (at_b + at_c > 1 - slack) | (here <= before);
      nearness[column] = hidden ? before : here;
      triangle[column] = hidden ? triangle[column] : index;
    }
  }
}

struct Shade {
  Vec3f colour = Vec3f::Zero();
  float facing = 0;  // 1 face-on, 0 at the outline
};

// The main light comes from above and left of the viewer, a weaker and cooler one from the right.
// Brightness depends on the normal alone, and only weakly, so that a colour can still be found in
// its scale.
Shade shade(const Canvas& canvas, const std::vector<Vec3f>& colours, std::uint32_t index, float x,
            float y) {
  const Corner& corner = canvas.triangles[index];
  const Vertex &a = canvas.vertices[corner.vertex[0]], &b = canvas.vertices[corner.vertex[1]],
               &c = canvas.vertices[corner.vertex[2]];
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), inverse = 1 / area;
  const float at_b =
      std::clamp(((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) * inverse, 0.0F, 1.0F);
  const float at_c =
      std::clamp(((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) * inverse, 0.0F, 1.0F - at_b);
  const float at_a = 1 - at_b - at_c;
  Vec3f normal = at_a * a.normal + at_b * b.normal + at_c * c.normal;
  normal *= 1 / std::sqrt(normal.squaredNorm() + 1e-12F);
  const bool inside =
      area > 0;  // rows count downwards: counter-clockwise triangles have a negative area
  if (inside) normal = -normal;
  normal.z() = std::abs(normal.z());
  const Vec3f key(-0.436F, 0.532F, 0.726F), fill(0.866F, -0.108F, 0.487F),
      half(-0.235F, 0.287F, 0.929F);
  const float lit = std::max(0.0F, normal.dot(key)), filled = std::max(0.0F, normal.dot(fill));
  const float gloss = std::max(0.0F, normal.dot(half)), gloss4 = gloss * gloss * gloss * gloss;
  const float gloss16 = gloss4 * gloss4 * gloss4 * gloss4, edge = 1 - normal.z();
  const Vec3f light = Vec3f(0.64F, 0.65F, 0.67F) + lit * Vec3f(0.40F, 0.39F, 0.37F) +
                      filled * Vec3f(0.12F, 0.13F, 0.15F);
  const Vec3f own = at_a * colours[corner.vertex[0]] + at_b * colours[corner.vertex[1]] +
                    at_c * colours[corner.vertex[2]];
  Vec3f colour = own.cwiseProduct(light) * (1 - 0.28F * edge * edge) +
                 Vec3f::Constant(0.10F * gloss16 * gloss16);
  if (inside) colour *= 0.66F;
  return {colour.cwiseMin(1.0F), normal.z()};
}

// Depth jumps in one row of samples: 1 on the farther side of a jump, which gives a thin line. A
// smooth wall has none.
void outline(const Layer& layer, const Canvas& canvas, int row, std::vector<std::uint8_t>& marks) {
  std::fill(marks.begin(), marks.end(), std::uint8_t{0});
  if (row == 0 || row + 1 == canvas.rows) return;
  const float *here = &layer.nearness[canvas.sample(0, row)], *above = here - canvas.columns,
              *below = here + canvas.columns;
  std::uint8_t* mark = marks.data();
  const int last = canvas.columns - 1;
  for (int x = 1; x < last; ++x) {
    const float across = here[x - 1] + here[x + 1] - 2 * here[x],
                down = above[x] + below[x] - 2 * here[x];
    mark[x] = std::max(across, down) > 0.006F;
  }
}

// Edges that belong to one triangle only.
std::vector<std::array<std::uint32_t, 2>> border(const Triangles& triangles, std::uint32_t first,
                                                 Eigen::Index vertices) {
  const auto ends = [&](Eigen::Index t, int k) -> std::pair<std::uint32_t, std::uint32_t> {
    const auto a = static_cast<std::uint32_t>(triangles(t, k)),
               b = static_cast<std::uint32_t>(triangles(t, (k + 1) % 3));
    return {std::min(a, b), std::max(a, b)};
  };
  // The larger ends of all edges, sorted by the smaller end: each has few.
  std::vector<std::uint32_t> end(static_cast<std::size_t>(vertices) + 2, 0);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) ++end[ends(t, k).first + 2];
  for (std::size_t v = 2; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<std::uint32_t> larger(3 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = ends(t, k);
      larger[end[a + 1]++] = b;
    }
  std::vector<std::array<std::uint32_t, 2>> alone;
  for (std::uint32_t a = 0; a < vertices; ++a) {
    const auto from = larger.begin() + end[a], to = larger.begin() + end[a + 1];
    for (auto b = from; b != to; ++b)
      if (std::count(from, to, *b) == 1) alone.push_back({first + a, first + *b});
  }
  return alone;
}

enum Mark : std::uint8_t { unmarked = 0, on_border, on_mesh };

// Marks the samples under an edge, and `spread` more on each side, unless a body of one of the
// layers hides them.
void mark_edge(const Canvas& canvas, const std::vector<const Layer*>& layers, const Vertex& a,
               const Vertex& b, Mark mark, int spread, std::vector<std::uint8_t>& marks) {
  if (a.nearness <= 0 || b.nearness <= 0) return;
  constexpr float slack = 0.003F;  // of the distance: the edge lies on the facets it bounds
  const float most = 4.0F * static_cast<float>(std::max(canvas.columns, canvas.rows));
  const float length = std::min(most, std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)));
  const int steps = 1 + static_cast<int>(length);
  for (int k = 0; k <= steps; ++k) {
    const float t = static_cast<float>(k) / static_cast<float>(steps);
    const float x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
    if (!(x >= 1 && y >= 1 && x < static_cast<float>(canvas.columns - 1) &&
          y < static_cast<float>(canvas.rows - 1)))
      continue;
    const float nearness = a.nearness + t * (b.nearness - a.nearness) + slack;
    for (int row = -spread; row <= spread; ++row)
      for (int column = -spread; column <= spread; ++column) {
        const std::size_t sample =
            canvas.sample(static_cast<int>(x) + column, static_cast<int>(y) + row);
        if (std::all_of(layers.begin(), layers.end(),
                        [&](const Layer* layer) { return nearness >= layer->nearness[sample]; }))
          marks[sample] = mark;
      }
  }
}

// The borders of solid bodies, and the edges of bodies whose mesh is shown. A transparent body
// hides the mesh behind it, too.
void mark_edges(const Canvas& canvas, const std::vector<DrawnSurface>& surfaces, const Layer& solid,
                const Layer& glass, std::vector<std::uint8_t>& marks) {
  std::vector<const Layer*> all{&solid};
  if (!glass.nearness.empty()) all.push_back(&glass);
  std::uint32_t first = 0;
  for (const DrawnSurface& surface : surfaces) {
    const auto vertex = [&](std::uint32_t k) -> const Vertex& { return canvas.vertices[k]; };
    if (surface.mesh)
      for (Eigen::Index t = 0; t < surface.triangles->rows(); ++t)
        for (int k = 0; k < 3; ++k) {
          const int a = (*surface.triangles)(t, k), b = (*surface.triangles)(t, (k + 1) % 3);
          mark_edge(canvas, all, vertex(first + static_cast<std::uint32_t>(a)),
                    vertex(first + static_cast<std::uint32_t>(b)), on_mesh, 0, marks);
        }
    if (surface.opacity >= 1)
      for (const auto& [a, b] : border(*surface.triangles, first, surface.points->rows()))
        mark_edge(canvas, {&solid}, vertex(a), vertex(b), on_border, 1, marks);
    first += static_cast<std::uint32_t>(surface.points->rows());
  }
}

std::vector<Vec3f> colours_of_vertices(const std::vector<DrawnSurface>& surfaces) {
  std::vector<Vec3f> colours;
  for (const DrawnSurface& surface : surfaces)
    for (Eigen::Index i = 0; i < surface.points->rows(); ++i) {
      const Colour colour =
          surface.values ? (*surface.scale)((*surface.values)[i]) : surface.colour;
      colours.emplace_back(colour[0], colour[1], colour[2]);
    }
  return colours;
}

// Sum of one pixel's samples, premultiplied.
struct Sum {
  Vec3f colour = Vec3f::Zero();
  float cover = 0;
};

class Resolver {
 public:
  Resolver(const Canvas& canvas, const Layer& solid, const Layer& glass,
           const std::vector<std::uint8_t>& borders, const std::vector<DrawnSurface>& surfaces)
      : canvas_(canvas),
        solid_(solid),
        glass_(glass),
        borders_(borders),
        surfaces_(surfaces),
        colours_(colours_of_vertices(surfaces)) {}

  void start_row(int row) {
    for (int k = 0; k < samples; ++k) {
      marks_[static_cast<std::size_t>(k)].resize(static_cast<std::size_t>(canvas_.columns));
      outline(solid_, canvas_, samples * row + k, marks_[static_cast<std::size_t>(k)]);
    }
  }

  Sum pixel(int column, int row) const {
    Sum sum;
    std::uint32_t former = nothing, former_pane = nothing;
    Shade shown, pane;
    for (int s = 0; s < samples * samples; ++s) {
      const int x = samples * column + s % samples, y = samples * row + s / samples;
      const std::size_t at = canvas_.sample(x, y);
      Vec3f colour = Vec3f::Zero();
      float alpha = 0;
      if (solid_.triangle[at] != nothing) {
        shade_once(solid_.triangle[at], former, shown, column, row);
        colour = shown.colour;
        alpha = 1;
      }
      if (borders_[at] == on_border ||
          marks_[static_cast<std::size_t>(s / samples)][static_cast<std::size_t>(x)]) {
        colour *= 0.4F;
        alpha = std::max(alpha, 0.6F);
      } else if (borders_[at] == on_mesh) {
        colour *= 0.55F;
        alpha = std::max(alpha, 0.45F);
      }
      if (!glass_.triangle.empty() && glass_.nearness[at] > solid_.nearness[at]) {
        shade_once(glass_.triangle[at], former_pane, pane, column, row);
        const float opacity = surfaces_[canvas_.triangles[former_pane].body].opacity;
        const float hides =
            1 -
            (1 - opacity) * std::min(1.0F, 0.35F + pane.facing);  // a slanted pane is more opaque
        colour = hides * pane.colour + (1 - hides) * colour;
        alpha = hides + (1 - hides) * alpha;
      }
      sum.colour += colour;
      sum.cover += alpha;
    }
    return sum;
  }

 private:
  // A triangle is shaded once per pixel, at the pixel's middle.
  void shade_once(std::uint32_t triangle, std::uint32_t& former, Shade& result, int column,
                  int row) const {
    if (triangle != former)
      result = shade(canvas_, colours_, triangle, middle(column), middle(row));
    former = triangle;
  }
  static float middle(int pixel) { return samples * (static_cast<float>(pixel) + 0.5F); }
  const Canvas& canvas_;
  const Layer &solid_, &glass_;
  const std::vector<std::uint8_t>& borders_;
  const std::vector<DrawnSurface>& surfaces_;
  std::vector<Vec3f> colours_;
  std::array<std::vector<std::uint8_t>, samples> marks_;
};

// One pixel larger on every side than the vertices need.
struct Box {
  int left, top, right, bottom;
};

Box drawn_box(const Canvas& canvas, int width, int height) {
  float left = 1e9F, top = 1e9F, right = -1e9F, bottom = -1e9F;
  for (const Vertex& vertex : canvas.vertices)
    if (vertex.nearness > 0) {
      left = std::min(left, vertex.x);
      right = std::max(right, vertex.x);
      top = std::min(top, vertex.y);
      bottom = std::max(bottom, vertex.y);
    }
  const auto pixel = [](float sample, int more, int most) {
    return static_cast<int>(
        std::clamp(sample / samples + static_cast<float>(more), 0.0F, static_cast<float>(most)));
  };
  return {pixel(left, -1, width), pixel(top, -1, height), pixel(right, 2, width),
          pixel(bottom, 2, height)};
}

}  // namespace

struct Drawing::Data {
  int width, height;
  Canvas canvas;
  Layer solid, glass;
  std::vector<std::uint8_t> borders;
};

Drawing::Drawing(const std::vector<DrawnSurface>& surfaces, const Camera& camera, int width,
                 int height) {
  Canvas canvas{samples * width, samples * height, {}, {}};
  const std::size_t count =
      static_cast<std::size_t>(canvas.columns) * static_cast<std::size_t>(canvas.rows);
  bool any_glass = false;
  for (std::size_t body = 0; body < surfaces.size(); ++body) {
    add(canvas, surfaces[body], body, camera);
    any_glass |= surfaces[body].opacity < 1;
  }
  Layer solid(count), glass(any_glass ? count : 0);
  for (std::uint32_t t = 0; t < canvas.triangles.size(); ++t)
    draw(canvas, t, surfaces[canvas.triangles[t].body].opacity < 1 ? glass : solid);

  std::vector<std::uint8_t> borders(count, unmarked);
  mark_edges(canvas, surfaces, solid, glass, borders);
  data_ = std::make_shared<const Data>(Data{width, height, std::move(canvas), std::move(solid),
                                            std::move(glass), std::move(borders)});
}

std::vector<int> Drawing::bodies() const {
  const Data& data = *data_;
  std::vector<int> found;
  found.reserve(static_cast<std::size_t>(data.width) * static_cast<std::size_t>(data.height));
  for (int row = 0; row < data.height; ++row)
    for (int column = 0; column < data.width; ++column) {
      const std::size_t at = data.canvas.sample(samples * column, samples * row);
      const bool pane = !data.glass.triangle.empty() && data.glass.triangle[at] != nothing &&
                        data.glass.nearness[at] > data.solid.nearness[at];
      const std::uint32_t triangle = pane ? data.glass.triangle[at] : data.solid.triangle[at];
      found.push_back(triangle == nothing ? -1 : data.canvas.triangles[triangle].body);
    }
  return found;
}

Picture Drawing::coloured(const std::vector<DrawnSurface>& surfaces) const {
  const auto& [width, height, canvas, solid, glass, borders] = *data_;
  Picture picture{width, height,
                  std::vector<std::uint8_t>(borders.size() / (samples * samples) * 4)};
  Resolver resolver(canvas, solid, glass, borders, surfaces);
  const Box box = drawn_box(canvas, width, height);
  for (int row = box.top; row < box.bottom; ++row) {
    resolver.start_row(row);
    for (int column = box.left; column < box.right; ++column) {
      const Sum sum = resolver.pixel(column, row);
      if (sum.cover <= 0) continue;
      std::uint8_t* pixel =
          &picture.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column))];
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(
            std::clamp(255 * sum.colour[k] / sum.cover + 0.5F, 0.0F, 255.0F));
      pixel[3] = static_cast<std::uint8_t>(std::lround(255 * sum.cover / (samples * samples)));
    }
  }
  return picture;
}

Picture render(const std::vector<DrawnSurface>& surfaces, const Camera& camera, int width,
               int height) {
  return Drawing(surfaces, camera, width, height).coloured(surfaces);
}

}  // namespace vasorod
