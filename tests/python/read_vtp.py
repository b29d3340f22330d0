"""Reads a VTP file through VTK, the second reader: an oracle for the arrays of a result."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def arrays_of(data):
    """name -> array of a vtkPointData or vtkCellData."""
    return {
        data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))
        for k in range(data.GetNumberOfArrays())
    }


def read(path):
    """(points, cells as a list of point numbers, point arrays, cell arrays)."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    cells = data.GetPolys() if data.GetNumberOfPolys() else data.GetLines()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    numbers = vtk_to_numpy(cells.GetConnectivityArray())
    return (
        vtk_to_numpy(data.GetPoints().GetData()),
        [numbers[a:b] for a, b in zip(offsets, offsets[1:])],
        arrays_of(data.GetPointData()),
        arrays_of(data.GetCellData()),
    )
