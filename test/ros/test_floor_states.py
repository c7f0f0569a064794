#!/usr/bin/env python3
"""FOUND, HELD and NOT_FOUND; what makes the node forget a floor."""
import math
import sys
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest

import scene
from node_client import FOUND, HELD, NOT_FOUND, OUTPUTS, Clock, NodeClient
from polygonal_perception.msg import Plane

FLOOR_TIMEOUT = 0.5  # [s] the default


class FloorStatesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient(OUTPUTS)
        cls.clock = Clock()
        cls.camera = scene.Camera()
        cls.boxes = [scene.Box((1.8, 2.2), (-0.4, 0.1), (0, 0.3))]

    def setUp(self):
        self.client.reset()

    def see_floor(self, stamp=None):
        stamp = stamp or self.clock.tick()
        return self.client.ask(self.camera.cloud(self.camera.render(self.boxes), stamp))

    def see_nothing(self, stamp=None):
        """A wall close by fills the image: no floor in view."""
        stamp = stamp or self.clock.tick()
        wall = scene.Box((0.5, 0.6), (-9, 9), (-9, 9))
        return self.client.ask(self.camera.cloud(self.camera.render([wall], floor=False), stamp))

    def check_no_floor(self, answer):
        floor = answer['floor']
        self.assertEqual(floor.status, NOT_FOUND)
        self.assertEqual(floor.hull, [])
        self.assertEqual((floor.normal.x, floor.normal.y, floor.normal.z, floor.distance), (0, 0, 0, 0))
        self.assertEqual(list(answer['floor_coefficients'].values), [])
        self.assertEqual(answer['polygons'].floor_status, NOT_FOUND)
        self.assertEqual(answer['polygons'].polygons, [])
        self.assertEqual(answer['polygons'].extent.points, [], 'nothing is known anywhere')
        self.assertGreater(answer['polygons'].inflation_radius, 0.0)
        self.assertEqual(answer['polygons'].header.frame_id, 'floor')
        for name in ('occupancy_grid', 'observed_grid', 'inflated_grid'):
            grid = answer[name]
            self.assertEqual(set(grid.data), {-1})
            self.assertEqual((grid.info.width, grid.info.height, len(grid.data)), (100, 100, 10000))
            self.assertAlmostEqual(grid.info.origin.position.y, -2.5)
        cells = answer['observed_cells']
        self.assertEqual(cells.floor_status, NOT_FOUND)
        self.assertEqual([bytes(bits) for bits in (cells.hit, cells.free, cells.floor)], 3 * [bytes(10000)])
        scan = answer['scan']
        self.assertEqual(scan.header.frame_id, 'floor')
        self.assertGreater(len(scan.ranges), 50)
        self.assertTrue(all(math.isnan(r) for r in scan.ranges), 'nobody knows anything')
        self.assertEqual(answer['obstacle_points'].width, 0)
        # What fills the image is a plane all the same; how it lies nobody knows.
        self.assertEqual([p.kind for p in answer['planes'].planes], [Plane.UNKNOWN])
        self.assertEqual({m.action for m in answer['markers'].markers}, {2}, 'all markers deleted')

    def test_no_floor_is_an_answer_on_every_topic(self):
        self.check_no_floor(self.see_nothing())

    def test_a_floor_that_is_missing_for_long_is_said_once_with_the_reason(self):
        self.see_floor()
        self.client.logs.clear()
        for _ in range(9):
            self.see_nothing(self.clock.tick(1.0))
        said = self.client.wait_for_log('no floor for 5 s: no plane in view faces up', 'initial_up')
        self.assertIn('from the up vector', said)
        self.assertEqual(len([l for l in self.client.logs if 'no floor for' in l.msg]), 1, 'warnings')

    def test_no_floor_sends_no_transform(self):
        stamp = self.see_nothing()['floor'].header.stamp
        later = self.see_floor()['floor'].header.stamp
        self.client.wait_for(lambda: [t for t in self.client.transforms if t.header.stamp == later], 'tf')
        self.assertEqual([t for t in self.client.transforms if t.header.stamp == stamp], [])

    def test_a_floor_is_held_then_given_up(self):
        found = self.see_floor()['floor']
        self.assertEqual(found.status, FOUND)
        answer = self.see_nothing(self.clock.tick(0.2))
        held = answer['floor']
        self.assertEqual(held.status, HELD)
        self.assertAlmostEqual(held.age, 0.2, places=6)
        self.assertEqual(held.normal, found.normal)
        self.assertEqual(held.distance, found.distance)
        self.assertEqual(held.hull, found.hull)
        self.assertEqual(answer['polygons'].floor_status, HELD)
        self.assertNotIn(-1, answer['occupancy_grid'].data)
        self.check_no_floor(self.see_nothing(self.clock.tick(FLOOR_TIMEOUT)))
        self.assertEqual(self.see_floor()['floor'].status, FOUND)

    def test_a_hull_of_an_earlier_floor_does_not_come_with_a_held_one(self):
        self.assertGreater(len(self.see_floor()['floor'].hull), 2)
        # Nobody reads the hull when the floor is found once more.
        hull_readers = ('floor', 'markers')
        for name in hull_readers:
            self.client.stop_reading(name)
        node = xmlrpc.client.ServerProxy(rosgraph.Master('/floor_states').lookupNode(self.client.node))
        self.client.wait_for(lambda: not any(connection[4] == self.client.node + '/' + name
                                             for connection in node.getBusInfo('/floor_states')[2] for name in hull_readers),
                             'the readers to be gone')
        self.see_floor()
        for name in hull_readers:
            self.client.read(name)
        self.client.wait_connected()
        held = self.see_nothing()['floor']
        self.assertEqual((held.status, held.hull), (HELD, []))

    def test_reset_forgets_the_floor(self):
        self.see_floor()
        self.assertEqual(self.see_nothing()['floor'].status, HELD)
        response = self.client.reset()
        self.assertTrue(response.success, response.message)
        self.check_no_floor(self.see_nothing())

    def test_time_that_jumps_back_forgets_the_floor(self):
        self.see_floor()
        self.check_no_floor(self.see_nothing(self.clock.tick(-100.0)))
        self.client.wait_for_log('time has jumped back')
        self.assertEqual(self.see_floor()['floor'].status, FOUND)
        self.assertEqual(self.see_nothing()['floor'].status, HELD)


if __name__ == '__main__':
    rospy.init_node('test_floor_states')
    rostest.rosrun('polygonal_perception', 'test_floor_states', FloorStatesTest, sys.argv)
