#!/usr/bin/env python3
"""mount_frame: the floor is sought where tf says, ASSUMED there before a wall, and a camera that has tilted is said."""
import math
import sys
import unittest

import dynamic_reconfigure.client
import numpy as np
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticStatus
from tf2_msgs.msg import TFMessage

import scene
from node_client import ASSUMED, FOUND, HELD, NOT_FOUND, OUTPUTS, Clock, NodeClient


class MountTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient(OUTPUTS)
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        cls.client.wait_for(lambda: cls.tf.get_num_connections() >= 2, 'the node to listen to tf')
        cls.clock = Clock()
        cls.mounted = scene.Camera(height=0.8, pitch=0.1)

    def setUp(self):
        self.clock.tick(100.0)
        self.client.reset()
        self.client.logs.clear()

    def see(self, camera, boxes=(), floor=True, dt=0.1):
        """What a camera sees while tf says that it is mounted as cls.mounted."""
        stamp = self.clock.tick(dt)
        message = scene.transform('base_footprint', scene.OPTICAL_FRAME, self.mounted.position, self.mounted.rotation)
        message.header.stamp = stamp
        self.tf.publish(TFMessage([message]))
        return self.client.ask(camera.cloud(camera.render(boxes, floor), stamp))

    def wall(self, x):
        return scene.Box((x, x + 0.1), (-9, 9), (-9, 9))

    def check_the_wall(self, answer, x):
        """The wall's cells are occupied where it is, and none else."""
        grid = answer['occupancy_grid']
        cells = np.array(grid.data).reshape(grid.info.height, grid.info.width)
        self.assertNotIn(-1, cells)
        columns = np.nonzero(cells.any(0))[0]
        self.assertEqual(sorted({int(c) for c in columns}), [round(x / grid.info.resolution)])
        polygon, = answer['polygons'].polygons
        self.assertTrue(scene.inside((x + 0.02, 0.0), [(p.x, p.y) for p in polygon.boundary.points]))

    def test_before_a_wall_the_floor_is_assumed(self):
        answer = self.see(self.mounted, [self.wall(1.02)])
        floor = answer['floor']
        self.assertEqual(floor.status, ASSUMED)
        np.testing.assert_allclose([floor.normal.x, floor.normal.y, floor.normal.z], self.mounted.floor_normal, atol=1e-6)
        self.assertAlmostEqual(floor.distance, 0.8, places=6)
        self.assertEqual((floor.sample_count, list(floor.hull)), (0, []))
        np.testing.assert_allclose(np.sqrt(np.array(floor.covariance)[[0, 3, 5]]), [0.01, 0.01, 0.015], rtol=1e-3)
        np.testing.assert_allclose(answer['floor_coefficients'].values, [*self.mounted.floor_normal, 0.8], atol=1e-6)
        self.assertEqual(answer['polygons'].floor_status, ASSUMED)
        self.assertEqual(len(answer['polygons'].extent.points), 4)
        self.check_the_wall(answer, 1.02)
        stamp = floor.header.stamp
        self.client.wait_for(lambda: [t for t in self.client.transforms if t.header.stamp == stamp], 'the floor frame')

    def test_a_floor_that_was_seen_is_held_before_it_is_assumed(self):
        self.assertEqual(self.see(self.mounted, [self.wall(4.0)])['floor'].status, FOUND)
        held = self.see(self.mounted, [self.wall(1.02)], dt=0.2)
        self.assertEqual(held['floor'].status, HELD)
        self.check_the_wall(held, 1.02)
        assumed = self.see(self.mounted, [self.wall(1.02)], dt=0.5)
        self.assertEqual(assumed['floor'].status, ASSUMED)
        self.check_the_wall(assumed, 1.02)

    def test_nothing_is_assumed_where_nothing_is_seen(self):
        self.assertEqual(self.see(self.mounted, floor=False)['floor'].status, NOT_FOUND)

    def test_a_table_top_is_not_the_floor(self):
        table = scene.Camera(height=0.5, pitch=0.1)  # sees a level plane 0.5 m below
        for _ in range(8):
            self.assertEqual(self.see(table, dt=1.0)['floor'].status, ASSUMED)
        self.client.wait_for_log("no floor where mount_frame 'base_footprint' says for 5 s", 'the camera is 0.50 m above')

    def test_a_camera_that_has_tilted_is_said(self):
        tilted = scene.Camera(height=0.8, pitch=0.1 + math.radians(3.0))
        for _ in range(40):
            floor = self.see(tilted, [self.wall(4.0)])['floor']
            self.assertEqual(floor.status, FOUND)
            self.assertAlmostEqual(np.dot([floor.normal.x, floor.normal.y, floor.normal.z], tilted.floor_normal), 1.0, places=5)
        said = self.client.wait_for_log('tilted by 3.0 degrees', "mount_frame 'base_footprint'")
        self.assertIn('3.0 degrees further down', said)
        self.assertEqual(len([l for l in self.client.logs if 'tilted by' in l.msg]), 1, 'warnings')
        status = self.client.wait_for_diagnostics(lambda s: 'tilted by 3.0 degrees' in s.message, 'the tilt')
        self.assertEqual(status.level, DiagnosticStatus.WARN)

    def test_where_ground_may_slope_a_tilt_that_lasts_is_said(self):
        tilted = scene.Camera(height=0.8, pitch=0.1 + math.radians(5.0))
        reconfigure = dynamic_reconfigure.client.Client('/polygonal_perception', timeout=10)
        reconfigure.update_configuration({'max_slope': 0.2})
        try:
            for _ in range(25):
                self.assertEqual(self.see(tilted, dt=1.0)['floor'].status, ASSUMED)
            self.assertEqual([log.msg for log in self.client.logs if 'it is a ramp' in log.msg], [])
            for _ in range(8):
                self.see(tilted, dt=1.0)
            self.client.wait_for_log('for 30 s', 'tilted by 5.0 degrees', 'it is a ramp, or the camera has tilted')
        finally:
            reconfigure.update_configuration({'max_slope': 0.0})

    def test_a_camera_that_stands_as_tf_says_is_no_news(self):
        for _ in range(30):
            self.assertEqual(self.see(self.mounted, [self.wall(4.0)])['floor'].status, FOUND)
        self.client.wait_for_diagnostics(lambda s: s.message == 'floor found', 'floor found')
        self.assertEqual([l.msg for l in self.client.logs if 'tilted' in l.msg], [])

    def test_the_robots_own_bumper_is_no_obstacle(self):
        """A box of mount.test covers it; what stands behind is seen as ever."""
        bumper = scene.Box((0.92, 0.96), (-0.2, 0.2), (0.4, 0.5))
        behind = scene.Box((2.02, 2.2), (-0.5, -0.2), (0.0, 0.4))
        grid = self.see(self.mounted, [bumper, behind])['occupancy_grid']
        cells = np.array(grid.data).reshape(grid.info.height, grid.info.width)
        self.assertFalse((cells[:, :30] > 0).any(), 'cells less than 1.5 m ahead')
        self.assertTrue((cells[:, 40] > 0).any(), 'the box behind it')
        seen = self.see(self.mounted, [scene.Box((0.92, 0.96), (-0.5, -0.3), (0.4, 0.5)), behind])['occupancy_grid']
        self.assertTrue((np.array(seen.data).reshape(100, 100)[:, 18:20] > 0).any(), 'what is beside it')

    def test_without_the_mount_there_is_no_floor_and_no_guess(self):
        stamp = self.clock.tick()
        self.client.send(self.mounted.cloud(self.mounted.render(), stamp, frame='unknown_camera'))
        self.assertEqual(self.client.answer(stamp, ['floor'])['floor'].status, NOT_FOUND)
        self.client.wait_for_diagnostics(
            lambda s: any(v.key == 'Last rejection' and "'base_footprint'" in v.value for v in s.values), 'a rejection')


if __name__ == '__main__':
    rospy.init_node('test_mount')
    rostest.rosrun('polygonal_perception', 'test_mount', MountTest, sys.argv)
