#include <cstring>
#include <sys/resource.h>
#include <zlib.h>

#include <vasorod/error.h>

#include "mask/mask.h"
#include "mask/mask_surface.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

class ReadMask : public ScratchFolder {
 protected:
  void expect_refused(const std::string& name, const std::string& text, const std::string& words) {
    try {
      read_mask(write(name, text));
      ADD_FAILURE() << name << " was read: " << text.substr(0, 80);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_LT(std::string(error.what()).size(), 400U) << error.what();
    }
  }
};

// 2 x 3 x 4 voxels of which the last is 7.
std::string voxels() {
  std::string bytes(24, '\0');
  bytes.back() = 7;
  return bytes;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string packed(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out;
}

const std::string nrrd =
    "NRRD0004\n# a comment\ntype: uchar\ndimension: 3\nspace: right-anterior-superior\n"
    "sizes: 2 3 4\nspace directions: (0,0,2) (0,-1,0) (0.5,0,0)\nkinds: domain domain domain\n"
    "encoding: raw\nspace origin: (10,20,30)\nspace units: \"mm\" \"mm\" \"mm\"\n\n";
const std::string metaimage =
    "ObjectType = Image\nNDims = 3\nCompressedData = True\nTransformMatrix = 0 0 1 0 -1 0 1 0 0\n"
    "Offset = 10 20 30\nElementSpacing = 2 1 0.5\nDimSize = 2 3 4\nElementType = MET_UCHAR\n"
    "ElementDataFile = LOCAL\n";

std::string nifti(bool sform) {
  std::string head(352, '\0');
  const auto put = [&](std::size_t at, auto value) {
    std::memcpy(head.data() + at, &value, sizeof value);
  };
  put(0, std::int32_t{348});
  for (int k = 0; k < 4; ++k)
    put(40 + 2 * static_cast<std::size_t>(k), std::int16_t(k ? k + 1 : 3));
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  const float spacing[] = {-1, 2, 1, 0.5F};
  for (std::size_t k = 0; k < 4; ++k) put(76 + 4 * k, spacing[k]);
  put(108, 352.0F);
  head[123] = 2;
  put(252, std::int16_t{1});
  put(254, std::int16_t(sform ? 1 : 0));
  // qform: half a turn about y, (a b c d) = (0 0 1 0); x and z turn over, z again with qfac -1.
  put(260, 1.0F);
  const float origin[] = {10, 20, 30};
  for (std::size_t k = 0; k < 3; ++k) put(268 + 4 * k, origin[k]);
  const float rows[] = {-2, 0, 0, 10, 0, 1, 0, 20, 0, 0, 0.5F, 30};
  for (std::size_t k = 0; k < 12; ++k) put(280 + 4 * k, rows[k]);
  std::memcpy(head.data() + 344, "n+1", 4);
  return head + voxels();
}

TEST_F(ReadMask, EveryFormatPutsTheLastVoxelWhereItsHeaderSays) {
  const auto last = [](const Mask& mask) {
    return Vec3(mask.head.origin + mask.head.step * Vec3(1, 2, 3));
  };
  const Mask a = read_mask(write("a.nrrd", nrrd + voxels()));
  EXPECT_LT((last(a) - Vec3(11.5, 18, 32)).norm(), 1e-6);
  EXPECT_EQ(a.head.space, "RAS");
  EXPECT_EQ(a.head.unit, "mm");
  const Mask b = read_mask(write("b.mha", metaimage + packed(voxels())));
  EXPECT_LT((last(b) - Vec3(11.5, 18, 32)).norm(), 1e-6);
  EXPECT_EQ(b.head.space, "LPS");
  for (const bool sform : {true, false}) {
    const Mask c = read_mask(write("c.nii", nifti(sform)));
    EXPECT_LT((last(c) - Vec3(8, 22, 31.5)).norm(), 1e-6) << sform;
    EXPECT_EQ(c.head.space, "RAS");
    EXPECT_EQ(c.head.unit, "mm");
  }
  for (const Mask& mask : {a, b}) {
    EXPECT_EQ(mask.label.back(), 7);
    EXPECT_EQ(mask.count.size(), 1u);
  }
}

TEST_F(ReadMask, WhatIsNoMaskIsOneSentence) {
  expect_refused("a.nrrd", nrrd + voxels().substr(1), "fewer voxels than the header says");
  expect_refused("a.nrrd", "NRRD0004\n", "empty line");
  expect_refused("a.nrrd", "no", "does not begin with NRRD");
  expect_refused("a.mha", metaimage + packed(voxels()).substr(0, 5), "fewer voxels");
  expect_refused("a.mha", "NDims = 3\n", "without ElementDataFile");
  expect_refused("a.nii", nifti(true).substr(0, 100), "100 bytes");
  expect_refused("a.nii", std::string(400, 'x'), "does not begin as NIfTI-1");
  expect_refused("a.nii", nifti(true).substr(0, 360), "fewer voxels");
  expect_refused("a.nrrd", changed(nrrd, "2 3 4", "99999 99999 99999"),
                 "crop it around the vessel");
  expect_refused("a.nrrd", changed(nrrd, "2 3 4", "2 3.5 4") + voxels(), "expected three whole");
  expect_refused("a.nrrd", changed(nrrd, "(0.5,0,0)", "(0.0,0,0)") + voxels(), "span no volume");
  // What would shift, scale or mirror the mask is not passed over.
  expect_refused("a.nrrd", changed(nrrd, "type:", "byte skip: 8\ntype:") + voxels(), "byte skip");
  expect_refused("a.nrrd", changed(nrrd, "right-anterior-superior", "LAS") + voxels(),
                 "left-handed");
  expect_refused("a.mha", changed(metaimage, "NDims", "HeaderSize = -1\nNDims") + packed(voxels()),
                 "HeaderSize");
  std::string scaled = nifti(true);
  const float two = 2;
  std::memcpy(&scaled[112], &two, sizeof two);
  expect_refused("a.nii", scaled, "scaled (slope 2)");
  std::string values(96, '\0');
  values[3] = 0x3e;
  expect_refused("a.nrrd", changed(nrrd, "uchar", "float") + values, "not the image itself");
}

// The checksum of a packed file is at its end.
TEST_F(ReadMask, PackedVoxelsThatAreDamagedOrCutOffAreRefused) {
  std::string damaged = metaimage + packed(voxels());
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  expect_refused("a.mha", damaged, "damaged or cut off");
  damaged.pop_back();
  expect_refused("a.mha", damaged, "damaged or cut off");
}

// 800 MB of labels would be asked for 24 bytes of voxels.
TEST_F(ReadMask, AHeaderAloneCostsNoMemory) {
  const auto most = [] {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
  };
  const auto before = most();
  expect_refused("a.nrrd", changed(nrrd, "2 3 4", "1000 1000 200") + voxels(), "fewer voxels");
  expect_refused("a.nrrd", changed(changed(nrrd, "2 3 4", "1000 1000 200"), "raw", "ascii") + "1 2",
                 "expected 200000000 numbers");
  expect_refused("a.mha", changed(metaimage, "2 3 4", "1000 1000 200") + packed(voxels()),
                 "expected 200000000 voxels of 1 bytes");
  EXPECT_LT(most() - before, 100'000) << "kilobytes";
}

TEST_F(ReadMask, NumbersOfTheHeaderAreReadToTheirEnd) {
  for (const char* size : {"2 3 4 1e999", "2 3 4 -", "2 3 4 x", "2 3 1e999", "2 3"})
    expect_refused("a.nrrd", changed(nrrd, "2 3 4", size) + voxels(), "expected 3 numbers");
  const std::string channels = "ElementNumberOfChannels = " + std::string(900, '\x1b') + "\n";
  expect_refused("a.mha", channels + metaimage + packed(voxels()), "expected one label per voxel");
}

// Whatever the header's bytes are: a mask or a sentence.
TEST_F(ReadMask, ADamagedHeaderIsReadOrRefused) {
  int refused = 0;
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.nrrd", nrrd + voxels()},
                                   {"a.mha", metaimage + packed(voxels())},
                                   {"a.nii", nifti(true)}})
    for (std::size_t at = 0; at < text.size(); at += 3)
      for (const char byte : {'\0', '9', '\xff', '-'}) {
        std::string damaged = text;
        damaged[at] = byte;
        try {
          read_mask(write(name, damaged));
        } catch (const InputError&) {
          ++refused;
        }
      }
  EXPECT_GT(refused, 100);
}

TEST_F(ReadMask, SeveralLabelsAreListedAndOneIsChosen) {
  std::string bytes = voxels();
  bytes[0] = 2;
  const Mask mask = read_mask(write("a.nrrd", nrrd + bytes));
  const auto message = [&](std::optional<int> label, const Mask& of) -> std::string {
    try {
      mask_surface("a.nrrd", of, label);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_NE(message({}, mask).find("2 (1 voxel), 7 (1 voxel), expected --label"), std::string::npos)
      << message({}, mask);
  EXPECT_NE(message(5, mask).find("no voxel of label 5"), std::string::npos);
  EXPECT_EQ(message(7, mask), "");
  const Mask empty = read_mask(write("b.nrrd", nrrd + std::string(24, '\0')));
  EXPECT_NE(message({}, empty).find("no voxel other than 0"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
