#!/usr/bin/env python3
"""Nodelets come and go, are changed and misused in a manager that lives on, while frames arrive."""
import sys
import threading
import unittest

import dynamic_reconfigure.client
import rospy
import rostest

import scene
from bad_messages import BAD_VALUES
from launched import Started
from manager_client import ManagerClient
from node_client import DEADLINE, FOUND, Clock, NodeClient
from polygonal_perception.msg import FloorPlane

NODE, OTHER = '/polygonal_perception', '/other_perception'
CAMERA = '/camera/depth/points'


class ReloadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lives = rospy.get_param('~lives')
        cls.client = NodeClient(outputs=(), runs=False)
        cls.camera, cls.clock = scene.Camera(), Clock()
        cls.cloud = cls.camera.cloud(cls.camera.render([scene.Box((1.82, 2.22), (-0.38, 0.12), (0, 0.3))]), cls.clock.now)
        cls.running = threading.Event()
        cls.start_camera()

    @classmethod
    def tearDownClass(cls):
        cls.stop_camera()

    def setUp(self):
        self.manager = ManagerClient(self)

    def tearDown(self):
        self.manager.unload_all()

    @classmethod
    def start_camera(cls):
        cls.running.set()
        cls.publisher = threading.Thread(target=cls.publish)
        cls.publisher.start()

    @classmethod
    def stop_camera(cls):
        cls.running.clear()
        cls.publisher.join()

    @classmethod
    def publish(cls):
        rate = rospy.Rate(30)
        while cls.running.is_set():
            cls.cloud.header.stamp = cls.clock.tick()
            cls.client.send(cls.cloud)
            rate.sleep()

    def load(self, name=NODE, topic='/points'):
        self.manager.load(name, 'PolygonalPerception', {topic: CAMERA})

    def unload(self, name=NODE):
        self.manager.unload(name)

    def wait_for_floors(self, count=1, what='a floor', status=(FOUND,)):
        """Waits for answers to frames from now on, with a fresh reader: rospy may have missed that the topic was away."""
        self.client.answers.clear()
        self.client.read('floor')
        begin = self.clock.now.to_nsec()
        self.client.wait_for(lambda: sum(k > begin and 'floor' in a and a['floor'].status in status
                                         for k, a in self.client.answers.items()) >= count, what)
        self.client.stop_reading('floor')

    def test_every_life_ends_cleanly(self):
        self.client.read('polygons')
        for life in range(self.lives):
            self.load()
            if life % 3 == 2:
                # It lives until it has answered; the others end at once.
                self.wait_for_floors(what='a floor in life %d' % life)
            self.unload()
        self.client.stop_reading('polygons')

    def test_two_in_one_manager(self):
        rospy.set_param(OTHER + '/floor_frame', 'other_floor')
        self.load()
        self.load(OTHER)
        stamps = set()
        other = rospy.Subscriber(OTHER + '/floor', FloorPlane, lambda m: stamps.add(m.header.stamp))
        self.client.wait_for(lambda: stamps, 'the other one')
        self.wait_for_floors()
        self.unload()
        before = len(stamps)
        self.client.wait_for(lambda: len(stamps) > before + 5, 'the other one to go on alone')
        self.unload(OTHER)
        other.unregister()

    def test_a_topic_that_another_one_takes_for_images(self):
        # roscpp throws when a process subscribes to a topic as two types.
        rospy.set_param(OTHER, {'input': 'depth', 'lazy': False, 'floor_frame': 'other_floor'})
        self.load(OTHER, '/depth/image')
        self.load()
        self.client.read('floor')
        self.client.wait_for(lambda: any('cannot subscribe to ' + CAMERA in s.message for s in self.client.diagnostics),
                             'the diagnostics to say so')
        self.client.stop_reading('floor')
        self.unload(OTHER)
        rospy.delete_param(OTHER)
        self.wait_for_floors(what='a floor once the topic is free')
        self.unload()

    def test_a_reader_that_does_not_read_holds_nobody_up(self):
        self.load()
        read_on = threading.Event()
        slow = [rospy.Subscriber(NODE + '/' + name, rospy.AnyMsg, lambda _: read_on.wait())
                for name in ('occupancy_grid', 'inflated_grid', 'markers', 'obstacle_points', 'samples')]
        self.client.wait_for(lambda: all(s.get_num_connections() > 0 for s in slow), 'the slow readers')
        self.wait_for_floors(60, 'floors beside readers that do not read')
        self.unload()
        read_on.set()
        for reader in slow:
            reader.unregister()

    def test_reconfigured_all_the_time(self):
        self.load()
        client = dynamic_reconfigure.client.Client(NODE, timeout=DEADLINE)
        hammering = threading.Event()
        hammering.set()
        sets = [dict(grid_resolution=0.02), dict(samples_x=64, samples_y=16), dict(robot_radius=-1.0), dict(max_height=0.0),
                dict(grid_length=2.0, grid_width=8.0), dict(samples_x=32, samples_y=32, robot_radius=0.5), dict(floor_timeout=0.0),
                dict(grid_resolution=0.05, grid_length=5.0, grid_width=5.0, robot_radius=0.3), dict(floor_timeout=0.5)]
        count = [0]

        def hammer():
            while hammering.is_set():
                client.update_configuration(sets[count[0] % len(sets)])
                count[0] += 1

        thread = threading.Thread(target=hammer)
        thread.start()
        try:
            self.client.read('polygons')
            self.wait_for_floors(60, 'floors between changes')
            self.client.wait_for(lambda: count[0] > 2 * len(sets), 'the changes')
        finally:
            hammering.clear()
            thread.join()
            self.client.stop_reading('polygons')
            client.close()
        self.unload()

    def test_no_parameter_keeps_it_from_starting(self):
        self.load()
        names = [name.rsplit('/', 1)[1] for name in rospy.get_param_names() if name.startswith(NODE + '/')]
        self.assertGreater(len(names), 15)
        self.unload()
        names += ['input', 'floor_frame', 'output_frame', 'up_frame', 'initial_up', 'up_feedback', 'publish_tf', 'lazy',
                  'tf_timeout', 'diagnostic_period', 'disable_pub_plugins']
        for shift, _ in enumerate(BAD_VALUES):
            rospy.delete_param(NODE)
            for i, name in enumerate(names):
                rospy.set_param(NODE + '/' + name, BAD_VALUES[(i + shift) % len(BAD_VALUES)])
            # Those two may name a frame that nobody knows: the answer is then that there is no floor.
            self.load()
            if rospy.get_param(NODE + '/input') != 'depth':
                self.wait_for_floors(1, 'an answer whatever the parameters', status=(FOUND, FloorPlane.NOT_FOUND))
            self.unload()
        rospy.delete_param(NODE)

    def test_parameters_that_are_deleted_or_garbled_change_nothing(self):
        rospy.set_param(NODE + '/diagnostic_period', 0.05)
        self.load()
        self.wait_for_floors()
        for value in BAD_VALUES:
            rospy.set_param(NODE + '/diagnostic_period', value)
            self.wait_for_floors(5, 'floors with a diagnostic_period of %s' % value)
        for value in (5, 'text', [1, 2], {'a': 'b'}):
            rospy.set_param(NODE, value)
            self.wait_for_floors(what='a floor where the namespace is %s' % value)
        # As rosparam delete / does.
        for name in {name.split('/')[1] for name in rospy.get_param_names()}:
            rospy.delete_param('/' + name)
        self.wait_for_floors(what='a floor without parameters')
        self.unload()
        self.load()
        self.wait_for_floors(what='a floor after a start without parameters')
        self.assertEqual(rospy.get_param(NODE + '/robot_radius'), 0.3)
        self.unload()

    def test_the_camera_goes_away_and_comes_back_with_another_size(self):
        self.load()
        self.wait_for_floors()
        self.stop_camera()
        self.client.publishers[0].unregister()
        small = scene.Camera(width=80, rows=60, focal_length=71.0)
        type(self).cloud = small.cloud(small.render(), self.clock.tick())
        self.client.publishers[0] = rospy.Publisher(CAMERA, type(self.cloud), queue_size=10)
        self.start_camera()
        self.wait_for_floors(5, 'floors of the new camera')
        self.unload()

    def test_the_camera_is_killed_and_started_again(self):
        self.load()
        self.stop_camera()
        for _ in range(3):
            with Started(sys.executable, scene.__file__) as camera:
                self.wait_for_floors(5, 'floors of a camera that was started again')
                camera.crash()
        self.clock.now = rospy.Time.now()
        self.start_camera()
        self.wait_for_floors()
        self.unload()


if __name__ == '__main__':
    rospy.init_node('test_reload')
    rostest.rosrun('polygonal_perception', 'test_reload', ReloadTest, sys.argv)
