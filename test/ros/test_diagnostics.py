#!/usr/bin/env python3
"""The diagnostics tell why the node does what it does."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticStatus

import scene
from node_client import Clock, NodeClient


def values_of(status):
    return {v.key: v.value for v in status.values}


class DiagnosticsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient(outputs=())
        cls.clock = Clock()
        cls.camera = scene.Camera(height=0.9, pitch=0.4, roll=0.1)

    def wait_for(self, level, text, cloud=None, holds=lambda values: True):
        """Waits for a summary and for values of which something holds, and sends clouds meanwhile."""
        def said(status):
            return status.level == level and text in status.message and holds(values_of(status))

        def condition():
            if cloud is not None:
                self.client.send(cloud(self.clock.tick()))
            return self.client.diagnostics and said(self.client.diagnostics[-1])
        self.client.wait_for(condition, 'diagnostics that say "%s"; the last: %s' % (text, self.client.diagnostics[-1:]))
        return values_of(self.client.diagnostics[-1])

    def floor(self, stamp):
        return self.camera.cloud(self.camera.render(), stamp)

    def wall(self, stamp):
        wall = scene.Box((0.5, 0.6), (-9, 9), (-9, 9))
        return self.camera.cloud(self.camera.render([wall], floor=False), stamp)

    def spoilt(self, stamp):
        return self.camera.cloud(self.camera.render(), stamp, frame='/camera')

    def test_the_life_of_a_node(self):
        self.wait_for(DiagnosticStatus.OK, 'idle: nobody reads an output')

        self.client.read('polygons')
        values = self.wait_for(DiagnosticStatus.ERROR, 'waiting for /camera/depth/points')
        self.assertEqual(values['Frames answered'], '0')
        self.assertEqual(values['Floor'], 'NOT_FOUND')

        values = self.wait_for(DiagnosticStatus.OK, 'floor found', self.floor)
        self.assertEqual(values['Floor'], 'FOUND')
        self.assertAlmostEqual(float(values['Camera height [m]']), 0.9, delta=0.004)
        self.assertAlmostEqual(float(values['Camera pitch [deg]']), 22.92, delta=0.2)
        self.assertAlmostEqual(float(values['Camera roll [deg]']), 5.73, delta=0.2)
        self.assertGreater(int(values['Frames answered']), 0)
        self.assertEqual(values['Frames rejected'], '0')
        self.assertEqual(values['Last rejection'], 'none')
        # A report later, when frames have come all the time.
        values = self.wait_for(DiagnosticStatus.OK, 'floor found', self.floor,
                               lambda values: float(values['Input rate [Hz]']) > 1.0)
        for stage in ('samples', 'floor', 'projection', 'total'):
            mean, longest = (float(values['Time of %s %s [ms]' % (stage, k)]) for k in ('mean', 'max'))
            self.assertTrue(0.0 < mean <= longest, (stage, mean, longest))

        self.assertNotIn('Floor not seen because', values)

        values = self.wait_for(DiagnosticStatus.WARN, 'no floor in view', self.wall)
        self.assertIn('no plane in view faces up', values['Floor not seen because'])

        values = self.wait_for(DiagnosticStatus.ERROR, 'every frame is rejected', self.spoilt)
        self.assertIn("header.frame_id is '/camera'", values['Last rejection'])
        self.assertGreater(int(values['Frames rejected']), 0)

        self.wait_for(DiagnosticStatus.OK, 'floor found', self.floor)
        self.wait_for(DiagnosticStatus.ERROR, 'no frame for')
        self.client.stop_reading('polygons')
        values = self.wait_for(DiagnosticStatus.OK, 'idle')
        self.assertEqual(values['Floor'], 'NOT_FOUND', 'a floor that the next frame knows nothing of')
        self.assertNotIn('Camera height [m]', values)


if __name__ == '__main__':
    rospy.init_node('test_diagnostics')
    rostest.rosrun('polygonal_perception', 'test_diagnostics', DiagnosticsTest, sys.argv)
