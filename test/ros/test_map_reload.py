#!/usr/bin/env python3
"""The map's nodelet comes and goes beside the one whose cells it reads, is changed and misused, while messages arrive."""
import os
import sys
import tempfile
import unittest

import rospy
import rostest

from bad_messages import CELLS
from polygonal_perception.srv import MapFile
from reload_checks import ReloadChecks
from subjects import Map, Perception

MAP, OTHER_MAP, CAMERA = Map.NAME, '/other_map', Perception.NAME


class MapReloadTest(ReloadChecks, unittest.TestCase):
    SUBJECT = Map
    SPOILERS = [row[0] for row in CELLS.values()]
    CHANGES = [dict(map_size=4.0), dict(robot_radius=-1.0), dict(robot_radius=1.0), dict(simplification_tolerance=0.2), dict(map_size=0.0),
               dict(clear_views=1, remember=0.1), dict(map_size=20.0, robot_radius=0.0), dict(max_delay=0.0), dict(remember=float('inf')),
               dict(map_size=12.0, clear_views=3, robot_radius=0.3, max_delay=0.3)]
    PARAMETERS = ['sources', 'fixed_frame', 'robot_frame', 'tf_timeout', 'max_delay', 'map_size', 'clear_views', 'remember', 'robot_radius',
                  'simplification_tolerance', 'diagnostic_period']

    @classmethod
    def setUpClass(cls):
        cls.camera = Perception(outputs=(), runs=False)
        super().setUpClass()

    @classmethod
    def send_besides(cls, count, stamp):
        if count % 4 == 0:
            cls.camera.client.send(*cls.camera.messages(stamp))

    def setUp(self):
        super().setUp()
        rospy.set_param(OTHER_MAP, {'tf_timeout': 0.5})

    def test_beside_the_nodelet_whose_cells_it_reads(self):
        """Both come and go, in every order. Only the cells that come from tests have a place: those of the camera are refused."""
        def load_camera():
            self.manager.load(CAMERA, Perception.NODELET, {'/points': '/camera/depth/points'})

        def load_other_map():
            self.manager.load(OTHER_MAP, Map.NODELET, {'/observed_cells': CAMERA + '/observed_cells'})

        for life in range(self.lives):
            first, second = (load_camera, load_other_map)[::1 if life % 2 else -1]
            self.load()
            first()
            second()
            if life % 5 == 4:
                self.wait_for_answers(what='a map in life %d' % life)
                self.client.wait_for(lambda: any('/other_map' in log.name or 'other_map' in log.msg for log in self.client.logs),
                                     'the other map to say that its cells have no place')
            for name in ((CAMERA, MAP, OTHER_MAP) if life % 3 else (OTHER_MAP, MAP, CAMERA)):
                self.manager.unload(name)

    def test_saved_and_loaded_all_the_time(self):
        self.load()
        self.wait_for_answers()
        save, load = (rospy.ServiceProxy(MAP + '/' + name, MapFile) for name in ('save', 'load'))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'map.geojson')
            for _ in range(20):
                for call in (save, load):
                    answer = call(path)
                    self.assertTrue(answer.success, answer.message)
            self.wait_for_answers(5)


if __name__ == '__main__':
    rospy.init_node('test_map_reload')
    rostest.rosrun('polygonal_perception', 'test_map_reload', MapReloadTest, sys.argv)
