#!/usr/bin/env python3
"""The node subscribes while somebody reads, and forgets an old floor when it wakes up."""
import sys
import unittest

import rospy
import rostest

import scene
from node_client import FOUND, HELD, NOT_FOUND, OUTPUTS, Clock, NodeClient


class LazyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # It reads tf and the diagnostics, which do not count.
        cls.client = NodeClient(outputs=())
        cls.clock = Clock()

    def connections(self):
        return self.client.cloud.get_num_connections()

    def wait_asleep(self):
        self.client.wait_for(lambda: self.connections() == 0, 'the node to unsubscribe')

    def test_every_output_wakes_it(self):
        camera = scene.Camera()
        for name in OUTPUTS:
            self.wait_asleep()
            self.client.read(name)
            self.client.wait_connected()
            answer = self.client.ask(camera.cloud(camera.render(), self.clock.tick()))
            self.assertEqual(sorted(answer), [name])
            self.client.stop_reading(name)
        self.wait_asleep()

    def test_it_sleeps_though_tf_and_diagnostics_are_read(self):
        self.client.wait_for_diagnostics(lambda s: 'idle' in s.message, 'the node idle')
        self.assertEqual(self.connections(), 0)

    def test_it_wakes_up_without_the_old_floor(self):
        camera = scene.Camera()
        wall = camera.render([scene.Box((0.5, 0.6), (-9, 9), (-9, 9))], floor=False)
        self.client.read('floor')
        self.client.wait_connected()
        self.assertEqual(self.client.ask(camera.cloud(camera.render(), self.clock.tick()))['floor'].status, FOUND)
        self.assertEqual(self.client.ask(camera.cloud(wall, self.clock.tick()))['floor'].status, HELD)
        self.client.stop_reading('floor')
        self.wait_asleep()
        self.client.read('floor')
        self.client.wait_connected()
        self.assertEqual(self.client.ask(camera.cloud(wall, self.clock.tick()))['floor'].status, NOT_FOUND)
        self.client.stop_reading('floor')
        self.wait_asleep()


if __name__ == '__main__':
    rospy.init_node('test_lazy')
    rostest.rosrun('polygonal_perception', 'test_lazy', LazyTest, sys.argv)
