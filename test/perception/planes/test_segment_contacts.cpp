#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "perception/planes/segment_contacts.hpp"

namespace polygonal_perception::perception {
namespace {

/// Samples a metre apart on a level plane, row by row; a letter names the segment of each, '.' none.
struct Drawn
{
  explicit Drawn(const std::vector<std::string>& rows)
  {
    samples.columns = static_cast<std::uint32_t>(rows[0].size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t i = 0; i < rows[j].size(); ++i) {
        NoisySample sample;
        sample.point = Eigen::Vector3f(static_cast<float>(i), static_cast<float>(j), 0.0F);
        sample.normal = Eigen::Vector3f::UnitZ();
        sample.has_point = true;
        sample.begins_row = i == 0;
        sample.ends_row = i + 1 == rows[j].size();
        samples.all.push_back(sample);
        const int segment = rows[j][i] == '.' ? PlaneSegments::kNone : rows[j][i] - 'a';
        segments.of_sample.push_back(segment);
        segments.all.resize(std::max(segments.all.size(), static_cast<std::size_t>(segment + 1)));
      }
    }
    contacts.find(samples, segments);
  }

  NoisySamples samples;
  PlaneSegments segments;
  SegmentContacts contacts;
};

TEST(SegmentContacts, TheMiddleLiesBetweenTheSamplesOnBothSides)
{
  const Drawn drawn({"aabb",  //
                     "aabb",  //
                     "aabb"});
  ASSERT_TRUE(drawn.contacts.middle(0, 1));
  EXPECT_EQ(*drawn.contacts.middle(0, 1), Eigen::Vector3d(1.5, 1.0, 0.0));
  EXPECT_EQ(*drawn.contacts.middle(1, 0), Eigen::Vector3d(1.5, 1.0, 0.0)) << "from the other side";
}

TEST(SegmentContacts, AlsoOneAboveTheOther)
{
  const Drawn drawn({"aaa",  //
                     "bbb"});
  ASSERT_TRUE(drawn.contacts.middle(0, 1));
  EXPECT_EQ(*drawn.contacts.middle(0, 1), Eigen::Vector3d(1.0, 0.5, 0.0));
}

TEST(SegmentContacts, OverAGapOrACornerSegmentsDoNotTouch)
{
  const Drawn drawn({"aa.bb",  //
                     "aa.bb",  //
                     "..c.."});
  EXPECT_FALSE(drawn.contacts.middle(0, 1));
  EXPECT_FALSE(drawn.contacts.middle(0, 2)) << "corner to corner";
}

TEST(SegmentContacts, TheEndOfARowDoesNotTouchTheBeginningOfTheNext)
{
  const Drawn drawn({"..a",  //
                     "b.."});
  EXPECT_FALSE(drawn.contacts.middle(0, 1));
}

TEST(SegmentContacts, WhatHasJoinedTouchesWhatItsPartsTouched)
{
  Drawn drawn({"abc",  //
               "abc"});
  ASSERT_FALSE(drawn.contacts.middle(0, 2));
  drawn.contacts.join(1, 0);
  ASSERT_TRUE(drawn.contacts.middle(0, 2)) << "by way of b";
  EXPECT_EQ(*drawn.contacts.middle(0, 2), Eigen::Vector3d(1.5, 0.5, 0.0));
}

TEST(SegmentContacts, BothBordersOfWhatHasJoinedCount)
{
  Drawn drawn({"ac",  //
               "bc"});
  drawn.contacts.join(1, 0);
  EXPECT_EQ(*drawn.contacts.middle(0, 2), Eigen::Vector3d(0.5, 0.5, 0.0));
}

TEST(SegmentContacts, NothingOfTheLastFrameIsLeft)
{
  Drawn drawn({"ab"});
  drawn.segments.of_sample = {0, PlaneSegments::kNone};
  drawn.contacts.find(drawn.samples, drawn.segments);
  EXPECT_FALSE(drawn.contacts.middle(0, 1));
}

TEST(SegmentContacts, BeforeTheFirstFrameNothingTouches)
{
  EXPECT_FALSE(SegmentContacts().middle(0, 1));
}

}  // namespace
}  // namespace polygonal_perception::perception
