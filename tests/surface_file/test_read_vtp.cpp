// The VTP reader by itself: what VTK writes, and heads and blocks that do not hold what they say.
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <vasorod/error.h>

#include "scratch_folder.h"
#include "surface_file/sample_surfaces.h"
#include "surface_file/surface_file.h"

namespace vasorod {
namespace {

class ReadVtp : public ScratchFolder {
 protected:
  std::string bytes(Encoding encoding) const {
    NamedArray radius{"Radius", sample_tube().points, false, ""};
    write_vtp(folder / "whole.vtp", sample_tube(), encoding, {radius});
    std::ifstream in(folder / "whole.vtp", std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  // With the first `from` behind `after` replaced; the sentence, or nothing where it is read.
  std::string refusal(std::string text, const std::string& after, const std::string& from,
                      const std::string& to) const {
    const std::size_t at = text.find(from, text.find(after));
    EXPECT_NE(at, std::string::npos) << after << " " << from;
    text.replace(at, from.size(), to);
    try {
      read_vtp(write("tube.vtp", text));
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }
};

constexpr std::array all_encodings{Encoding::ascii, Encoding::inline_binary, Encoding::appended_raw,
                                   Encoding::appended_base64, Encoding::zlib};

// A wavy sheet of triangles with an array of floats, larger than a few blocks.
vtkSmartPointer<vtkPolyData> sheet() {
  constexpr int n = 40;
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      points->InsertNextPoint(i, k, std::sin(0.1 * i * k));
      normals->InsertNextTuple3(i, 0.5, k);
      if (i == 0 || k == 0) continue;
      const vtkIdType a = n * i + k;
      cells->InsertNextCell({a - n - 1, a - 1, a});
      cells->InsertNextCell({a - n - 1, a, a - n});
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->AddArray(normals);
  return data;
}

TEST_F(ReadVtp, EveryCompressorHeaderOrderAndModeOfVtk) {
  const auto data = sheet();
  for (const auto compressor :
       {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA})
    for (const auto header : {vtkXMLWriter::UInt32, vtkXMLWriter::UInt64})
      for (const auto order : {vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian})
        for (const Encoding encoding : {Encoding::ascii, Encoding::inline_binary,
                                        Encoding::appended_raw, Encoding::appended_base64}) {
          const auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
          writer->SetFileName((folder / "sheet.vtp").c_str());
          writer->SetInputData(data);
          writer->SetCompressorType(compressor);
          writer->SetBlockSize(4096);  // several blocks, the last one smaller
          writer->SetHeaderType(header);
          writer->SetByteOrder(order);
          set_encoding(*writer, encoding);
          writer->Write();
          SCOPED_TRACE(std::to_string(compressor) + " " + std::to_string(header) + " " +
                       std::to_string(order) + " " + std::to_string(static_cast<int>(encoding)));
          SurfaceFile read;
          ASSERT_NO_THROW(read = read_vtp(folder / "sheet.vtp"));
          ASSERT_EQ(read.points.rows(), data->GetNumberOfPoints());
          ASSERT_EQ(read.polygons.size(), static_cast<std::size_t>(data->GetNumberOfPolys()));
          double at[3];
          for (Eigen::Index i = 0; i < read.points.rows(); ++i) {
            data->GetPoint(i, at);
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(read.points(i, k), at[k], 1e-6);
          }
          ASSERT_EQ(read.point_arrays.size(), 1U);
          EXPECT_EQ(read.point_arrays[0].name, "Normals");
          EXPECT_EQ(read.point_arrays[0].type, "Float32");
        }
}

TEST_F(ReadVtp, SeveralPiecesBecomeOne) {
  const auto data = sheet();
  const auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  writer->SetFileName((folder / "sheet.vtp").c_str());
  writer->SetInputData(data);
  writer->SetNumberOfPieces(3);
  writer->Write();
  const SurfaceFile read = read_vtp(folder / "sheet.vtp");
  // Data that cannot be cut into pieces are written whole as each of them.
  EXPECT_EQ(read.points.rows(), 3 * data->GetNumberOfPoints());
  EXPECT_EQ(read.polygons.size(), static_cast<std::size_t>(3 * data->GetNumberOfPolys()));
  for (const auto& polygon : read.polygons)
    for (const int id : polygon) ASSERT_TRUE(id >= 0 && id < read.points.rows());
  ASSERT_EQ(read.point_arrays.size(), 1U);
  EXPECT_EQ(read.point_arrays[0].values.rows(), read.points.rows());
}

TEST_F(ReadVtp, CellArraysOfPiecesFollowTheirCells) {
  const auto piece = [](const std::string& value) {
    return "<Piece NumberOfPoints='3' NumberOfPolys='1' NumberOfLines='1'>"
           "<CellData><DataArray type='Int32' Name='a &amp; &#x3c;'>" +
           value +
           "</DataArray></CellData>"
           "<Points><DataArray type='Float32' NumberOfComponents='3'>0 0 0 1 0 0 0 1 0"
           "</DataArray></Points>"
           "<Lines><DataArray type='Int32' Name='connectivity'>0 1</DataArray>"
           "<DataArray type='Int32' Name='offsets'>2</DataArray></Lines>"
           "<Polys><DataArray type='Int32' Name='connectivity'>0 1 2</DataArray>"
           "<DataArray type='Int32' Name='offsets'>3</DataArray></Polys></Piece>";
  };
  const SurfaceFile read =
      read_vtp(write("two.vtp", "<VTKFile type='PolyData'><PolyData>" + piece("1 2") +
                                    piece("3 4") + "</PolyData></VTKFile>"));
  EXPECT_EQ(read.skipped_cells, 2);
  EXPECT_EQ(read.lines, (std::vector<std::vector<int>>{{0, 1}, {3, 4}}));
  EXPECT_EQ(read.polygons, (std::vector<std::vector<int>>{{0, 1, 2}, {3, 4, 5}}));
  ASSERT_EQ(read.cell_arrays.size(), 1U);
  EXPECT_EQ(read.cell_arrays[0].name, "a & <");
  EXPECT_EQ(Eigen::VectorXd(read.cell_arrays[0].values), Eigen::Vector4d(1, 3, 2, 4));
}

TEST_F(ReadVtp, HeadsThatLieAreRefused) {
  for (const Encoding encoding : all_encodings) {
    SCOPED_TRACE(static_cast<int>(encoding));
    const std::string whole = bytes(encoding);
    EXPECT_EQ(refusal(whole, "", "VTKFile", "VTKFile"), "");
    const std::string components = "NumberOfComponents=\"3\"";
    const auto with = [&](const std::string& count) {
      return "NumberOfComponents=\"" + count + "\"";
    };
    for (const char* count : {"9223372036854775807", "99999999999999999999", "-3", "0", "4", "x"})
      for (const char* after : {"<PointData", "<Points"})
        EXPECT_NE(refusal(whole, after, components, with(count)).find("damaged or truncated"),
                  std::string::npos)
            << count;
    for (const char* count : {"505", "503", "2147483647", "2147483648", "-1", "9e9", ""})
      EXPECT_NE(refusal(whole, "", "NumberOfPoints=\"504\"",
                        "NumberOfPoints=\"" + std::string(count) + "\"")
                    .find("damaged or truncated"),
                std::string::npos)
          << count;
    for (const char* count : {"959", "961", "2147483647"})
      EXPECT_NE(refusal(whole, "", "NumberOfPolys=\"960\"",
                        "NumberOfPolys=\"" + std::string(count) + "\"")
                    .find("damaged or truncated"),
                std::string::npos)
          << count;
    for (const char* type : {"Int28", "String", "Float"})
      EXPECT_NE(refusal(whole, "<Points", "Float64", type).find("damaged or truncated"),
                std::string::npos)
          << type;
    EXPECT_NE(
        refusal(whole, "", "type=\"PolyData\"", "type=\"ImageData\"").find("of type \"ImageData\""),
        std::string::npos);
    EXPECT_NE(refusal(whole, "", "LittleEndian", "MiddleEndian").find("byte_order"),
              std::string::npos);
    EXPECT_NE(refusal(whole, "", "header_type=\"UInt32\"", "header_type=\"Int7\"").find("Int7"),
              std::string::npos);
    EXPECT_NE(refusal(whole, "<Points", "</Points>", "</Point>").find("closes nothing"),
              std::string::npos);
    EXPECT_NE(refusal(whole, "<Points", "format=\"", "format=\"x").find("the format \"x"),
              std::string::npos);
  }
}

TEST_F(ReadVtp, OffsetsBehindTheEndOrInTheMiddleAreRefused) {
  for (const Encoding encoding : {Encoding::appended_raw, Encoding::appended_base64}) {
    const std::string whole = bytes(encoding);
    for (const char* offset :
         {"99999999", "18446744073709551615", "18446744073709551616", "-1", "1", "7", "12107"})
      EXPECT_NE(refusal(whole, "", "offset=\"0\"", "offset=\"" + std::string(offset) + "\"")
                    .find("damaged or truncated"),
                std::string::npos)
          << offset;
  }
}

// A byte of the head, of the first blocks' headers or of the data is another one.
TEST_F(ReadVtp, AnyByteMayBeWrong) {
  for (const Encoding encoding : all_encodings) {
    const std::string whole = bytes(encoding);
    for (std::size_t at = 0; at < whole.size(); at += at < 600 ? 7 : 199)
      for (const char c : {'9', '\xff'}) {
        std::string text = whole;
        text[at] = c;
        try {
          const SurfaceFile read = read_vtp(write("tube.vtp", text));
          EXPECT_LE(read.points.rows(), 504);
        } catch (const InputError&) {
        }
      }
  }
}

}  // namespace
}  // namespace vasorod
