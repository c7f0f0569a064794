#!/usr/bin/env python3
"""Messages that cannot be used get an error that says why, and the node lives on."""
import sys
import unittest

import rospy
import rostest
from sensor_msgs.msg import PointField

import scene
from node_client import FOUND, Clock, NodeClient


class BadInputTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.depth = rospy.get_param('~input') == 'depth'
        cls.client = NodeClient(depth=cls.depth)
        cls.clock = Clock()
        cls.camera = scene.Camera()

    def check(self, spoil, *texts):
        """A spoilt message is complained of and not answered; the next good one is."""
        depth = self.camera.render()

        def send():
            stamp = self.clock.tick()
            message = self.camera.image(depth, stamp) if self.depth else self.camera.cloud(depth, stamp)
            info = self.camera.info(stamp)
            spoil(info if self.depth and spoil in self.spoilers_of_info else message)
            self.client.send(message, *([info] if self.depth else []))
            return stamp

        # Complaints are throttled, so that it may have to be heard again.
        stamps = []

        def complained():
            if not stamps or rospy.Time.now() - sent[0] > rospy.Duration(0.3):
                sent[0] = rospy.Time.now()
                stamps.append(send())
            return any(all(t in log.msg for t in texts) for log in self.client.logs)

        sent = [rospy.Time.now()]
        self.client.wait_for(complained, 'a complaint with %s; there were: %s' %
                             (texts, [log.msg for log in self.client.logs[-3:]]))
        good = self.clock.tick()
        if self.depth:
            self.client.send(self.camera.image(depth, good), self.camera.info(good))
        else:
            self.client.send(self.camera.cloud(depth, good))
        self.assertEqual(self.client.answer(good)['floor'].status, FOUND)
        for stamp in stamps:
            self.assertEqual(self.client.answered(stamp), [], 'a spoilt frame was answered')

    spoilers_of_info = set()

    def test_leading_slash(self):
        def spoil(message):
            message.header.frame_id = '/camera'
        self.check(spoil, "header.frame_id is '/camera'", 'without a leading slash')

    def test_data_too_short(self):
        def spoil(message):
            message.data = message.data[:1000]
        self.check(spoil, 'data has 1000 bytes, accepted is height x')

    def test_fields(self):
        if self.depth:
            return

        def spoil(message):
            message.fields[2].datatype = PointField.FLOAT64
        self.check(spoil, "field 'z' has datatype 8, accepted is FLOAT32 (7)")

    def test_encoding(self):
        if not self.depth:
            return

        def spoil(message):
            message.encoding = 'bgr8'
        self.check(spoil, "encoding is 'bgr8', accepted are 16UC1 (mm) and 32FC1 (m)")

    def test_calibration(self):
        if not self.depth:
            return

        def spoil(info):
            info.P = [0.0] * 12
            info.K = [0.0] * 9
        self.spoilers_of_info.add(spoil)
        self.check(spoil, 'camera_info has fx, fy, cx, cy of 0, 0, 0, 0', 'fx and fy positive')


if __name__ == '__main__':
    rospy.init_node('test_bad_input')
    rostest.rosrun('polygonal_perception', 'test_bad_input', BadInputTest, sys.argv)
