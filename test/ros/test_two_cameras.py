#!/usr/bin/env python3
"""Two cameras with a node each: only one may own the tf frame floor, and the other one says so."""
import sys
import unittest

import rospy
import rostest

import scene
from node_client import FOUND, Clock, NodeClient

OUTPUTS = ('floor', 'polygons')


class TwoCamerasTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.left = NodeClient(OUTPUTS, '/left', camera='/left')
        cls.right = NodeClient(OUTPUTS, '/right', camera='/right')
        cls.apart = NodeClient(OUTPUTS, '/apart', camera='/right')
        cls.clock = Clock()
        cls.camera = scene.Camera(height=0.8, pitch=0.4)
        cls.depth = cls.camera.render()

    def cloud(self, frame):
        return self.camera.cloud(self.depth, self.clock.tick(), frame)

    def parents(self, child):
        return {t.header.frame_id for t in self.left.transforms if t.child_frame_id == child}

    def test_the_later_one_does_not_answer_and_says_why(self):
        self.assertEqual(self.left.ask(self.cloud('left_optical'))['floor'].status, FOUND)
        self.left.wait_for(lambda: 'left_optical' in self.parents('floor'), 'the floor frame')

        # A transform may still be on its way to the other node.
        def is_said():
            cloud = self.cloud('left_optical')
            self.left.ask(cloud)
            self.right.send(self.cloud('right_optical'))
            return any("floor_frame 'floor' is already broadcast below 'left_optical', by /left" in log.msg
                       for log in self.right.logs)
        self.right.wait_for(is_said, 'a word in the log')
        self.right.wait_for_diagnostics(
            lambda s: any(v.key == 'Last rejection' and "below 'left_optical'" in v.value for v in s.values), 'the rejection')
        self.apart.ask_until_answered(lambda: [self.cloud('right_optical')])
        self.left.ask(self.cloud('left_optical'))
        stamp = self.clock.tick()
        self.right.send(self.camera.cloud(self.depth, stamp, 'right_optical'))
        self.apart.answer(stamp)
        self.assertEqual(self.right.answered(stamp), [], 'of the node that shares its floor_frame')
        self.left.wait_for(lambda: self.parents('right_floor') == {'right_optical'}, 'the other floor frame')

        # The other camera ends: this one takes over.
        self.right.ask_until_answered(lambda: [self.cloud('right_optical')])
        self.right.wait_for(lambda: 'right_optical' in self.parents('floor'), 'the floor frame')


if __name__ == '__main__':
    rospy.init_node('test_two_cameras')
    rostest.rosrun('polygonal_perception', 'test_two_cameras', TwoCamerasTest, sys.argv)
