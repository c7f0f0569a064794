#!/usr/bin/env python3
"""roscore dies, stays away and comes back empty, while frames arrive."""
import os
import socket
import sys
import time
import unittest

import rosgraph
import rospy
import rostest
from dynamic_reconfigure.msg import Config, DoubleParameter
from dynamic_reconfigure.srv import Reconfigure
from std_srvs.srv import Trigger

import launched
import scene
from node_client import DEADLINE, FOUND, Clock, NodeClient

NODE = '/polygonal_perception'
FRAMES = 30
PROGRAMS = {
    'node': [launched.NODE],
    'manager': ['rosrun', 'nodelet', 'nodelet', 'standalone', 'polygonal_perception/PolygonalPerception'],
}


class Master(launched.Started):
    """A roscore of our own: rostest's has to live on."""

    def __init__(self):
        super().__init__('rosmaster', '--core', '-p', os.environ['ROS_MASTER_URI'].rsplit(':', 1)[1])

    def __enter__(self):
        super().__enter__()
        deadline = time.monotonic() + DEADLINE
        while not rosgraph.is_master_online():
            assert time.monotonic() < deadline, 'roscore does not start'
        return self


class Program(launched.Started):
    """The node, alone or in a manager, with a client."""

    def __init__(self, hull):
        super().__init__(*PROGRAMS[hull], '__name:=' + NODE[1:], 'points:=/camera/depth/points')

    def __enter__(self):
        super().__enter__()
        self.camera, self.clock = scene.Camera(), Clock()
        self.client = NodeClient()
        # They look the services up now, and not again.
        self.set = rospy.ServiceProxy(NODE + '/set_parameters', Reconfigure, persistent=True)
        self.reset = rospy.ServiceProxy(NODE + '/reset', Trigger, persistent=True)
        return self

    def end(self):
        self.client.close()
        self.set.close()
        self.reset.close()
        return super().end()


class MasterTest(unittest.TestCase):
    def check(self, program, radius):
        """Everything works over the connections that are there."""
        answers = [program.client.ask(program.camera.cloud(program.camera.render(), program.clock.tick())) for _ in range(FRAMES)]
        self.assertEqual({a['floor'].status for a in answers}, {FOUND})
        in_force = program.set(Config(doubles=[DoubleParameter('robot_radius', radius)])).config
        self.assertIn(DoubleParameter('robot_radius', radius), in_force.doubles)
        self.assertTrue(program.reset().success)
        reports = len(program.client.diagnostics)
        program.client.wait_for(lambda: len(program.client.diagnostics) > reports + 1, 'reports')

    def live(self, hull):
        with Master() as master:
            if not rospy.core.is_initialized():
                rospy.init_node('test_master')
            with Program(hull) as program:
                self.check(program, 0.1)
                master.crash()
                self.check(program, 0.2)
                with Master() as other:
                    self.check(program, 0.3)
                    # Nobody new finds it: it has to be started again.
                    self.assertNotIn(NODE, str(rosgraph.Master('/test_master').getSystemState()))
                    self.assertEqual(program.end(), 0)
                    with Program(hull) as again:
                        self.check(again, 0.1)
                        other.crash()
                        self.check(again, 0.2)
                        self.assertEqual(again.end(), 0)

    def test_node(self):
        self.live('node')

    def test_manager(self):
        self.live('manager')


if __name__ == '__main__':
    with socket.socket() as free:
        free.bind(('', 0))
        os.environ['ROS_MASTER_URI'] = 'http://localhost:%d' % free.getsockname()[1]
    rostest.rosrun('polygonal_perception', 'test_master', MasterTest, sys.argv)
