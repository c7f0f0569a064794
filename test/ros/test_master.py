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
from std_srvs.srv import Empty, Trigger

import launched
from node_client import DEADLINE, Clock
from subjects import Map, Perception

FRAMES = 30
SERVICES = {Perception: ('/reset', Trigger), Map: ('/clear', Empty)}


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
    """A node, alone or in a manager, with a client."""

    def __init__(self, kind, hull):
        self.kind = kind
        command = [launched.program(kind.PROGRAM)] if hull == 'node' else [
            'rosrun', 'nodelet', 'nodelet', 'standalone', 'polygonal_perception/' + kind.NODELET]
        super().__init__(*command, '__name:=' + kind.NAME[1:], *('%s:=%s' % item for item in kind.REMAPPED.items()),
                         *('_%s:=%s' % item for item in kind.PARAMETERS.items()))

    def __enter__(self):
        super().__enter__()
        self.subject, self.clock = self.kind(), Clock()
        self.client = self.subject.client
        # They look the services up now, and not again.
        self.set = rospy.ServiceProxy(self.kind.NAME + '/set_parameters', Reconfigure, persistent=True)
        name, service = SERVICES[self.kind]
        self.begin_anew = rospy.ServiceProxy(self.kind.NAME + name, service, persistent=True)
        return self

    def end(self):
        self.client.close()
        self.set.close()
        self.begin_anew.close()
        return super().end()


class MasterTest(unittest.TestCase):
    def check(self, program, radius):
        """Everything works over the connections that are there."""
        for _ in range(FRAMES):
            answer = program.client.ask(program.subject.messages(program.clock.tick())[0])
            self.assertTrue(program.subject.is_good(answer), answer)
        in_force = program.set(Config(doubles=[DoubleParameter('robot_radius', radius)])).config
        self.assertIn(DoubleParameter('robot_radius', radius), in_force.doubles)
        self.assertTrue(getattr(program.begin_anew(), 'success', True))
        reports = len(program.client.diagnostics)
        program.client.wait_for(lambda: len(program.client.diagnostics) > reports + 1, 'reports')

    def live(self, kind, hull):
        with Master() as master:
            if not rospy.core.is_initialized():
                rospy.init_node('test_master')
            with Program(kind, hull) as program:
                self.check(program, 0.1)
                master.crash()
                self.check(program, 0.2)
                with Master() as other:
                    self.check(program, 0.3)
                    # Nobody new finds it: it has to be started again.
                    self.assertNotIn(kind.NAME, str(rosgraph.Master('/test_master').getSystemState()))
                    self.assertEqual(program.end(), 0)
                    with Program(kind, hull) as again:
                        self.check(again, 0.1)
                        other.crash()
                        self.check(again, 0.2)
                        self.assertEqual(again.end(), 0)

    def test_node(self):
        self.live(Perception, 'node')

    def test_manager(self):
        self.live(Perception, 'manager')

    def test_map_in_a_manager(self):
        self.live(Map, 'manager')


if __name__ == '__main__':
    with socket.socket() as free:
        free.bind(('', 0))
        os.environ['ROS_MASTER_URI'] = 'http://localhost:%d' % free.getsockname()[1]
    rostest.rosrun('polygonal_perception', 'test_master', MasterTest, sys.argv)
