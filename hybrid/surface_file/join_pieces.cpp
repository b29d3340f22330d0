#include "surface_file/join_pieces.h"

#include <algorithm>
#include <array>
#include <limits>

#include "data/index.h"

namespace vasorod {

namespace {

const NamedArray* like(const std::vector<NamedArray>& arrays, const NamedArray& wanted) {
  for (const NamedArray& array : arrays)
    if (array.name == wanted.name && array.values.cols() == wanted.values.cols()) return &array;
  return nullptr;
}

// Joins the arrays that all pieces have. `blocks` gives the order of the rows: piece, first row and
// number of rows.
template <class Arrays>
std::vector<NamedArray> joined_arrays(const std::vector<SurfaceFile>& pieces, Arrays arrays_of,
                                      const std::vector<std::array<Eigen::Index, 3>>& blocks) {
  std::vector<NamedArray> joined;
  Eigen::Index rows = 0;
  for (const auto& [piece, first, count] : blocks) rows += count;
  for (const NamedArray& array : arrays_of(pieces.front())) {
    const bool everywhere = std::all_of(pieces.begin(), pieces.end(), [&](const SurfaceFile& p) {
      return like(arrays_of(p), array) != nullptr;
    });
    if (!everywhere) continue;
    NamedArray all = array;
    all.values.resize(rows, array.values.cols());
    Eigen::Index at = 0;
    for (const auto& [piece, first, count] : blocks) {
      all.values.middleRows(at, count) =
          like(arrays_of(pieces[index(piece)]), array)->values.middleRows(first, count);
      at += count;
    }
    joined.push_back(std::move(all));
  }
  return joined;
}

}  // namespace

SurfaceFile joined_pieces(std::vector<SurfaceFile> pieces) {
  if (pieces.size() == 1) return std::move(pieces.front());
  SurfaceFile all;
  all.space = pieces.front().space;
  std::vector<std::array<Eigen::Index, 3>> point_rows, skipped_rows, polygon_rows, strip_rows;
  Eigen::Index points = 0;
  for (const SurfaceFile& piece : pieces) points += piece.points.rows();
  all.points.resize(points, 3);
  points = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const SurfaceFile& piece = pieces[p];
    const auto at = static_cast<Eigen::Index>(p);
    const Eigen::Index skipped = piece.skipped_cells, polygons = std::ssize(piece.polygons);
    point_rows.push_back({at, 0, piece.points.rows()});
    skipped_rows.push_back({at, 0, skipped});
    polygon_rows.push_back({at, skipped, polygons});
    strip_rows.push_back({at, skipped + polygons, std::ssize(piece.strips)});
    all.points.middleRows(points, piece.points.rows()) = piece.points;
    const auto add = [&](const std::vector<std::vector<int>>& from,
                         std::vector<std::vector<int>>& to) {
      for (std::vector<int> cell : from) {
        for (int& id : cell)  // an index outside its piece stays invalid
          id = id >= 0 && id < piece.points.rows() && points + id < std::numeric_limits<int>::max()
                   ? static_cast<int>(points) + id
                   : -1;
        to.push_back(std::move(cell));
      }
    };
    add(piece.lines, all.lines);
    add(piece.polygons, all.polygons);
    add(piece.strips, all.strips);
    all.skipped_cells += piece.skipped_cells;
    points += piece.points.rows();
  }
  all.point_arrays = joined_arrays(
      pieces, [](const SurfaceFile& p) -> auto& { return p.point_arrays; }, point_rows);
  auto& cell_rows = skipped_rows;
  cell_rows.insert(cell_rows.end(), polygon_rows.begin(), polygon_rows.end());
  cell_rows.insert(cell_rows.end(), strip_rows.begin(), strip_rows.end());
  all.cell_arrays = joined_arrays(
      pieces, [](const SurfaceFile& p) -> auto& { return p.cell_arrays; }, cell_rows);
  return all;
}

}  // namespace vasorod
