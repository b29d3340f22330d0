#include "mask/mask_surface.h"

#include <Eigen/LU>
#include <cmath>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vasorod/error.h>

#include "data/sentence.h"

namespace vasorod {
namespace {

int chosen_label(const std::string& file, const Mask& mask, std::optional<int> asked) {
  std::string all;
  int named = 0;
  for (const auto& [label, count] : mask.count) {
    if (++named > 12) continue;
    all += (all.empty() ? "" : ", ") + std::to_string(label) + " (" + std::to_string(count) +
           (count == 1 ? " voxel)" : " voxels)");
  }
  if (named > 12) all += " and " + std::to_string(named - 12) + " more";
  if (mask.count.empty())
    throw InputError(file + ": found no voxel other than 0, expected a mask with a vessel");
  if (asked) {
    if (mask.count.contains(*asked)) return *asked;
    throw InputError(file + ": found no voxel of label " + std::to_string(*asked) +
                     ", expected one of " + all);
  }
  if (mask.count.size() > 1)
    throw InputError(file + ": found the labels " + all + ", expected --label to name one");
  return mask.count.begin()->first;
}

// First and last index of the label's voxels along each axis.
struct Box {
  std::array<std::int64_t, 3> low, high;
};

Box box_of(const Mask& mask, std::int32_t label) {
  const auto& n = mask.head.size;
  Box box{{n[0], n[1], n[2]}, {-1, -1, -1}};
  std::size_t at = 0;
  for (std::int64_t k = 0; k < n[2]; ++k)
    for (std::int64_t j = 0; j < n[1]; ++j)
      for (std::int64_t i = 0; i < n[0]; ++i) {
        if (mask.label[at++] != label) continue;
        const std::array<std::int64_t, 3> index{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], index[axis]);
          box.high[axis] = std::max(box.high[axis], index[axis]);
        }
      }
  return box;
}

}  // namespace

MaskSurface mask_surface(const std::string& file, Mask mask, std::optional<int> label) {
  MaskSurface out;
  out.label = chosen_label(file, mask, label);
  const Box box = box_of(mask, out.label);
  const auto& n = mask.head.size;
  std::array<int, 3> size;
  for (std::size_t k = 0; k < 3; ++k) {
    size[k] = static_cast<int>(box.high[k] - box.low[k] + 3);  // one voxel of background around
    if (box.low[k] == 0 || box.high[k] + 1 == n[k])
      out.notes = {"the label reaches the border of its image, which cuts it off there"};
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.data());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::int64_t k = box.low[2] - 1; k <= box.high[2] + 1; ++k)
    for (std::int64_t j = box.low[1] - 1; j <= box.high[1] + 1; ++j)
      for (std::int64_t i = box.low[0] - 1; i <= box.high[0] + 1; ++i) {
        const bool inside =
            i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2] &&
            mask.label[static_cast<std::size_t>((k * n[1] + j) * n[0] + i)] == out.label;
        *voxel++ = inside ? 1 : 0;
      }
  mask.label = {};
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.5);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* found = edges->GetOutput();
  const Vec3 corner(static_cast<double>(box.low[0] - 1), static_cast<double>(box.low[1] - 1),
                    static_cast<double>(box.low[2] - 1));
  out.surface.points.resize(found->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i) {
    Vec3 p;
    found->GetPoint(i, p.data());
    out.surface.points.row(i) = mask.head.origin + mask.head.step * (p + corner);
  }
  out.surface.triangles.resize(found->GetPolys()->GetNumberOfCells(), 3);
  const auto cells = vtk::TakeSmartPointer(found->GetPolys()->NewIterator());
  Eigen::Index t = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    for (int k = 0; k < 3; ++k) out.surface.triangles(t, k) = static_cast<int>(ids[k]);
    ++t;
  }
  out.voxel = std::cbrt(std::abs(mask.head.step.determinant()));
  return out;
}

}  // namespace vasorod
