#include <Eigen/LU>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <zlib.h>

#include <vasorod/error.h>

#include "data/limits.h"
#include "data/memory.h"
#include "data/sentence.h"
#include "mask/mask.h"

namespace vasorod {
namespace {

enum class Format { none, nifti, nrrd, metaimage };

Format format_of(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto ends = [&](const char* ending) { return name.ends_with(ending); };
  if (ends(".nii") || ends(".nii.gz")) return Format::nifti;
  if (ends(".nrrd") || ends(".nhdr")) return Format::nrrd;
  if (ends(".mha") || ends(".mhd")) return Format::metaimage;
  return Format::none;
}

// A file's bytes in order: as they are, or unpacked from gzip or zlib.
class Bytes {
 public:
  Bytes(const std::filesystem::path& file, std::size_t at, bool packed)
      : stream_(file, std::ios::binary), packed_(packed) {
    if (!stream_) refuse_mask(file, "no file that may be read", "the voxels");
    stream_.seekg(static_cast<std::streamoff>(at));
    if (packed_ && inflateInit2(&zip_, 15 + 32) != Z_OK) throw std::bad_alloc();
    open_ = packed_;
  }
  ~Bytes() {
    if (open_) inflateEnd(&zip_);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  // How many of `count` bytes there were.
  std::size_t read(char* to, std::size_t count) {
    if (!packed_) {
      stream_.read(to, static_cast<std::streamsize>(count));
      return static_cast<std::size_t>(stream_.gcount());
    }
    std::size_t got = 0;
    while (got < count && !ended_) {
      if (zip_.avail_in == 0) {
        stream_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        zip_.avail_in = static_cast<uInt>(stream_.gcount());
        zip_.next_in = reinterpret_cast<Bytef*>(buffer_.data());
        if (zip_.avail_in == 0) break;
      }
      const auto room =
          static_cast<uInt>(std::min<std::size_t>(count - got, std::numeric_limits<uInt>::max()));
      zip_.next_out = reinterpret_cast<Bytef*>(to + got);
      zip_.avail_out = room;
      const int status = inflate(&zip_, Z_NO_FLUSH);
      got += room - zip_.avail_out;
      ended_ = status != Z_OK;
      whole_ = status == Z_STREAM_END;
    }
    return got;
  }

  // Whether a packed file goes on, with at least `count` bytes, or ends as its checksum says.
  bool ends_well(char* to, std::size_t count) {
    return !packed_ || read(to, count) == count || whole_;
  }

 private:
  std::ifstream stream_;
  bool packed_, open_ = false, ended_ = false, whole_ = false;
  z_stream zip_{};
  std::vector<char> buffer_ = std::vector<char>(1 << 16);
};

bool begins_as_gzip(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream.get() == 0x1f && stream.get() == 0x8b;
}

template <class T>
double value_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double value_of(const std::string& type, const char* bytes) {
  if (type == "u1") return value_at<std::uint8_t>(bytes);
  if (type == "i1") return value_at<std::int8_t>(bytes);
  if (type == "u2") return value_at<std::uint16_t>(bytes);
  if (type == "i2") return value_at<std::int16_t>(bytes);
  if (type == "u4") return value_at<std::uint32_t>(bytes);
  if (type == "i4") return value_at<std::int32_t>(bytes);
  if (type == "u8") return value_at<std::uint64_t>(bytes);
  if (type == "i8") return value_at<std::int64_t>(bytes);
  if (type == "f4") return value_at<float>(bytes);
  return value_at<double>(bytes);
}

void check_head(const std::filesystem::path& file, const MaskHead& head) {
  double voxels = 1;
  for (const std::int64_t n : head.size) {
    if (n < 2)
      refuse_mask(file, "a side of " + std::to_string(n) + " voxels", "a volume of at least two");
    voxels *= static_cast<double>(n);
  }
  const double need = 5 * voxels;  // the labels and the box around the one that is used
  const double most = std::min(memory_limit().value_or(8e9) / 2, 4e10);
  if (need > most)
    refuse_mask(file,
                joined_text(head.size[0], " x ", head.size[1], " x ", head.size[2], " voxels"),
                "at most " + number_text(most / 5, 2) +
                    " for this machine's memory (crop it around the vessel)");
  double largest = head.origin.cwiseAbs().maxCoeff();
  for (int k = 0; k < 3; ++k)
    largest = std::max(largest, head.step.col(k).norm() *
                                    static_cast<double>(head.size[static_cast<std::size_t>(k)]));
  const Vec3 lengths = head.step.colwise().norm().transpose();
  if (!head.step.allFinite() || !(largest < largest_length) ||
      !(lengths.minCoeff() > smallest_length) ||
      std::abs(head.step.determinant()) < 1e-3 * lengths.prod())
    refuse_mask(file, "axes of the voxels that span no volume", "a spacing and three directions");
}

std::int32_t label_of(const std::filesystem::path& file, double value) {
  if (!(std::abs(value) < 2147483647) || value != std::nearbyint(value))
    refuse_mask(file, "a voxel of value " + number_text(value),
                "a mask, whose labels are whole numbers (not the image itself)");
  return static_cast<std::int32_t>(value);
}

bool is_packed(const MaskHead& head) {
  return head.packing == MaskHead::Packing::gzip || head.packing == MaskHead::Packing::zlib;
}

std::size_t bytes_of_voxel(const MaskHead& head) {
  return static_cast<std::size_t>(head.type[1] - '0');
}

[[noreturn]] void refuse_short(const std::filesystem::path& file, const MaskHead& head) {
  const std::string place =
      head.data == file ? "" : " in " + in_quotes(head.data.filename().string());
  const auto& n = head.size;
  const std::string voxels = std::to_string(n[0] * n[1] * n[2]);
  refuse_mask(file, "fewer voxels than the header says" + place,
              head.packing == MaskHead::Packing::text
                  ? voxels + " numbers"
                  : joined_text(voxels, " voxels of ", bytes_of_voxel(head), " bytes"));
}

// A header that promises more voxels than its file can hold must not cost the memory for them.
void check_data(const std::filesystem::path& file, const MaskHead& head) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(head.data, error))
    refuse_mask(file, "no file " + in_quotes(head.data.string()), "the voxels there");
  const auto bytes = static_cast<double>(std::filesystem::file_size(head.data, error));
  double voxels = 1;
  for (const std::int64_t n : head.size) voxels *= static_cast<double>(n);
  constexpr double most_packed = 1032;  // deflate makes at most as many bytes of one
  const auto at = static_cast<double>(head.at);
  const auto width = static_cast<double>(bytes_of_voxel(head));
  const bool enough = head.packing == MaskHead::Packing::text ? at + 2 * voxels - 1 <= bytes
                      : is_packed(head) ? voxels * width <= most_packed * bytes
                                        : at + voxels * width <= bytes;
  if (error || !enough) refuse_short(file, head);
}

void read_numbers(const std::filesystem::path& file, Mask& mask) {
  const MaskHead& head = mask.head;
  const std::size_t width = bytes_of_voxel(head);
  const bool packed = is_packed(head);
  // In a packed NIfTI the header is packed too; in NRRD and MetaImage only the voxels are.
  const bool whole = format_of(file) == Format::nifti;
  Bytes bytes(head.data, whole ? 0 : head.at, packed);
  std::vector<char> chunk(width << 16);
  for (std::size_t skip = whole ? head.at : 0; skip > 0;) {
    const std::size_t part = std::min(skip, chunk.size());
    if (bytes.read(chunk.data(), part) < part) break;
    skip -= part;
  }
  const std::size_t total = mask.label.size();
  for (std::size_t i = 0; i < total;) {
    const std::size_t want = std::min(total - i, chunk.size() / width);
    if (bytes.read(chunk.data(), want * width) < want * width) refuse_short(file, head);
    for (std::size_t k = 0; k < want; ++k) {
      char* voxel = chunk.data() + k * width;
      if (head.swapped) std::reverse(voxel, voxel + width);
      mask.label[i++] = label_of(file, value_of(head.type, voxel));
    }
  }
  if (!bytes.ends_well(chunk.data(), chunk.size()))
    refuse_mask(file, "packed voxels that are damaged or cut off at their end", "a sound file");
}

void read_text(const std::filesystem::path& file, Mask& mask) {
  std::ifstream stream(mask.head.data, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(mask.head.at));
  for (std::int32_t& label : mask.label) {
    double value = 0;
    if (!(stream >> value)) refuse_short(file, mask.head);
    label = label_of(file, value);
  }
}

}  // namespace

void refuse_mask(const std::filesystem::path& file, const std::string& found,
                 const std::string& expected) {
  throw InputError(one_line(file.string()) + ": found " + found + ", expected " + expected);
}

std::vector<double> header_numbers(const std::filesystem::path& file, const std::string& key,
                                   const std::string& text, std::size_t count) {
  std::string plain = text;
  for (char& c : plain)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  std::istringstream stream(plain);
  std::vector<double> values;
  bool sound = true;  // a number out of range, or a sign alone, fails at the end of the text too
  while (sound && !(stream >> std::ws).eof()) {
    double value = 0;
    sound = static_cast<bool>(stream >> value);
    values.push_back(value);
  }
  if (values.size() != count || !sound)
    refuse_mask(file, key + " " + in_quotes(text), std::to_string(count) + " numbers");
  return values;
}

Vec3 header_vector(const std::filesystem::path& file, const std::string& key,
                   const std::string& text) {
  const auto values = header_numbers(file, key, text, 3);
  return {values[0], values[1], values[2]};
}

Mat3 header_columns(const std::filesystem::path& file, const std::string& key,
                    const std::string& text) {
  return Mat3(header_numbers(file, key, text, 9).data());
}

std::array<std::int64_t, 3> header_size(const std::filesystem::path& file, const std::string& key,
                                        const std::string& text) {
  std::array<std::int64_t, 3> size{};
  const Vec3 values = header_vector(file, key, text);
  for (int k = 0; k < 3; ++k) {
    if (!(values[k] >= 0 && values[k] < 1e9) || values[k] != std::floor(values[k]))
      refuse_mask(file, key + " " + in_quotes(text), "three whole numbers of voxels");
    size[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(values[k]);
  }
  return size;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

bool is_mask(const std::filesystem::path& file) {
  return format_of(file) != Format::none;
}

Mask read_mask(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) refuse_mask(file, "no such file", "a mask");
  if (!std::filesystem::is_regular_file(file, ignored))
    refuse_mask(file, "a folder or device", "a mask");
  const Format format = format_of(file);
  const bool packed = format == Format::nifti && begins_as_gzip(file);
  std::string beginning(1 << 16, '\0');
  beginning.resize(Bytes(file, 0, packed).read(beginning.data(), beginning.size()));
  Mask mask;
  mask.head = format == Format::nifti  ? read_nifti_head(file, beginning)
              : format == Format::nrrd ? read_nrrd_head(file, beginning)
                                       : read_metaimage_head(file, beginning);
  if (packed) mask.head.packing = MaskHead::Packing::gzip;
  check_head(file, mask.head);
  check_data(file, mask.head);
  mask.label.resize(
      static_cast<std::size_t>(mask.head.size[0] * mask.head.size[1] * mask.head.size[2]));
  if (mask.head.packing == MaskHead::Packing::text)
    read_text(file, mask);
  else
    read_numbers(file, mask);
  constexpr std::size_t most_labels = 10000;
  for (const std::int32_t label : mask.label) {
    if (label == 0) continue;
    ++mask.count[label];
    if (mask.count.size() > most_labels)
      refuse_mask(file, "more than 10000 different values", "a mask, not the image itself");
  }
  return mask;
}

}  // namespace vasorod
