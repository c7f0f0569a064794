#!/usr/bin/env python3
"""Starts each launch file as a user does and looks at what comes out."""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import rosbag
import rospy
import rostest
import yaml
from tf2_msgs.msg import TFMessage

import scene
from launched import Launched, Manager
from node_client import FOUND, Clock, NodeClient

from polygonal_perception.msg import FloorPlane


def config(name):
    return os.path.join(os.path.dirname(__file__), '..', '..', 'config', name)


class LaunchTest(unittest.TestCase):
    def check_frames(self, client, camera, count=3):
        clock = Clock()
        for _ in range(count):
            answer = client.ask_until_answered(lambda: [camera.cloud(camera.render(), clock.tick())])
            self.assertEqual(answer['floor'].status, FOUND)

    def test_with_its_own_manager(self):
        with Launched('polygonal_perception.launch', config=config('nao.yaml')):
            client = NodeClient(['floor', 'polygons'])
            camera = scene.Camera(height=0.5)
            tf = rospy.Publisher('/tf_static', TFMessage, queue_size=10, latch=True)
            tf.publish(TFMessage([scene.transform('odom', 'base_footprint'),
                                  scene.transform('base_footprint', scene.OPTICAL_FRAME, camera.position, camera.rotation)]))
            client.wait_for(lambda: tf.get_num_connections() > 0, 'the node to listen to tf')
            self.check_frames(client, camera)
            self.assertEqual(rospy.get_param('/polygonal_perception/robot_radius'), 0.21)

    def test_in_a_manager_that_runs(self):
        with Manager('driver'), Launched('polygonal_perception.launch', manager='driver'):
            client = NodeClient(['floor', 'polygons'])
            self.check_frames(client, scene.Camera())

    def test_the_replay_begins_again_and_again(self):
        camera = scene.Camera(width=160, rows=120)
        stamps = [rospy.Time(1000 + k / 10.0) for k in range(15)]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'frames.bag')
            with rosbag.Bag(path, 'w') as bag:
                for stamp in stamps:
                    bag.write('/camera/depth/image_raw', camera.image(camera.render(), stamp), stamp)
                    bag.write('/camera/depth/camera_info', camera.info(stamp), stamp)
            with Launched('replay.launch', bag=path, rviz='false', rate='3'):
                client = NodeClient(outputs=())
                client.read('floor')
                for _ in range(3):
                    # The same frame once more. It is one of the middle: of those at a turn not every one arrives.
                    self.assertEqual(client.answer(stamps[8])['floor'].status, FOUND)
                    client.answers.clear()
                client.wait_for_log('time has jumped back')

    def test_a_robots_map_and_frames_have_one_radius(self):
        for robot in ('robotino', 'nao'):
            text = subprocess.check_output(['roslaunch', '--dump-params', 'polygonal_perception', robot + '.launch',
                                            'simulation:=true', 'map:=true'], text=True)
            values = yaml.safe_load(text)
            self.assertEqual(values['/polygon_map/robot_radius'], values['/polygonal_perception/robot_radius'], robot)

    @unittest.skipUnless(rospy.get_param('/has_simulation', False), 'built without Embree')
    def test_the_demo_finds_the_true_floor(self):
        with Launched('demo.launch', rviz='false', rate='10'):
            client = NodeClient(outputs=())
            truth = {}

            def keep(message):
                truth[message.header.stamp.to_nsec()] = message
            reader = client.listen('/simulated_camera/ground_truth/floor', FloorPlane, keep)
            client.read('floor')
            client.read('polygons')

            def both():
                return [k for k in truth if {'floor', 'polygons'} <= set(client.answers.get(k, {}))]
            # Before a wall the demo's robot sees no floor.
            def with_floor():
                return [k for k in both() if client.answers[k]['floor'].status == FOUND]
            client.wait_for(lambda: len(with_floor()) >= 10, 'ten floors with their truth', 30.0)
            reader.unregister()
            self.assertGreaterEqual(2 * len(with_floor()), len(both()), 'floors found, of all answers')
            tilts, heights = [], []
            for key in with_floor():
                true, found = truth[key], client.answers[key]['floor']
                cosine = np.dot([true.normal.x, true.normal.y, true.normal.z],
                                [found.normal.x, found.normal.y, found.normal.z])
                tilts.append(np.degrees(np.arccos(min(cosine, 1.0))))
                heights.append(abs(found.distance - true.distance))
            # Of the last strip of floor before a wall nobody knows the tilt to a degree.
            self.assertLess(np.median(tilts), 0.2, tilts)
            self.assertLess(np.median(heights), 0.003, heights)
            self.assertLess(max(tilts), 5.0, tilts)
            self.assertLess(max(heights), 0.05, heights)
            self.assertTrue(any(client.answers[k]['polygons'].polygons for k in with_floor()))


if __name__ == '__main__':
    rospy.init_node('test_launch')
    rostest.rosrun('polygonal_perception', 'test_launch', LaunchTest, sys.argv)
