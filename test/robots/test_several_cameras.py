#!/usr/bin/env python3
"""multi_camera.launch on a simulated robot with cameras all around: one map of what each of them sees."""
import os
import sys
import threading
import unittest

import cv2
import numpy as np
import rospy
import rostest
from nav_msgs.msg import OccupancyGrid
from tf2_msgs.msg import TFMessage

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'ros'))
from launched import Launched  # noqa: E402
from waiting import wait_for  # noqa: E402

from polygonal_perception.msg import FloorPlane, PolygonArray  # noqa: E402

DEADLINE = 60.0  # [s]
# Most of 3 sigma and a half cell at 4 m, where an Xtion's depth has 2.6 cm and a step of 4 cm.
NEAR = 0.15  # [m]


def yaw_of(rotation):
    return 2.0 * np.arctan2(rotation.z, rotation.w)


class SeveralCamerasTest(unittest.TestCase):
    def setUp(self):
        self.condition = threading.Condition()
        self.got, self.poses, self.readers = {}, {}, []

    def tearDown(self):
        for reader in self.readers:
            reader.unregister()

    def read(self, topic, kind):
        def keep(message):
            with self.condition:
                self.got[topic] = message
                self.condition.notify_all()
        self.readers.append(rospy.Subscriber(topic, kind, keep))

    def keep_poses(self, message):
        with self.condition:
            for transform in message.transforms:
                if (transform.header.frame_id, transform.child_frame_id) == ('odom', 'base_link'):
                    self.poses[transform.header.stamp] = transform.transform

    def wait_for(self, condition, what):
        return wait_for(self.condition, condition, what, DEADLINE)

    def occupied(self, robot):
        """Centres of the map's occupied cells in odom, and their directions as seen from the robot [rad]."""
        grid = self.got['/polygon_map/occupancy_grid']
        cells = np.argwhere(np.array(grid.data, np.int8).reshape(grid.info.height, grid.info.width) > 50)
        origin = grid.info.origin.position
        centres = (cells[:, ::-1] + 0.5) * grid.info.resolution + [origin.x, origin.y]
        away = centres - [robot.translation.x, robot.translation.y]
        directions = np.arctan2(away[:, 1], away[:, 0]) - yaw_of(robot.rotation)
        return centres, np.arctan2(np.sin(directions), np.cos(directions))

    def sees_all_around(self, count):
        """The cells, once those in each camera's direction are many."""
        grid = self.got.get('/polygon_map/occupancy_grid')
        robot = grid and self.poses.get(grid.header.stamp)
        if not robot:
            return None
        centres, directions = self.occupied(robot)
        for k in range(count):
            turn = directions - 2.0 * np.pi * k / count
            if np.sum(np.abs(np.arctan2(np.sin(turn), np.cos(turn))) < 0.4) < 10:
                return None
        return centres.tolist()

    def check(self, count, **args):
        self.read('/polygon_map/occupancy_grid', OccupancyGrid)
        self.read('/simulated_camera/ground_truth/obstacles', PolygonArray)
        self.readers.append(rospy.Subscriber('/tf', TFMessage, self.keep_poses))
        names = ('front', 'rear', 'left')[:count]
        for name in names:
            self.read('/%s/floor' % name, FloorPlane)
        with Launched('multi_camera.launch', simulation='true', rviz='false', scene='office', input='depth', rate='4', **args):
            self.wait_for(lambda: '/simulated_camera/ground_truth/obstacles' in self.got, 'the truth')
            self.wait_for(lambda: all('/%s/floor' % name in self.got for name in names), 'a floor of each camera')
            centres = np.array(self.wait_for(lambda: self.sees_all_around(count), '%d cameras\' obstacles in one map' % count))
            for name in names:
                floor = self.got['/%s/floor' % name]
                self.assertEqual(floor.header.frame_id, name + '_camera_depth_optical_frame')
        truth = [np.array([(p.x, p.y) for p in polygon.boundary.points], np.float32)
                 for polygon in self.got['/simulated_camera/ground_truth/obstacles'].polygons]
        away = np.array([min(-cv2.pointPolygonTest(ring, (float(x), float(y)), True) for ring in truth) for x, y in centres])
        print('%d cells, %d farther than %.2f m from every obstacle, the farthest %.3f m' % (
            len(away), np.sum(away > NEAR), NEAR, away.max()))
        self.assertLess(np.mean(away > NEAR), 0.01, 'cells where nothing stands: %s' % centres[away > NEAR])

    def test_two(self):
        self.check(2)

    def test_three(self):
        self.check(3, third='left')


if __name__ == '__main__':
    rospy.init_node('test_several_cameras')
    rostest.rosrun('polygonal_perception', 'test_several_cameras', SeveralCamerasTest, sys.argv)
