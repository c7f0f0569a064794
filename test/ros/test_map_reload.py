#!/usr/bin/env python3
"""The map's nodelet comes and goes beside the one whose cells it reads, is changed and misused, while messages arrive."""
import itertools
import os
import sys
import tempfile
import threading
import unittest

import dynamic_reconfigure.client
import rospy
import rostest

from bad_messages import BAD_VALUES, CELLS
from manager_client import ManagerClient
from node_client import DEADLINE, Clock
from polygonal_perception.srv import MapFile
from subjects import Map, Perception

MAP, OTHER_MAP, CAMERA = Map.NAME, '/other_map', Perception.NAME


class MapReloadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lives = rospy.get_param('~lives')
        cls.subject = Map(outputs=(), runs=False)
        cls.camera = Perception(outputs=(), runs=False)
        cls.client, cls.clock = cls.subject.client, Clock()
        cls.running = threading.Event()
        cls.running.set()
        cls.sender = threading.Thread(target=cls.send)
        cls.sender.start()

    @classmethod
    def tearDownClass(cls):
        cls.running.clear()
        cls.sender.join()

    @classmethod
    def send(cls):
        """Cells, each third ones bad, and the clouds of a camera."""
        rate = rospy.Rate(60)
        spoilers = itertools.cycle(row[0] for row in CELLS.values())
        for count in itertools.count():
            if not cls.running.is_set():
                return
            stamp = cls.clock.tick()
            if count % 4 == 0:
                cls.camera.client.send(*cls.camera.messages(stamp))
            messages = cls.subject.messages(stamp)
            if count % 3 == 2:
                next(spoilers)(messages[0])
            cls.client.send(*messages)
            rate.sleep()

    def setUp(self):
        self.manager = ManagerClient(self)
        for name in (MAP, OTHER_MAP):
            rospy.set_param(name, {'tf_timeout': 0.5})

    def tearDown(self):
        self.manager.unload_all()

    def load(self, name=MAP, cells='/observed_cells'):
        self.manager.load(name, Map.NODELET, {'/observed_cells': cells})

    def load_camera(self):
        self.manager.load(CAMERA, Perception.NODELET, {'/points': '/camera/depth/points'})

    def wait_for_maps(self, count=1, what='a map'):
        """Waits for answers to cells from now on, with a fresh reader: rospy may have missed that the topic was away."""
        self.client.answers.clear()
        self.client.read('polygons')
        begin = self.clock.now.to_nsec()
        self.client.wait_for(lambda: sum(k > begin and 'polygons' in a and self.subject.is_good(a)
                                         for k, a in list(self.client.answers.items())) >= count, what)
        self.client.stop_reading('polygons')

    def test_every_life_ends_cleanly(self):
        self.client.read('inflated_grid')
        for life in range(self.lives):
            self.load()
            if life % 3 == 2:
                # It lives until it has answered; the others end at once.
                self.wait_for_maps(what='a map in life %d' % life)
            self.manager.unload(MAP)
        self.client.stop_reading('inflated_grid')

    def test_beside_the_nodelet_whose_cells_it_reads(self):
        """Both come and go, in every order. Only the cells that come from tests have a place: those of the camera are refused."""
        for life in range(self.lives):
            first, second = (self.load_camera, lambda: self.load(OTHER_MAP, CAMERA + '/observed_cells'))[::1 if life % 2 else -1]
            self.load()
            first()
            second()
            if life % 5 == 4:
                self.wait_for_maps(what='a map in life %d' % life)
                self.client.wait_for(lambda: any('/other_map' in log.name or 'other_map' in log.msg for log in self.client.logs),
                                     'the other map to say that its cells have no place')
            for name in ((CAMERA, MAP, OTHER_MAP) if life % 3 else (OTHER_MAP, MAP, CAMERA)):
                self.manager.unload(name)

    def test_reconfigured_all_the_time(self):
        self.load()
        client = dynamic_reconfigure.client.Client(MAP, timeout=DEADLINE)
        sets = [dict(map_size=4.0), dict(robot_radius=-1.0), dict(robot_radius=1.0), dict(simplification_tolerance=0.2), dict(map_size=0.0),
                dict(clear_views=1, remember=0.1), dict(map_size=20.0, robot_radius=0.0), dict(max_delay=0.0), dict(remember=float('inf')),
                dict(map_size=12.0, clear_views=3, robot_radius=0.3, max_delay=0.3)]
        hammering, count = threading.Event(), [0]
        hammering.set()

        def hammer():
            while hammering.is_set():
                client.update_configuration(sets[count[0] % len(sets)])
                count[0] += 1

        thread = threading.Thread(target=hammer)
        thread.start()
        try:
            self.wait_for_maps(60, 'maps between changes')
            self.client.wait_for(lambda: count[0] > 2 * len(sets), 'the changes')
        finally:
            hammering.clear()
            thread.join()
            client.close()

    def test_saved_and_loaded_all_the_time(self):
        self.load()
        self.wait_for_maps()
        save, load = (rospy.ServiceProxy(MAP + '/' + name, MapFile) for name in ('save', 'load'))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'map.geojson')
            for _ in range(20):
                for call in (save, load):
                    answer = call(path)
                    self.assertTrue(answer.success, answer.message)
            self.wait_for_maps(5)

    def test_no_parameter_keeps_it_from_starting(self):
        names = ['sources', 'fixed_frame', 'robot_frame', 'tf_timeout', 'max_delay', 'map_size', 'clear_views', 'remember', 'robot_radius',
                 'simplification_tolerance', 'diagnostic_period']
        for shift, _ in enumerate(BAD_VALUES):
            rospy.delete_param(MAP)
            values = {name: BAD_VALUES[(i + shift) % len(BAD_VALUES)] for i, name in enumerate(names)}
            for name, value in values.items():
                rospy.set_param(MAP + '/' + name, value)
            self.load()
            # Of these any text is a name, and then nobody sends what it waits for.
            if 'much' not in (values['fixed_frame'], values['robot_frame']) and not isinstance(values['sources'], list):
                self.wait_for_maps(1, 'a map whatever the parameters: %s' % values)
            self.manager.unload(MAP)


if __name__ == '__main__':
    rospy.init_node('test_map_reload')
    rostest.rosrun('polygonal_perception', 'test_map_reload', MapReloadTest, sys.argv)
