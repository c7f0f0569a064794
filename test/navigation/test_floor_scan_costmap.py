#!/usr/bin/env python3
"""The node's ~scan in a real costmap_2d with config/costmap_scan.yaml, while the camera sways and tf does not know of it.

The camera stands on a body that leans by up to 7 degrees to the front and to the side, about base_link on the floor, as a
walking robot's does. tf says all the time that it stands upright.
"""
import itertools
import math
import os
import sys
import time
import unittest

import numpy as np
import rospy
import rostest
from tf2_msgs.msg import TFMessage

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'ros'))
import scene  # noqa: E402
from costmap import Costmap  # noqa: E402
from node_client import FOUND, NOT_FOUND, NodeClient  # noqa: E402

DEADLINE = 15.0  # [s] for what ten frames show at once
FRAMES = 100  # of a walk
PERIOD = 0.05  # [s] from frame to frame
SWAY = math.radians(7.0)
NEAR = 2.5  # [m] ahead of the camera, where no floor may be marked
HEIGHT, PITCH, AHEAD = 0.8, 0.35, 0.1  # [m, rad, m] the camera on base_link

YAW, ROBOT = 0.7, np.array([3.02, -1.97])  # where base_link is in odom, all the time
TURN = np.array([[math.cos(YAW), -math.sin(YAW), 0], [math.sin(YAW), math.cos(YAW), 0], [0, 0, 1]])


def leaning(roll, pitch):
    cr, sr, cp, sp = math.cos(roll), math.sin(roll), math.cos(pitch), math.sin(pitch)
    return np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])


class SwayingCamera(scene.Camera):
    """In base_link's place when it is upright."""

    def __init__(self, roll=0.0, pitch=0.0):
        super().__init__(HEIGHT, PITCH, width=320, rows=240, focal_length=284.0)
        lean = leaning(roll, pitch)
        self.rotation = lean @ self.rotation
        self.position = lean @ (self.position + [AHEAD, 0, 0])
        self.height = self.position[2]

    def measure(self, random, *seen):
        """A depth image with an Xtion's noise."""
        depth = self.render(*seen)
        return depth + random.standard_normal(depth.shape) * (0.0012 + 0.0019 * np.maximum(depth - 0.4, 0.0) ** 2)


def walk():
    """Cameras whose roll and pitch do not repeat themselves within 299 frames."""
    for frame in itertools.count():
        yield SwayingCamera(SWAY * math.sin(math.tau * frame / 23), SWAY * math.sin(math.tau * frame / 13))


def in_odom(points):
    points = np.reshape(points, (-1, 2))
    return points @ TURN[:2, :2].T + ROBOT


def sides(box):
    """Points on the sides of a box, nearer to one another than cells, in odom."""
    steps = np.linspace(0.0, 1.0, 21)
    (x0, y0), (x1, y1) = box.low[:2], box.high[:2]
    return in_odom([(x0 + u * (x1 - x0), y0 + v * (y1 - y0)) for u in steps for v in steps if {u, v} & {0.0, 1.0}])


def front(box):
    """Points on the side that faces the robot, in odom."""
    return in_odom([(box.low[0], y) for y in np.linspace(box.low[1] + 0.02, box.high[1] - 0.02, 9)])


# One is low, the other so high that it hides all behind it. Both are in view in each frame of the walk.
LOW = scene.Box((1.55, 1.75), (-0.35, -0.05), (0, 0.12))
HIGH = scene.Box((2.10, 2.40), (0.15, 0.55), (0, 0.50))
BOXES = [LOW, HIGH]
FRONTS = np.concatenate([front(box) for box in BOXES])
SIDES = np.concatenate([sides(box) for box in BOXES])
# It fills the view of each frame.
WALL = scene.Box((0.55, 0.65), (-9, 9), (-9, 9))


class FloorScanCostmapTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.static_tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        upright = SwayingCamera()
        cls.static_tf.publish(TFMessage([
            scene.transform('odom', 'base_link', (*ROBOT, 0), TURN),
            scene.transform('base_link', scene.OPTICAL_FRAME, upright.position, upright.rotation)]))
        cls.client = NodeClient(outputs=('floor', 'scan'), depth=True)
        cls.costmap = Costmap(cls.client)
        cls.client.wait_for(lambda: '/costmap_node' in cls.readers_of_scan(), 'the costmap to read the scan')
        cls.random = np.random.default_rng(1)

    @staticmethod
    def readers_of_scan():
        return dict(rospy.get_master().getSystemState()[2][1]).get('/polygonal_perception/scan', [])

    def setUp(self):
        self.cameras = walk()
        self.clear()

    def send(self, boxes, floor=True):
        """The next frame of the walk; returns its stamp."""
        camera = next(self.cameras)
        depth, stamp = camera.measure(self.random, boxes, floor), rospy.Time.now()
        self.client.send(camera.info(stamp), camera.image(depth, stamp))
        return stamp

    def show(self, boxes, condition, what, floor=True):
        """Sends frames until condition(stamps of all of them) gives something, and returns it."""
        stamps, sent = [], [0.0]

        def result():
            if time.monotonic() - sent[0] > PERIOD:
                sent[0] = time.monotonic()
                stamps.append(self.send(boxes, floor))
            return condition(stamps)
        try:
            return self.client.wait_for(result, what, DEADLINE)
        except AssertionError as error:
            raise AssertionError('%s, in %d frames; the costmap has %s' % (error, len(stamps), self.costmap.grid))

    def show_until_map(self, boxes, condition, what, floor=True):
        begin = rospy.Time.now()

        def grid(_):
            newest = self.costmap.grid
            return newest if newest.stamp > begin and condition(newest) else None
        return self.show(boxes, grid, what, floor)

    def clear(self):
        """By the bare floor. What the rays of one frame miss those of the next do not: the camera's place sways, too."""
        return self.show_until_map([], lambda grid: len(grid.marks) == 0, 'an empty map')

    def mark(self):
        return self.show_until_map(BOXES, lambda grid: grid.are_marked(FRONTS).all(), 'marks at the boxes')

    def walk_before(self, boxes):
        """Shows FRAMES frames; returns the scans, and the maps that were made meanwhile."""
        begin = rospy.Time.now()

        def answers(stamps):
            answered = [self.client.answers.get(stamp.to_nsec(), {}) for stamp in stamps]
            answered = [answer for answer in answered if len(answer) == 2]
            return answered if len(answered) >= FRAMES else None
        answered = self.show(boxes, answers, '%d answers' % FRAMES)
        self.assertEqual({answer['floor'].status for answer in answered}, {FOUND})
        grids = self.costmap.since(begin)
        self.assertGreater(len(grids), FRAMES / 2, 'maps')
        return [answer['scan'] for answer in answered], grids

    def check_kept(self, grids):
        for number, grid in enumerate(grids):
            missing = FRONTS[~grid.are_marked(FRONTS)]
            self.assertEqual(len(missing), 0, 'map %d of %d has nothing at %s; it has %s' % (number, len(grids), missing, grid))

    def check_nothing_else(self, grids, points):
        for number, grid in enumerate(grids):
            others = grid.marks_elsewhere(points)
            self.assertEqual(len(others), 0, 'map %d of %d has marks at %s, at none of the boxes' % (number, len(grids), others))

    def test_a_box_is_marked_where_it_stands(self):
        grid = self.mark()
        self.check_kept([grid])
        self.check_nothing_else([grid], SIDES)

    def test_no_floor_is_marked(self):
        scans, grids = self.walk_before([])
        nearest = min(np.nanmin([*scan.ranges, math.inf]) for scan in scans)
        self.assertGreater(nearest, NEAR, 'the nearest range [m] on a bare floor')
        origin = in_odom((AHEAD, 0.0))
        for number, grid in enumerate(grids):
            distances = np.hypot(*(grid.centres() - origin).T)
            self.assertFalse((distances < NEAR).any(), 'map %d of %d: %s' % (number, len(grids), grid))

    def test_a_box_that_is_gone_is_cleared(self):
        self.mark()
        grid = self.clear()
        self.assertFalse(grid.are_marked(SIDES).any())

    def test_a_box_that_stands_stays(self):
        self.mark()
        _, grids = self.walk_before(BOXES)
        self.check_kept(grids)
        self.check_nothing_else(grids, SIDES)

    def test_without_a_floor_nothing_is_cleared(self):
        self.mark()
        begin = rospy.Time.now()

        def scans(stamps):
            """Of the frames without a floor; before, the last one is held."""
            answers = [self.client.answers.get(stamp.to_nsec(), {}) for stamp in stamps]
            lost = [a['scan'] for a in answers if len(a) == 2 and a['floor'].status == NOT_FOUND]
            return lost if len(lost) >= FRAMES / 4 else None
        lost = self.show([WALL], scans, '%d frames without a floor' % (FRAMES / 4))
        for scan in lost:
            self.assertTrue(np.isnan(scan.ranges).all(), 'ranges without a floor: %s' % (scan.ranges,))
        grids = self.costmap.since(begin)
        self.assertGreater(len(grids), FRAMES / 4, 'maps')
        self.check_kept(grids)


if __name__ == '__main__':
    rospy.init_node('test_floor_scan_costmap')
    rostest.rosrun('polygonal_perception', 'test_floor_scan_costmap', FloorScanCostmapTest, sys.argv)
