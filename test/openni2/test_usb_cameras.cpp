// A folder made up as the system's own is.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "cameras/openni2/usb_cameras.hpp"

namespace polygonal_perception::openni2 {
namespace {

namespace fs = std::filesystem;

class UsbCameras : public testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/usb_cameras_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    root_ = name;
    fs::create_directories(root_ / "sys");
  }
  void TearDown() override { fs::remove_all(root_); }

  void plug(const std::string& vendor, const std::string& product) const
  {
    const fs::path device = root_ / "sys" / "3-2";
    fs::create_directories(device);
    std::ofstream(device / "idVendor") << vendor << "\n";
    std::ofstream(device / "idProduct") << product << "\n";
    std::ofstream(device / "busnum") << "3\n";
    std::ofstream(device / "devnum") << "18\n";
  }
  std::string described() const { return describeUsbCameras(root_ / "sys", root_ / "dev"); }

  fs::path root_;
};

TEST_F(UsbCameras, NoneIsPluggedIn)
{
  plug("046d", "c52b");
  EXPECT_NE(described().find("no camera"), std::string::npos) << described();
}

TEST_F(UsbCameras, OneThatMayNotBeOpenedNamesTheRule)
{
  plug("1d27", "0601");
  const std::string text = described();
  EXPECT_NE(text.find("1d27:0601 at " + (root_ / "dev/003/018").string() + " may not be opened"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("udev"), std::string::npos) << text;
}

TEST_F(UsbCameras, OneThatMayBeOpenedIsTakenBySomethingElse)
{
  plug("2bc5", "0401");
  fs::create_directories(root_ / "dev" / "003");
  std::ofstream(root_ / "dev" / "003" / "018") << "";
  EXPECT_NE(described().find("is there and may be opened"), std::string::npos) << described();
}

TEST_F(UsbCameras, AMissingFolderIsNoError)
{
  EXPECT_NE(describeUsbCameras("/nonexistent", "/nonexistent").find("no camera"), std::string::npos);
}

}  // namespace
}  // namespace polygonal_perception::openni2
