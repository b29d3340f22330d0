// A segmentation's voxels and where they lie, as read from a NIfTI, NRRD or MetaImage file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// What the header of a mask says.
struct MaskHead {
  std::array<std::int64_t, 3> size{0, 0, 0};  ///< voxels, the first index is the fastest
  Mat3 step = Mat3::Identity();               ///< columns: from a voxel to the next, file's unit
  Vec3 origin = Vec3::Zero();                 ///< centre of the first voxel, file's unit
  std::string space;                          ///< LPS or RAS; empty: the file does not say
  std::string unit;                           ///< mm, cm, m or um; empty: the file does not say
  std::string type;      ///< u1 i1 u2 i2 u4 i4 u8 i8 f4 f8: kind and bytes of a voxel
  bool swapped = false;  ///< bytes are in the other order than this machine's
  enum class Packing { none, gzip, zlib, text } packing = Packing::none;
  std::filesystem::path data;  ///< file of the voxels
  std::size_t at = 0;          ///< where they begin in it, bytes
};

/// A mask: its labels are whole numbers, 0 is the background.
struct Mask {
  MaskHead head;
  std::vector<std::int32_t> label;             ///< one per voxel
  std::map<std::int32_t, std::int64_t> count;  ///< voxels of every label but 0
};

/// Whether the ending is that of a mask: .nii, .nii.gz, .nrrd, .nhdr, .mha or .mhd.
bool is_mask(const std::filesystem::path& file);

/// Reads a mask. Throws InputError (one sentence with the file) for a file that is missing,
/// damaged, no volume of whole numbers, or larger than the memory.
Mask read_mask(const std::filesystem::path& file);

// Each format's header. Not through VTK, whose readers drop the directions of the axes and crash on
// damaged headers. `head` is the beginning of the file, unpacked.
MaskHead read_nifti_head(const std::filesystem::path& file, const std::string& head);
MaskHead read_nrrd_head(const std::filesystem::path& file, const std::string& head);
MaskHead read_metaimage_head(const std::filesystem::path& file, const std::string& head);

/// Throws InputError "FILE: found FOUND, expected EXPECTED".
[[noreturn]] void refuse_mask(const std::filesystem::path& file, const std::string& found,
                              const std::string& expected);

/// All of `text` as finite numbers separated by blanks, commas or parentheses; refused if there are
/// not exactly `count`.
std::vector<double> header_numbers(const std::filesystem::path& file, const std::string& key,
                                   const std::string& text, std::size_t count);

/// The same of three numbers.
Vec3 header_vector(const std::filesystem::path& file, const std::string& key,
                   const std::string& text);

/// The same of nine: columns, one after the other.
Mat3 header_columns(const std::filesystem::path& file, const std::string& key,
                    const std::string& text);

/// Three sides of a volume, voxels; refused if they are not whole.
std::array<std::int64_t, 3> header_size(const std::filesystem::path& file, const std::string& key,
                                        const std::string& text);

/// Without the blanks at both ends.
std::string trimmed(const std::string& text);

}  // namespace vasorod
