#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "extracted_scene.hpp"
#include "perception/segmentation/plane_identities.hpp"

namespace polygonal_perception::perception {
namespace {

using test::around;
using test::ExtractedScene;

/// A board straight ahead: samples of the grid that it covers, and how far away it is.
struct Board
{
  int left, right, top, bottom;
  float distance = 1.0F;
};

/// Gives ids to the pieces of frames.
class Identities
{
public:
  /// @return the ids of the boards, 0: it is in no piece
  std::vector<std::uint32_t> see(const std::vector<Board>& boards, double id_angle = 0.35)
  {
    test::PlaneScene scene;
    for (const Board& board : boards)
      paint(scene, around(board.left, board.right, board.top, board.bottom), board.distance);
    const ExtractedScene seen(scene);
    std::vector<SegmentedPlane> planes;
    for (const PlanePieces::Piece& piece : seen.pieces.pieces()) {
      planes.emplace_back().plane = seen.extraction.planes()[piece.plane].fit.plane;
      planes.back().plane.normal = turn_ * planes.back().plane.normal;
    }
    identities_.assign(seen.extraction.samples(), seen.pieces, id_angle, planes);
    std::vector<std::uint32_t> ids;
    for (const Board& board : boards) ids.push_back(idAt(seen, planes, board));
    return ids;
  }

  /// Turns the planes of the frames that follow.
  void turn(double angle) { turn_ = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()); }
  void reset() { identities_.reset(); }

private:
  static std::uint32_t idAt(const ExtractedScene& seen, const std::vector<SegmentedPlane>& planes,
                            const Board& board)
  {
    const std::size_t middle = seen.sampleAt((board.left + board.right) / 2, (board.top + board.bottom) / 2);
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const PlanePieces::Piece& piece = seen.pieces.pieces()[p];
      const auto first = seen.pieces.cells().begin() + piece.first;
      if (std::find(first, first + piece.size, middle) != first + piece.size) return planes[p].id;
    }
    return 0;
  }

  PlaneIdentities identities_;
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
};

using Ids = std::vector<std::uint32_t>;

const Board kLeft{2, 9, 8, 20};
const Board kRight{20, 29, 8, 20, 1.5F};

Board moved(Board board, int right, int down)
{
  return {board.left + right, board.right + right, board.top + down, board.bottom + down, board.distance};
}

TEST(PlaneIdentities, TheFirstAreNumberedFromOne)
{
  Identities identities;
  Ids ids = identities.see({kLeft, kRight});
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (Ids{1, 2}));
}

TEST(PlaneIdentities, WhatStaysKeepsItsId)
{
  Identities identities;
  const Ids first = identities.see({kLeft, kRight});
  for (int frame = 1; frame < 4; ++frame)
    EXPECT_EQ(identities.see({kLeft, kRight}), first) << "frame " << frame;
}

TEST(PlaneIdentities, WhatMovesSlowlyKeepsItsId)
{
  Identities identities;
  const Ids first = identities.see({kLeft, kRight});
  for (int frame = 1; frame <= 10; ++frame) {
    const int down = frame % 2;
    EXPECT_EQ(identities.see({moved(kLeft, frame, down), moved(kRight, -frame / 4, down)}), first)
        << "frame " << frame;
  }
}

TEST(PlaneIdentities, WhatIsNarrowMayMoveByItsWidth)
{
  // Two rows of samples, and then the next two.
  const Board shelf{4, 27, 10, 11};
  Identities identities;
  const Ids first = identities.see({shelf});
  ASSERT_NE(first[0], 0U);
  EXPECT_EQ(identities.see({moved(shelf, 0, 2)}), first);
}

TEST(PlaneIdentities, WhatAppearsElsewhereIsNew)
{
  Identities identities;
  EXPECT_EQ(identities.see({kLeft}), Ids{1});
  EXPECT_EQ(identities.see({kRight}), Ids{2});
}

TEST(PlaneIdentities, AnIdIsNotGivenAgainAfterItsPlaneHasGone)
{
  Identities identities;
  std::set<std::uint32_t> given;
  for (int time = 0; time < 5; ++time) {
    const Ids ids = identities.see({kLeft});
    EXPECT_TRUE(given.insert(ids[0]).second) << "id " << ids[0] << " again, the " << time << "th time";
    identities.see({});
  }
  EXPECT_EQ(given.size(), 5U);
}

TEST(PlaneIdentities, ANewPlaneDoesNotTakeTheIdOfOneThatStays)
{
  Identities identities;
  const Ids first = identities.see({kRight});
  // It is on the left, and so before the other in the list.
  const Ids second = identities.see({kLeft, kRight});
  EXPECT_EQ(second[1], first[0]);
  EXPECT_EQ(second[0], 2U);
  EXPECT_EQ(identities.see({kRight}), first) << "the other has gone";
}

TEST(PlaneIdentities, TheOrderOfThePiecesDoesNotMatter)
{
  Identities identities;
  const Ids first = identities.see({kLeft, kRight});
  // Planes are listed in the order in which their first samples come: now the right one is higher.
  const Board higher = moved(kRight, 0, -3);
  EXPECT_EQ(identities.see({kLeft, higher}), first);
  EXPECT_EQ(identities.see({moved(kLeft, 0, -5), higher}), first);
}

TEST(PlaneIdentities, WhatFacesAnotherWayIsNew)
{
  Identities identities;
  const Ids first = identities.see({kLeft});
  identities.turn(0.3);
  EXPECT_EQ(identities.see({kLeft}), first) << "turned by 0.3 rad since the last frame";
  identities.turn(0.6);
  EXPECT_EQ(identities.see({kLeft}), first) << "by 0.6 since the first";
  identities.turn(1.0);
  EXPECT_EQ(identities.see({kLeft}), Ids{2}) << "by 0.4 since the last frame";
  identities.turn(1.3);
  EXPECT_EQ(identities.see({kLeft}, 0.2), Ids{3}) << "by more than is allowed now";
}

TEST(PlaneIdentities, WhatGrowsTogetherHasTheIdOfTheLargerPart)
{
  const Board small{4, 9, 8, 20};
  const Board large{12, 27, 8, 20};
  const Board whole{4, 27, 8, 20};
  Identities identities;
  const Ids parts = identities.see({small, large});
  ASSERT_NE(parts[0], parts[1]);
  EXPECT_EQ(identities.see({whole}), Ids{parts[1]});
}

TEST(PlaneIdentities, OfWhatFallsApartTheLargerPartKeepsTheId)
{
  const Board small{4, 9, 8, 20};
  const Board large{12, 27, 8, 20};
  Identities identities;
  const Ids whole = identities.see({{4, 27, 8, 20}});
  const Ids parts = identities.see({small, large});
  EXPECT_EQ(parts[1], whole[0]);
  EXPECT_EQ(parts[0], 2U) << "the other is new";
}

TEST(PlaneIdentities, AfterAResetAllAreNew)
{
  Identities identities;
  const Ids first = identities.see({kLeft, kRight});
  identities.reset();
  Ids second = identities.see({kLeft, kRight});
  std::sort(second.begin(), second.end());
  EXPECT_EQ(second, (Ids{3, 4})) << "after " << first[0] << " and " << first[1];
  identities.reset();
  identities.reset();
  EXPECT_EQ(identities.see({kLeft}), Ids{5});
}

TEST(PlaneIdentities, AGridOfAnotherSizeHasNewOnes)
{
  PlaneIdentities identities;
  const auto see = [&](std::uint32_t width, std::uint32_t height) {
    test::PlaneScene scene(width, height, 20.0);
    scene.add(test::wallAt(1.0));
    const ExtractedScene seen(scene);
    std::vector<SegmentedPlane> planes(seen.pieces.pieces().size());
    for (SegmentedPlane& plane : planes) plane.plane = test::wallAt(1.0);
    identities.assign(seen.extraction.samples(), seen.pieces, 0.35, planes);
    return planes.empty() ? 0U : planes[0].id;
  };
  EXPECT_EQ(see(20, 16), 1U);
  EXPECT_EQ(see(20, 16), 1U);
  EXPECT_EQ(see(20, 15), 2U);
  EXPECT_EQ(see(24, 24), 3U);
}

}  // namespace
}  // namespace polygonal_perception::perception
