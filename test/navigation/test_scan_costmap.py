#!/usr/bin/env python3
"""What a scan on the floor does in a real costmap_2d with config/costmap_scan.yaml: what each range marks and clears.

The scans are made here. That they do what ~scan means them to do is what ~scan relies on.
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
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'ros'))
import scene  # noqa: E402
from costmap import Costmap  # noqa: E402
from node_client import NodeClient  # noqa: E402

NODE = '/costmap_node'
SOURCE = NODE + '/costmap/obstacles/scan/'
INF, NAN = math.inf, math.nan
RANGE_MAX = 5.0  # [m] the default of ~scan
DEADLINE = 15.0  # [s] for what five updates of the map a second show at once
# Each with its bearing, the default of ~scan: at 5 m they are less than a cell apart.
RAYS = np.arange(-60, 61)
INCREMENT = 0.0087  # [rad]
ROBOT = (3.02, -1.97)  # where base_link is in odom, all the time


class Pose:
    """Where the frame floor is in odom: level, under a camera before the robot's centre."""

    def __init__(self, yaw, ahead=0.2, z=0.0):
        self.yaw = yaw
        self.rotation = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
        self.position = np.array([*ROBOT, z]) + self.rotation @ [ahead, 0, 0]

    def point(self, ray, distance):
        bearing = ray * INCREMENT
        local = distance * np.array([math.cos(bearing), math.sin(bearing), 0])
        return (self.rotation @ local + self.position)[:2]


def ranges(*sectors):
    """Of a scan that knows nothing but these: [first ray, last ray, range]."""
    result = np.full(len(RAYS), NAN)
    for first, last, distance in sectors:
        result[(RAYS >= first) & (RAYS <= last)] = distance
    return result


def around(ray, distance):
    """More than a ray: the cells of a line to a far point and to a near one in the same direction are not the same."""
    return ray - 6, ray + 6, distance


ALL_FREE = ranges((-60, 60, INF))


class ScanCostmapTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient(outputs=(), node=NODE, runs=False)
        cls.static_tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        cls.static_tf.publish(TFMessage([scene.transform('odom', 'base_link', (*ROBOT, 0))]))
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        cls.scan = rospy.Publisher('/polygonal_perception/scan', LaserScan, queue_size=10)
        cls.costmap = Costmap(cls.client)
        cls.client.wait_for(lambda: cls.tf.get_num_connections() >= 2 and cls.scan.get_num_connections() > 0,
                            'the costmap to read tf and the scan')

    def setUp(self):
        self.pose = Pose(yaw=0.7)

    def tearDown(self):
        self.clear()

    def send(self, values, pose):
        """As the node does: the floor's transform with the frame's stamp, and the scan."""
        stamp = rospy.Time.now()
        transform = scene.transform('odom', 'floor', pose.position, pose.rotation)
        transform.header.stamp = stamp
        self.tf.publish(TFMessage([transform]))
        message = LaserScan(angle_min=RAYS[0] * INCREMENT, angle_max=RAYS[-1] * INCREMENT, angle_increment=INCREMENT,
                            range_min=0.0, range_max=RANGE_MAX, ranges=values)
        message.header.stamp, message.header.frame_id = stamp, 'floor'
        self.scan.publish(message)

    def show(self, values, condition, what, poses=None):
        """Sends a scan, as a camera does again and again, until the map fulfils the condition, and returns the map.

        costmap_2d takes a scan only when tf knows where the floor is 0.05 s later, so a single one would never arrive.
        """
        start, sent = rospy.Time.now(), []
        poses = poses or itertools.repeat(self.pose)

        def grid():
            # Twenty a second: each message that arrives calls this once more.
            if not sent or time.monotonic() - sent[-1] > 0.05:
                self.send(values, next(poses))
                sent.append(time.monotonic())
            newest = self.costmap.grid
            return newest if newest.stamp > start and condition(newest) else None
        try:
            return self.client.wait_for(grid, what, DEADLINE)
        except AssertionError as error:
            raise AssertionError('%s; the costmap has %s' % (error, self.costmap.grid))

    def mark(self, *targets):
        """Marks points, given by ray and distance; returns the map, and where they are in odom."""
        points = [self.pose.point(*target) for target in targets]
        grid = self.show(ranges(*((ray, ray, distance) for ray, distance in targets)),
                         lambda grid: grid.are_marked(points).all(), 'marks at ' + self.text(points))
        return grid, points

    def show_until_gone(self, values, points):
        return self.show(values, lambda grid: not grid.are_marked(points).any(), 'nothing at ' + self.text(points))

    def clear(self):
        """From places in turn, as from one a few cells are crossed by no ray."""
        poses = itertools.cycle([Pose(self.pose.yaw, ahead) for ahead in (0.2, 0.23, 0.26, 0.29, 0.32)])
        return self.show(ALL_FREE, lambda grid: len(grid.marks) == 0, 'an empty map', poses)

    @staticmethod
    def text(points):
        return ', '.join('(%.2f, %.2f)' % tuple(point) for point in points) or 'no place'

    def check_marked(self, grid, points):
        missing = np.reshape(points, (-1, 2))[~grid.are_marked(points)]
        self.assertEqual(len(missing), 0, 'none at %s; the costmap has %s' % (self.text(missing), grid))

    def check_only(self, grid, points):
        others = grid.marks_elsewhere(points)
        self.assertEqual(len(others), 0, 'marks at %s beside those at %s' % (self.text(others), self.text(points)))

    def test_a_range_marks_its_cell(self):
        targets = [(-45, 0.9), (-20, 4.95), (0, 2.51), (31, 1.7), (52, 3.33)]
        # odom's z is not that of the floor that is seen.
        for yaw, z in [(0.0, 0.0), (0.7, -0.15), (1.9, 0.1), (-2.6, -0.02)]:
            self.pose = Pose(yaw, z=z)
            self.check_only(*self.mark(*targets))
            self.clear()

    def test_inf_clears_up_to_range_max_and_marks_nothing(self):
        rays, points = RAYS[5:-5], []
        # From far to near: a nearer range clears nothing beyond it.
        for distance in (4.98, 4.0, 3.0, 2.0, 1.0):
            grid, more = self.mark(*((ray, distance) for ray in rays))
            points += more
        self.check_marked(grid, points)
        count = len(grid.marks)
        # costmap_2d draws lines from cell to cell. Some cells that are farther than 2.5 m away are on no line to what is
        # 5 m away: of these a tenth.
        grid = self.show(ALL_FREE, lambda grid: len(grid.marks) < 0.2 * count, 'less than a fifth of %d marks' % count)
        self.check_only(grid, points)
        # They are on one after a move of a few centimetres.
        self.clear()

    def test_nan_clears_nothing(self):
        _, far = self.mark((35, 4.5))
        _, near = self.mark((35, 1.0))
        _, cleared = self.mark((-35, 2.0))
        # When the one is gone the scan has been there.
        grid = self.show_until_gone(ranges(around(-35, INF), around(35, NAN)), cleared)
        self.check_marked(grid, far + near)
        self.check_only(grid, far + near)

    def test_a_range_clears_what_is_nearer_and_nothing_beyond(self):
        _, beyond = self.mark((35, 4.0))
        _, nearer = self.mark((35, 1.0))
        grid = self.show_until_gone(ranges(around(35, 2.0)), nearer)
        expected = beyond + [self.pose.point(ray, 2.0) for ray in range(35 - 6, 35 + 7)]
        self.check_marked(grid, expected)
        self.check_only(grid, expected)

    def test_between_obstacle_range_and_range_max_a_range_only_clears(self):
        _, nearer = self.mark((0, 2.0))
        distance = (rospy.get_param(SOURCE + 'obstacle_range') + RANGE_MAX) / 2
        grid = self.show_until_gone(ranges(around(0, distance)), nearer)
        self.check_only(grid, [])

    def test_a_range_of_range_max_is_none(self):
        _, kept = self.mark((35, 2.0))
        _, cleared = self.mark((-35, 2.0))
        grid = self.show_until_gone(ranges(around(-35, INF), around(35, RANGE_MAX)), cleared)
        self.check_marked(grid, kept)
        self.check_only(grid, kept)

    def test_a_camera_that_stops_is_noticed(self):
        self.clear()
        self.client.logs.clear()
        self.client.wait_for_log('/polygonal_perception/scan observation buffer has not been updated')

    def test_the_ranges_that_are_shipped(self):
        """Where +inf ends, in costmap_2d, nothing is marked, and every mark can be cleared."""
        self.assertLess(rospy.get_param(SOURCE + 'obstacle_range'), RANGE_MAX - 0.001)
        self.assertGreater(rospy.get_param(SOURCE + 'raytrace_range'), RANGE_MAX)


if __name__ == '__main__':
    rospy.init_node('test_scan_costmap')
    rostest.rosrun('polygonal_perception', 'test_scan_costmap', ScanCostmapTest, sys.argv)
