// Damaged files: each is read or refused with one sentence, whichever byte is wrong.
#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "scratch_folder.h"
#include "surface_file/read_surface.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

class DamagedFiles : public ScratchFolder {
 protected:
  static std::string contents(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  // Damages the file in `rounds` ways and returns the number of refused files.
  int damage(const std::string& name) const {
    const std::string whole = contents(folder / name);
    const std::string damaged = "damaged" + std::filesystem::path(name).extension().string();
    std::mt19937 random(7);
    auto pick = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
    int refused = 0;
    ::testing::internal::CaptureStderr();
    for (int round = 0; round < rounds; ++round) {
      std::string text = whole;
      // Half of the damage is in the header, which contains sizes and types.
      const size_t reach = round % 2 == 0 ? std::min<size_t>(600, text.size()) : text.size();
      for (size_t k = 0; k <= pick(3); ++k) {
        const size_t at = pick(std::min(reach, text.size()));
        switch (pick(4)) {
          case 0:
            text[at] = static_cast<char>(pick(256));
            break;
          case 1:
            text.erase(at, 1 + pick(20));
            break;
          case 2:
            text[at] = static_cast<char>('0' + pick(10));
            break;
          default:
            text.resize(at + 1);
            break;
        }
        if (text.empty()) break;
      }
      const auto file = write(damaged, text);
      try {
        load_surface(vessel_of(file), Scene());
      } catch (const InputError& error) {
        ++refused;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      } catch (const std::exception& error) {
        ADD_FAILURE() << name << " round " << round << ": " << error.what();
      }
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    return refused;
  }
  static constexpr int rounds = 60;
};

TEST_F(DamagedFiles, Vtp) {
  for (const Encoding encoding : {Encoding::ascii, Encoding::inline_binary, Encoding::appended_raw,
                                  Encoding::appended_base64, Encoding::zlib}) {
    write_vtp(folder / "tube.vtp", sample_tube(), encoding);
    EXPECT_GT(damage("tube.vtp"), rounds / 4);
  }
}

TEST_F(DamagedFiles, Stl) {
  for (const bool ascii : {true, false}) {
    write_stl(folder / "tube.stl", sample_tube(), ascii);
    EXPECT_GT(damage("tube.stl"), rounds / 4);
  }
}

TEST_F(DamagedFiles, Ply) {
  for (const bool ascii : {true, false}) {
    write_ply(folder / "tube.ply", sample_tube(), ascii);
    EXPECT_GT(damage("tube.ply"), rounds / 4);
  }
}

TEST_F(DamagedFiles, Obj) {
  write_obj(folder / "tube.obj", sample_tube());
  EXPECT_GT(damage("tube.obj"), rounds / 4);
}

}  // namespace
}  // namespace vasorod
