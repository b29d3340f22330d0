#include <cmath>
#include <cstring>
#include <limits>

#include "planner/mesh_message.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

// The number at a place of the bytes, as the page reads it: little-endian.
template <class Number>
Number at(const std::string& bytes, std::size_t place) {
  std::uint32_t raw = 0;
  for (int k = 3; k >= 0; --k)
    raw = raw << 8 | static_cast<unsigned char>(bytes[place + static_cast<std::size_t>(k)]);
  Number number{};
  static_assert(sizeof(number) == 4);
  std::memcpy(&number, &raw, 4);
  return number;
}

TEST(MeshMessage, BytesAreAsThePageReadsThem) {
  Points points(2, 3);
  points << 1.5, -2, 1e-3, 4, 5, 6;
  Triangles triangles(1, 3);
  triangles << 0, 1, 70000;
  Eigen::VectorXd field(2);
  field << 2, std::numeric_limits<double>::quiet_NaN();
  MeshMessage message;
  message.add("points", points);
  message.add("triangles", triangles);
  message.add("Pressure \xc3\xbc", field, 0.5);
  const std::string bytes = message.bytes();
  const auto length = at<std::uint32_t>(bytes, 0);
  EXPECT_EQ(length % 4, 0U);
  const Json arrays = Json::parse(bytes.substr(4, length)).at("arrays");
  ASSERT_EQ(arrays.size(), 3U);
  EXPECT_EQ(arrays[0].dump(),
            R"({"name":"points","type":"float32","components":3,"count":2,"offset":0})");
  EXPECT_EQ(arrays[1].dump(),
            R"({"name":"triangles","type":"uint32","components":3,"count":1,"offset":24})");
  EXPECT_EQ(arrays[2]["offset"], 36);
  ASSERT_EQ(bytes.size(), 4 + length + 36 + 8);
  const std::size_t data = 4 + length;
  EXPECT_EQ(at<float>(bytes, data), 1.5F);
  EXPECT_EQ(at<float>(bytes, data + 8), 1e-3F);
  EXPECT_EQ(at<float>(bytes, data + 20), 6.0F);
  EXPECT_EQ(at<std::uint32_t>(bytes, data + 32), 70000U);
  EXPECT_EQ(at<float>(bytes, data + 36), 1.0F);
  EXPECT_TRUE(std::isnan(at<float>(bytes, data + 40)));
}

using MeshMessageScene = SmallScene;

TEST_F(MeshMessageScene, AVesselThatIsNotThereIsSaid) {
  const auto scene = opened();
  EXPECT_EQ(refusal_of([&] { mesh_at_rest(*scene, "none"); }).status, 404);
  const std::string bytes = mesh_at_rest(*scene, "svc");
  const Json arrays = Json::parse(bytes.substr(4, at<std::uint32_t>(bytes, 0))).at("arrays");
  EXPECT_EQ(arrays[0]["count"], 24 * 51);
  EXPECT_EQ(arrays[1]["count"], 2 * 24 * 50);
}

}  // namespace
}  // namespace vasorod::planner
