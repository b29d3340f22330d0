// NIfTI-1 headers (Cox et al. 2004): 348 bytes, .nii or .nii.gz.
#include <bit>
#include <cmath>
#include <cstring>

#include "data/sentence.h"
#include "mask/mask.h"

namespace vasorod {
namespace {

template <class T>
T number_at(const std::string& head, std::size_t at, bool swapped) {
  std::array<char, sizeof(T)> bytes;
  for (std::size_t k = 0; k < sizeof(T); ++k)
    bytes[k] = head[at + (swapped ? sizeof(T) - 1 - k : k)];
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

std::string type_of(int code) {
  switch (code) {
    case 2:
      return "u1";
    case 4:
      return "i2";
    case 8:
      return "i4";
    case 16:
      return "f4";
    case 64:
      return "f8";
    case 256:
      return "i1";
    case 512:
      return "u2";
    case 768:
      return "u4";
    case 1024:
      return "i8";
    case 1280:
      return "u8";
    default:
      return {};
  }
}

// The rotation of the header's quaternion, with its third column turned for qfac -1.
Mat3 quaternion_axes(double b, double c, double d, double qfac) {
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  Mat3 r;
  r << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
      a * a + c * c - b * b - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
      a * a + d * d - b * b - c * c;
  if (qfac < 0) r.col(2) = -r.col(2).eval();
  return r;
}

}  // namespace

MaskHead read_nifti_head(const std::filesystem::path& file, const std::string& head) {
  if (head.size() < 348)
    refuse_mask(file, std::to_string(head.size()) + " bytes", "the 348 of a NIfTI header");
  const bool swapped = number_at<std::int32_t>(head, 0, false) != 348;
  if (swapped && number_at<std::int32_t>(head, 0, true) != 348)
    refuse_mask(file, "a file that does not begin as NIfTI-1 does", "a NIfTI-1 mask");
  if (head.compare(344, 3, "n+1") != 0)
    refuse_mask(file, "a NIfTI header without its voxels", "both in one file (.nii or .nii.gz)");
  const auto whole = [&](std::size_t at) { return number_at<std::int16_t>(head, at, swapped); };
  const auto real = [&](std::size_t at) {
    const double value = number_at<float>(head, at, swapped);
    if (!std::isfinite(value))
      refuse_mask(file, "a number of its header that is not finite", "a sound NIfTI header");
    return value;
  };
  MaskHead out;
  const int dimensions = whole(40);
  bool volume = dimensions >= 3 && dimensions <= 7;
  for (int k = 4; volume && k <= dimensions; ++k)
    volume = whole(40 + 2 * static_cast<std::size_t>(k)) <= 1;
  if (!volume) refuse_mask(file, "an image that is no single volume", "a mask of three dimensions");
  for (std::size_t k = 0; k < 3; ++k) out.size[k] = whole(42 + 2 * k);
  out.type = type_of(whole(70));
  if (out.type.empty())
    refuse_mask(file, "voxels of type " + std::to_string(whole(70)), "whole numbers");
  out.swapped = swapped;
  const double offset = real(108);
  if (offset < 348 || offset > 1e9)
    refuse_mask(file, "voxels that begin at byte " + number_text(offset), "byte 352 or later");
  out.at = static_cast<std::size_t>(offset);
  // What a voxel's value means: value * slope + intercept, unless the slope is 0 or not a number.
  const float slope = number_at<float>(head, 112, swapped);
  const float intercept = number_at<float>(head, 116, swapped);
  if (std::isfinite(slope) && slope != 0 && (slope != 1 || intercept != 0))
    refuse_mask(file, "voxels that are scaled (slope " + number_text(slope) + ")",
                "a mask, whose labels are the voxels themselves");
  Vec3 spacing(real(80), real(84), real(88));
  if (whole(254) > 0) {  // sform
    for (int row = 0; row < 3; ++row) {
      const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
      for (int k = 0; k < 3; ++k) out.step(row, k) = real(at + 4 * static_cast<std::size_t>(k));
      out.origin[row] = real(at + 12);
    }
    out.space = "RAS";
  } else if (whole(252) > 0) {  // qform
    out.step = quaternion_axes(real(256), real(260), real(264), real(76)) * spacing.asDiagonal();
    out.origin = {real(268), real(272), real(276)};
    out.space = "RAS";
  } else {
    out.step = spacing.cwiseAbs().asDiagonal();
  }
  const int unit = static_cast<unsigned char>(head[123]) & 7;
  out.unit = unit == 1 ? "m" : unit == 2 ? "mm" : unit == 3 ? "um" : "";
  out.data = file;
  return out;
}

}  // namespace vasorod
