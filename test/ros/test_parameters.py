#!/usr/bin/env python3
"""Parameters: refused at the start, and changed while the node runs."""
import subprocess
import sys
import unittest

import dynamic_reconfigure.client
import numpy as np
import rospy
import rostest

import scene
from node_client import DEADLINE, Clock, NodeClient

NODE = '/polygonal_perception'


class ParametersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient()
        cls.reconfigure = dynamic_reconfigure.client.Client(NODE, timeout=DEADLINE)
        cls.clock = Clock()
        cls.camera = scene.Camera()
        cls.boxes = [scene.Box((1.82, 2.22), (-0.38, 0.12), (0, 0.3))]

    def setUp(self):
        self.set(robot_radius=0.3, grid_resolution=0.05, samples_x=32, min_height=0.03, max_height=0.6, min_range=0.01,
                 max_range=0.0)

    def set(self, **values):
        return self.reconfigure.update_configuration(values)

    def answer(self):
        return self.client.ask(self.camera.cloud(self.camera.render(self.boxes), self.clock.tick()))

    def test_the_defaults_stay_in_the_place_of_refused_values(self):
        for name, value in [('lower_plane_weight', 3.0), ('max_tilt', np.pi / 4), ('min_camera_height', 0.05),
                            ('max_camera_height', 3.0)]:
            self.assertAlmostEqual(rospy.get_param(NODE + '/' + name), value)
        self.assertEqual(self.answer()['polygons'].header.frame_id, 'floor')

    def test_good_values_at_the_start_are_taken(self):
        self.assertEqual(rospy.get_param(NODE + '/simplification_tolerance'), 0.1)
        self.assertEqual(self.reconfigure.get_configuration(DEADLINE)['simplification_tolerance'], 0.1)

    def test_descriptions_have_ranges_units_and_help(self):
        radius = next(p for p in self.reconfigure.get_parameter_descriptions(DEADLINE) if p['name'] == 'robot_radius')
        self.assertEqual((radius['min'], radius['max'], radius['default'], radius['type']), (0.0, 5.0, 0.3, 'double'))
        self.assertTrue(radius['description'].startswith('[m] Radius'), radius['description'])
        samples = next(p for p in self.reconfigure.get_parameter_descriptions(DEADLINE) if p['name'] == 'samples_x')
        self.assertEqual((samples['min'], samples['max'], samples['default'], samples['type']), (4, 256, 32, 'int'))

    def test_a_change_takes_effect_with_the_next_frame(self):
        for radius in (0.3, 0.1, 0.5):
            self.assertEqual(self.set(robot_radius=radius)['robot_radius'], radius)
            answer = self.answer()
            occupied = np.array(answer['occupancy_grid'].data).reshape(100, 100) == 100
            inflated = np.array(answer['inflated_grid'].data).reshape(100, 100) == 100
            np.testing.assert_array_equal(inflated, scene.inflate(occupied, 0.05, radius))
            nearest = min(p.x for p in answer['polygons'].polygons[0].boundary.points)
            self.assertTrue(1.8 - radius - 0.1 - 0.075 <= nearest <= 1.8 - radius + 1e-6, (radius, nearest))
            self.assertEqual(rospy.get_param(NODE + '/robot_radius'), radius)

    def test_points_out_of_range_are_none(self):
        # The box begins 1.82 m ahead, and the camera is 1 m high.
        self.assertEqual(len(self.answer()['polygons'].polygons), 1)
        self.set(max_range=1.9)
        self.assertEqual(len(self.answer()['polygons'].polygons), 0, 'nearer than 1.9 m is floor alone')
        self.set(max_range=0.0, min_range=2.5)
        self.assertEqual(len(self.answer()['polygons'].polygons), 0, 'farther than 2.5 m is floor alone')
        self.set(min_range=0.01, max_range=4.0)
        self.assertEqual(len(self.answer()['polygons'].polygons), 1)
        refused = self.set(min_range=5.0)
        self.assertEqual((refused['min_range'], refused['max_range']), (0.01, 4.0), 'nothing lies in between')

    def test_the_command_line_changes_the_next_frame(self):
        self.answer()
        subprocess.run(['rosrun', 'dynamic_reconfigure', 'dynparam', 'set', NODE, 'robot_radius', '0.1'], check=True)
        nearest = min(p.x for p in self.answer()['polygons'].polygons[0].boundary.points)
        self.assertTrue(1.8 - 0.1 - 0.1 - 0.075 <= nearest <= 1.8 - 0.1 + 1e-6, nearest)

    def test_sizes_change_too(self):
        self.set(grid_resolution=0.1, samples_x=16)
        grid = self.answer()['occupancy_grid']
        self.assertEqual((grid.info.width, grid.info.height, len(grid.data)), (50, 50, 2500))

    def test_a_set_with_a_bad_value_is_refused_as_a_whole(self):
        before = self.reconfigure.get_configuration(DEADLINE)
        after = self.set(robot_radius=0.2, max_height=-4.0)
        self.assertEqual((after['robot_radius'], after['max_height']), (0.3, 0.6))
        self.assertEqual(before, self.reconfigure.get_configuration(DEADLINE))
        self.assertEqual(rospy.get_param(NODE + '/robot_radius'), 0.3)
        self.client.wait_for_log('refused', 'max_height is -4, accepted is 0 to 10 m')

    def test_values_that_contradict_each_other_are_refused(self):
        after = self.set(min_height=0.7, robot_radius=0.2)
        self.assertEqual((after['min_height'], after['robot_radius']), (0.03, 0.3))
        self.client.wait_for_log('refused', 'min_height is 0.7 and max_height is 0.6, accepted is min_height < max_height')
        self.assertEqual(self.set(min_height=0.7, max_height=0.8)['min_height'], 0.7)

    def test_a_grid_too_large_is_refused(self):
        after = self.set(grid_length=50.0, grid_width=50.0, grid_resolution=0.005)
        self.assertEqual((after['grid_length'], after['grid_resolution']), (5.0, 0.05))
        self.client.wait_for_log('refused', 'make 1e+08 cells, accepted are at most 4e+06')


if __name__ == '__main__':
    rospy.init_node('test_parameters')
    rostest.rosrun('polygonal_perception', 'test_parameters', ParametersTest, sys.argv)
