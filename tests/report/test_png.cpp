#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "report/picture.h"

namespace vasorod {
namespace {

Picture noise(int width, int height) {
  std::mt19937 random(2);
  Picture picture{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i)
    picture.rgba.push_back(static_cast<std::uint8_t>(random()));
  return picture;
}

// VTK decodes with libpng.
void expect_read_back(const Picture& picture) {
  const std::string bytes = png_bytes(picture);
  vtkNew<vtkPNGReader> reader;
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], picture.width);
  ASSERT_EQ(image->GetDimensions()[1], picture.height);
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 4);
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column)
      for (int k = 0; k < 4; ++k)
        ASSERT_EQ(image->GetScalarComponentAsDouble(column, picture.height - 1 - row, 0, k),
                  picture.rgba[static_cast<std::size_t>(4 * (row * picture.width + column) + k)]);
}

TEST(Png, ReadsBackFromLibpng) {
  expect_read_back(noise(120, 90));
  expect_read_back(noise(1, 1));
  expect_read_back(noise(7, 300));
  expect_read_back({50, 40, std::vector<std::uint8_t>(4 * 50 * 40, 200)});
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// Bit by bit, as ISO 15948 defines the sum.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) crc = (crc & 1U) ? 0xEDB88320U ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

TEST(Png, HasThreeChunksWithTheirSums) {
  const std::string bytes = png_bytes(noise(31, 17));
  ASSERT_EQ(bytes.substr(0, 8), std::string("\x89PNG\r\n\x1A\n", 8));
  std::string names;
  std::size_t at = 8;
  while (at < bytes.size()) {
    const std::size_t length = number_at(bytes, at);
    ASSERT_LE(at + length + 12, bytes.size());
    const std::string body = bytes.substr(at + 4, length + 4);
    names += body.substr(0, 4) + " ";
    EXPECT_EQ(number_at(bytes, at + 8 + length), crc_of(body)) << names;
    at += length + 12;
  }
  EXPECT_EQ(at, bytes.size());
  EXPECT_EQ(names, "IHDR IDAT IEND ");
  EXPECT_EQ(number_at(bytes, 16), 31u);
  EXPECT_EQ(number_at(bytes, 20), 17u);
}

}  // namespace
}  // namespace vasorod
