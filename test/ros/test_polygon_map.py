#!/usr/bin/env python3
"""The map node on observations that are made here, cell by cell: what comes, what stays, what goes, and what it says."""
import json
import math
import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Log
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

from launched import program
from map_client import observation, transform
from polygonal_perception.msg import FloorPlane, ObservedCells, PolygonArray
from polygonal_perception.srv import MapFile
from waiting import DEADLINE, wait_for

OUTPUTS = {'occupancy_grid': OccupancyGrid, 'observed_grid': OccupancyGrid, 'inflated_grid': OccupancyGrid, 'polygons': PolygonArray}


class PolygonMapTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.condition = threading.Condition()
        cls.answers, cls.logs, cls.states = {}, [], []
        cls.stamp = rospy.Time.now()
        cls.readers = [rospy.Subscriber('/polygon_map/' + name, kind, lambda m, name=name: cls.keep(name, m), queue_size=20)
                       for name, kind in OUTPUTS.items()]
        cls.readers.append(rospy.Subscriber('/rosout', Log, lambda m: cls.append(cls.logs, m.msg)))
        cls.readers.append(rospy.Subscriber('/diagnostics', DiagnosticArray, lambda m: [cls.append(cls.states, s) for s in m.status if s.name.startswith('polygon_map:')]))
        cls.cells = {name: rospy.Publisher('/%s/observed_cells' % name, ObservedCells, queue_size=10) for name in ('front', 'rear')}
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        cls.clear = rospy.ServiceProxy('/polygon_map/clear', Empty)
        cls.save = rospy.ServiceProxy('/polygon_map/save', MapFile)
        cls.load = rospy.ServiceProxy('/polygon_map/load', MapFile)
        for service in (cls.clear, cls.save, cls.load):
            service.wait_for_service(DEADLINE)
        cls.wait_for(lambda: all(p.get_num_connections() for p in [*cls.cells.values(), cls.tf] + cls.readers), 'connections')

    @classmethod
    def keep(cls, name, message):
        with cls.condition:
            cls.answers.setdefault(message.header.stamp.to_nsec(), {})[name] = message
            cls.condition.notify_all()

    @classmethod
    def append(cls, to, what):
        with cls.condition:
            to.append(what)
            cls.condition.notify_all()

    @classmethod
    def wait_for(cls, condition, what):
        return wait_for(cls.condition, condition, what, seen=lambda: '; the log: %s' % cls.logs[-5:])

    def setUp(self):
        self.clear()
        self.logs.clear()

    def tick(self, seconds=0.05):
        PolygonMapTest.stamp += rospy.Duration(seconds)
        return self.stamp

    def place(self, stamp, robot=(0.0, 0.0), floors=((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, math.pi))):
        transforms = [transform(stamp, 'base_link', *robot)]
        transforms += [transform(stamp, name + '_floor', *floor) for name, floor in zip(('front', 'rear'), floors)]
        self.tf.publish(TFMessage(transforms))

    @staticmethod
    def observation(stamp, name='front', hits=(), everything_seen=True):
        return observation(stamp, name + '_floor', hits, everything_seen)

    def send(self, message, name='front', **where):
        self.place(message.header.stamp, **where)
        self.cells[name].publish(message)

    def ask(self, *hits, name='front', **kind):
        """Sends an observation and returns the map after it."""
        where = {k: kind.pop(k) for k in ('robot', 'floors') if k in kind}
        message = self.observation(self.tick(), name, hits, **kind)
        self.send(message, name, **where)
        return self.answer(message.header.stamp)

    def answer(self, stamp):
        return self.wait_for(lambda: len(self.answers.get(stamp.to_nsec(), {})) == len(OUTPUTS) and self.answers[stamp.to_nsec()], 'the map')

    @staticmethod
    def value(grid, x, y):
        i, j = int((x - grid.info.origin.position.x) / 0.05), int((y - grid.info.origin.position.y) / 0.05)
        return grid.data[j * grid.info.width + i]

    def test_each_observation_is_answered_in_the_fixed_frame(self):
        answer = self.ask((1.02, 0.03, 1))
        for message in answer.values():
            self.assertEqual((message.header.frame_id, message.header.stamp), ('odom', self.stamp))
        grid = answer['occupancy_grid']
        self.assertEqual((grid.info.width, grid.info.height), (120, 120))
        self.assertAlmostEqual(grid.info.origin.position.x, -3.0, places=5)
        self.assertEqual(np.count_nonzero(np.array(grid.data) == 100), 1)
        self.assertEqual(self.value(grid, 1.02, 0.03), 100)
        observed = answer['observed_grid']
        self.assertEqual((self.value(observed, 1.02, 0.03), self.value(observed, 0.52, 0.5), self.value(observed, -1.0, 0.0)), (100, 0, -1))
        polygons = answer['polygons']
        self.assertEqual((polygons.floor_status, len(polygons.polygons)), (FloorPlane.FOUND, 1))
        self.assertAlmostEqual(polygons.inflation_radius, 0.2)
        self.assertEqual([(p.x, p.y) for p in polygons.extent.points], [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)])

    def test_what_has_gone_is_gone_after_three_views(self):
        self.ask((1.02, 0.03, 1))
        for views in (1, 2):
            self.assertEqual(self.value(self.ask()['occupancy_grid'], 1.02, 0.03), 100, 'after %d views' % views)
        answer = self.ask()
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 0)
        self.assertEqual(answer['polygons'].polygons, [])

    def test_the_place_is_that_of_the_observations_own_stamp(self):
        half_turn = math.pi / 2
        answer = self.ask((1.02, 0.03, 1), floors=((2.0, 1.0, 0.0, half_turn), (0.0, 0.0, 0.0, 0.0)))
        self.assertEqual(self.value(answer['occupancy_grid'], 2.0 - 0.03, 1.0 + 1.02), 100)

    def test_no_sensor_clears_what_only_the_other_can_see(self):
        # The rear one looks the other way.
        self.ask((1.02, 0.03, 1))
        for _ in range(10):
            answer = self.ask(name='rear')
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 100)

    def test_without_a_floor_nothing_is_cleared(self):
        self.ask((1.02, 0.03, 1))
        for _ in range(5):
            message = self.observation(self.tick())
            message.floor_status = FloorPlane.NOT_FOUND
            self.send(message)
            answer = self.answer(message.header.stamp)
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 100)
        self.assertEqual((answer['polygons'].floor_status, len(answer['polygons'].polygons)), (FloorPlane.NOT_FOUND, 1))

    def test_a_late_sensor_clears_nothing(self):
        self.ask((1.02, 0.03, 1))
        newest = self.tick(5.0)
        self.place(newest)
        self.cells['rear'].publish(self.observation(newest, 'rear'))
        self.answer(newest)
        for k in range(5):
            late = newest - rospy.Duration(1.0 - 0.05 * k)
            self.send(self.observation(late))
            answer = self.answer(late)
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 100)

    def test_the_map_rolls_with_the_robot(self):
        self.ask((1.02, 0.03, 1))
        answer = self.ask(everything_seen=False, robot=(3.0, 0.0))
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 100)
        self.assertAlmostEqual(answer['occupancy_grid'].info.origin.position.x, 0.0, places=5)
        self.ask(everything_seen=False, robot=(5.0, 0.0))
        answer = self.ask(everything_seen=False)
        self.assertEqual(self.value(answer['occupancy_grid'], 1.02, 0.03), 0, 'what has left is forgotten')

    def test_saved_and_loaded_it_is_the_same(self):
        hits = [(0.3 + 0.2 * k, 0.4 * math.sin(k), 1 << k) for k in range(8)]
        before = self.ask(*hits)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'room')
            answer = self.save(path)
            self.assertTrue(answer.success, answer.message)
            saved = json.load(open(path + '.geojson'))
            self.assertEqual(len(saved['features']), len(before['polygons'].polygons))
            self.assertTrue(open(path + '.pgm', 'rb').read().startswith(b'P5'))
            self.assertIn('resolution: 0.05', open(path + '.yaml').read())
            self.clear()
            self.answers.clear()
            answer = self.load(path + '.geojson')
            self.assertTrue(answer.success, answer.message)
        after = self.wait_for(lambda: next((a for a in self.answers.values() if len(a) == len(OUTPUTS)), None), 'the loaded map')
        for name in ('occupancy_grid', 'observed_grid', 'inflated_grid'):
            self.assertEqual(after[name].data, before[name].data, name)
        self.assertEqual(after['polygons'].polygons, before['polygons'].polygons)

    def test_a_file_that_is_no_map_is_refused(self):
        before = self.ask((1.02, 0.03, 1))
        with tempfile.NamedTemporaryFile('w', suffix='.geojson') as file:
            ring = [[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]  # crosses itself
            json.dump({'type': 'FeatureCollection', 'features': [{'type': 'Feature', 'properties': {}, 'geometry': {'type': 'Polygon', 'coordinates': [ring]}}]}, file)
            file.flush()
            answer = self.load(file.name)
        self.assertFalse(answer.success)
        self.assertIn('feature 0, ring 0', answer.message)
        answer = self.load('/nowhere/map.geojson')
        self.assertFalse(answer.success)
        self.assertIn('/nowhere/map.geojson', answer.message)
        self.assertEqual(self.ask(everything_seen=False)['occupancy_grid'].data, before['occupancy_grid'].data, 'the map stays')

    def test_a_map_that_was_drawn_by_hand_is_taken(self):
        self.ask()
        with tempfile.NamedTemporaryFile('w', suffix='.geojson') as file:
            ring = [[0.5, 0.5], [1.0, 0.5], [1.0, 1.0], [0.5, 1.0], [0.5, 0.5]]
            json.dump({'type': 'FeatureCollection', 'features': [{'type': 'Feature', 'properties': {}, 'geometry': {'type': 'Polygon', 'coordinates': [ring]}}]}, file)
            file.flush()
            answer = self.load(file.name)
        self.assertTrue(answer.success, answer.message)
        grid = self.ask(everything_seen=False)['occupancy_grid']
        self.assertEqual((self.value(grid, 0.75, 0.75), self.value(grid, 0.52, 0.98), self.value(grid, 1.2, 0.75)), (100, 100, 0))

    def test_bad_observations_are_refused_by_name(self):
        before = self.ask((1.02, 0.03, 1))
        bad = self.observation(self.tick())
        bad.hit = bad.hit[:-1]
        self.send(bad)
        self.wait_for(lambda: any('front: hit has 1599 cells, accepted is 1600' in text for text in self.logs), 'a complaint')
        other = self.observation(self.tick())
        other.slab_height = 0.1
        self.send(other)
        self.wait_for(lambda: any('slab_height is 0.1' in text for text in self.logs), 'a complaint')
        self.assertEqual(self.ask(everything_seen=False)['occupancy_grid'].data, before['occupancy_grid'].data)

    def test_a_missing_transform_is_told(self):
        message = self.observation(self.tick(2.0))
        self.cells['front'].publish(message)
        self.wait_for(lambda: any('front: no transform from' in text and 'odom' in text for text in self.logs), 'a complaint')
        self.ask()

    def test_a_source_that_waits_for_tf_holds_up_no_other(self):
        here = (0.0, 0.0, 0.0, 0.0)
        waiting = self.observation(self.tick(), 'rear')
        self.cells['rear'].publish(waiting)
        for _ in range(3):
            message = self.observation(self.tick())
            self.send(message, floors=(here,))
            self.answer(message.header.stamp)
        self.assertNotIn(waiting.header.stamp.to_nsec(), self.answers)
        self.place(self.tick())
        self.answer(waiting.header.stamp)

    def test_one_old_observation_does_not_begin_anew(self):
        self.ask((1.02, 0.03, 1))
        old = self.stamp
        newest = self.tick(3.0)
        self.send(self.observation(newest, everything_seen=False))
        self.answer(newest)
        late = old + rospy.Duration(0.02)
        self.send(self.observation(late))
        self.assertEqual(self.value(self.answer(late)['occupancy_grid'], 1.02, 0.03), 100)
        self.assertEqual(self.value(self.ask(everything_seen=False)['occupancy_grid'], 1.02, 0.03), 100)

    def test_a_place_without_a_number_is_refused(self):
        before = self.ask((1.02, 0.03, 1))
        self.send(self.observation(self.tick()), robot=(1e12, 0.0))
        # The log says of a kind what is new each two seconds only.
        self.wait_for(lambda: any('farther than 1000 km' in v.value for s in self.states[-1:] for v in s.values), 'a reason in /diagnostics')
        self.assertEqual(self.ask(everything_seen=False)['occupancy_grid'].data, before['occupancy_grid'].data)

    def test_time_that_jumps_back_begins_anew(self):
        self.ask((1.02, 0.03, 1))
        PolygonMapTest.stamp -= rospy.Duration(60.0)
        def is_told():
            return any('time has jumped back' in text for text in self.logs)
        # One that is old is late and no more; of several the node's queue may keep the last alone.
        end = time.monotonic() + DEADLINE
        while not is_told() and time.monotonic() < end:
            self.send(self.observation(self.tick(), everything_seen=False))
            with self.condition:
                self.condition.wait_for(is_told, 0.5)
        self.assertTrue(is_told(), 'waited %.0f s in vain for a warning; the log: %s' % (DEADLINE, self.logs[-5:]))
        # tf takes nothing that is older until it has been cleared.
        grid = self.ask(everything_seen=False)['occupancy_grid']
        self.assertEqual(self.value(grid, 1.02, 0.03), 0)

    def test_the_documented_parameters_are_the_nodes_own(self):
        table = subprocess.check_output([program('polygon_map_parameters')], text=True)
        text = open(os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../doc/map.md')).read()
        self.assertEqual(text.split('<!-- map parameters: begin -->\n')[1].split('<!-- map parameters: end -->')[0], table)

    def test_diagnostics_name_what_is_wrong(self):
        def state(condition):
            return self.wait_for(lambda: next((s for s in reversed(self.states[-1:]) if condition(s)), None), 'diagnostics; last: %s' % self.states[-1:])

        self.ask(floors=((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.1, 0.0)))
        self.ask(name='rear', floors=((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.1, 0.0)))
        state(lambda s: 'the floor of rear is tilted by 0 degrees against that of front and 0.1 m higher' in s.message)
        state(lambda s: any(v.key == 'Source rear' and v.value.startswith('silent for') for v in s.values))


if __name__ == '__main__':
    rospy.init_node('test_polygon_map')
    rostest.rosrun('polygonal_perception', 'test_polygon_map', PolygonMapTest, sys.argv)
