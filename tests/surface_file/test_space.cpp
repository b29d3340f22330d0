#include <gtest/gtest.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "scratch_folder.h"
#include "surface_file/read_polydata.h"
#include "surface_file/sample_surfaces.h"
#include "surface_file/space.h"

namespace vasorod {
namespace {

class Space : public ScratchFolder {
 protected:
  std::string text_of(const std::string& name) const {
    std::ifstream in(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
};

// As 3D Slicer does: VTK's writer with an array of one text in the field data.
TEST_F(Space, IsReadFromTheFieldDataThatVtkWritesInEveryMode) {
  write_vtp(folder / "plain.vtp", sample_tube());
  EXPECT_EQ(read_polydata(folder / "plain.vtp").space, "");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "plain.vtp").c_str());
  reader->Update();
  for (const std::string space : {"LPS", "RAS", "LAS"})
    for (const auto compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4})
      for (const auto order : {vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian})
        for (const Encoding encoding : {Encoding::ascii, Encoding::inline_binary,
                                        Encoding::appended_raw, Encoding::appended_base64}) {
          vtkNew<vtkPolyData> data;
          data->ShallowCopy(reader->GetOutput());
          for (const std::string name : {"Other", "SPACE"}) {
            vtkNew<vtkStringArray> array;
            array->SetName(name.c_str());
            array->InsertNextValue(name == "SPACE" ? space : std::string(9000, 'x'));
            data->GetFieldData()->AddArray(array);
          }
          vtkNew<vtkXMLPolyDataWriter> writer;
          writer->SetFileName((folder / "slicer.vtp").c_str());
          writer->SetInputData(data);
          writer->SetCompressorType(compressor);
          writer->SetByteOrder(order);
          set_encoding(*writer, encoding);
          writer->Write();
          const LoadedSurface loaded = read_polydata(folder / "slicer.vtp");
          EXPECT_EQ(loaded.space, space == "LAS" ? "" : space)
              << compressor << " " << order << " " << static_cast<int>(encoding);
          EXPECT_EQ(loaded.surface.triangles, sample_tube().triangles);
        }
}

TEST_F(Space, IsReadFromTheCommentsOfOtherFormats) {
  const std::string comment = "3D Slicer output. SPACE=LPS";
  write_stl(folder / "tube.stl", sample_tube(), false);
  std::string stl = text_of("tube.stl");
  ASSERT_GT(stl.size(), 84U);
  stl.replace(0, 80, comment + std::string(80 - comment.size(), ' '));
  EXPECT_EQ(read_polydata(write("binary.stl", stl)).space, "LPS");
  write_stl(folder / "tube.stl", sample_tube(), true);
  const std::string ascii = text_of("tube.stl");
  EXPECT_EQ(read_polydata(folder / "tube.stl").space, "");
  EXPECT_EQ(
      read_polydata(write("ascii.stl", "solid " + comment + ascii.substr(ascii.find('\n')))).space,
      "LPS");
  write_ply(folder / "tube.ply", sample_tube(), true);
  std::string ply = text_of("tube.ply");
  ply.insert(ply.find("element"), "comment SPACE=RAS\n");
  EXPECT_EQ(read_polydata(write("slicer.ply", ply)).space, "RAS");
  write_obj(folder / "tube.obj", sample_tube());
  EXPECT_EQ(read_polydata(write("slicer.obj", "# " + comment + "\n" + text_of("tube.obj"))).space,
            "LPS");
}

TEST_F(Space, OnlyTheTwoThatSlicerWritesAreKnown) {
  EXPECT_EQ(known_space("LPS"), "LPS");
  EXPECT_EQ(known_space("RAS"), "RAS");
  for (const std::string other : {"", "lps", "RASX", "scanner"}) EXPECT_EQ(known_space(other), "");
  EXPECT_EQ(space_in_head(write("short.obj", "SPACE=LP")), "");
  EXPECT_EQ(space_in_head(folder / "absent.obj"), "");
}

}  // namespace
}  // namespace vasorod
