#!/usr/bin/env python3
"""With lazy off the node works, and sends tf, though nobody reads an output."""
import sys
import unittest

import rospy
import rostest

import scene
from node_client import Clock, NodeClient


class BusyTest(unittest.TestCase):
    def test_tf_comes_without_a_reader(self):
        client = NodeClient(outputs=())
        client.wait_connected()
        camera = scene.Camera()
        stamp = Clock().tick()
        client.send(camera.cloud(camera.render(), stamp))
        found = client.wait_for(lambda: [t for t in client.transforms if t.header.stamp == stamp], 'tf')
        self.assertEqual(found[0].child_frame_id, 'ground')


if __name__ == '__main__':
    rospy.init_node('test_busy')
    rostest.rosrun('polygonal_perception', 'test_busy', BusyTest, sys.argv)
