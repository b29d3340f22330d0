// Our surface as CGAL's and back. Only for .cpp files: CGAL is heavy.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <array>
#include <stdexcept>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

/// Points and faces without what joins them, as CGAL takes what may be no surface.
struct CgalSoup {
  std::vector<CgalKernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> faces;
};

/// Points and faces get the indices of our points and triangles.
inline CgalSoup to_soup(const TriangleSurface& surface) {
  CgalSoup soup;
  for (const auto p : surface.points.rowwise()) soup.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto t : surface.triangles.rowwise())
    soup.faces.push_back({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                          static_cast<std::size_t>(t[2])});
  return soup;
}

/// Vertices and faces get the indices of our points and triangles.
inline CgalMesh to_cgal(const TriangleSurface& surface) {
  CgalMesh mesh;
  mesh.reserve(static_cast<CgalMesh::size_type>(surface.points.rows()),
               static_cast<CgalMesh::size_type>(surface.triangles.rows() * 3 / 2),
               static_cast<CgalMesh::size_type>(surface.triangles.rows()));
  for (int i = 0; i < surface.points.rows(); ++i)
    mesh.add_vertex({surface.points(i, 0), surface.points(i, 1), surface.points(i, 2)});
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    auto corner = [&](int k) {
      return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(surface.triangles(t, k)));
    };
    if (mesh.add_face(corner(0), corner(1), corner(2)) == CgalMesh::null_face())
      throw std::logic_error("to_cgal: the surface is not manifold");
  }
  return mesh;
}

/// Vertices and faces in the mesh's order, without those that were removed.
inline TriangleSurface from_cgal(const CgalMesh& mesh) {
  TriangleSurface surface;
  surface.points.resize(mesh.number_of_vertices(), 3);
  std::vector<int> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
  int next = 0;
  for (const auto v : mesh.vertices()) {
    number[v.idx()] = next;
    surface.points.row(next++) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  }
  surface.triangles.resize(mesh.number_of_faces(), 3);
  int t = 0;
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      surface.triangles(t, k++) = number[v.idx()];
    ++t;
  }
  return surface;
}

}  // namespace vasorod
