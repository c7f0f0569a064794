#!/usr/bin/env python3
"""openni2.launch beside a driver with the ways of openni2_camera, played by this test."""
import sys
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from nodelet.srv import NodeletList
from tf2_msgs.msg import TFMessage

import scene
from launched import Launched, Manager
from node_client import DEADLINE, FOUND, Clock, NodeClient

DELAY = 1.0 / 30.0  # openni2_camera's depth_time_offset is -0.033 s
SPEED = 3.0  # [m/s]


class OpenNI2WaysTest(unittest.TestCase):
    def setUp(self):
        self.clock = Clock()
        self.manager = self.start(Manager('camera_nodelet_manager', '/camera'))

    def start(self, program):
        program.__enter__()
        self.addCleanup(program.__exit__)
        return program

    def launch(self, image='image_rect_raw', **args):
        self.start(Launched('openni2.launch', start_driver='false', image='camera/depth/' + image, **args))
        return NodeClient(['floor', 'polygons'], depth=True, image=image)

    @staticmethod
    def wait_for_nodelet(client):
        def is_loaded():
            try:
                nodelets = rospy.ServiceProxy('/camera/camera_nodelet_manager/list', NodeletList)().nodelets
            except rospy.ServiceException:
                return False
            return '/polygonal_perception' in nodelets
        client.wait_for(is_loaded, 'the nodelet in its manager', 2 * DEADLINE)

    def ask(self, client, camera, boxes=(), interval=1.0 / 30.0, **image):
        """Until it is answered: for a moment after a change an image may meet the old camera_info."""
        depth = camera.render(boxes)

        def messages():
            stamp = self.clock.tick(interval)
            frame = image.get('frame', scene.OPTICAL_FRAME)
            return camera.image(depth, stamp, **image), camera.info(stamp, frame)
        return client.ask_until_answered(messages)

    def check(self, answer, camera):
        floor = answer['floor']
        self.assertEqual(floor.status, FOUND)
        self.assertAlmostEqual(floor.distance, camera.height, delta=0.01)
        self.assertLess(np.abs(camera.floor_normal - [floor.normal.x, floor.normal.y, floor.normal.z]).max(), 0.01)

    def test_the_size_and_the_rate_change_at_run_time(self):
        client = self.launch()
        vga = scene.Camera(width=640, rows=480, focal_length=570.0)
        qvga = scene.Camera(width=320, rows=240, focal_length=285.0)
        for camera, interval in [(vga, 1 / 30.0), (qvga, 1 / 30.0), (qvga, 1 / 60.0), (qvga, 11 / 30.0), (vga, 11 / 30.0)]:
            for _ in range(3):
                self.check(self.ask(client, camera, interval=interval), camera)

    def test_metres(self):
        client, camera = self.launch(image='image_rect'), scene.Camera()
        self.check(self.ask(client, camera, encoding='32FC1'), camera)

    def test_depth_becomes_registered_at_run_time(self):
        client, camera = self.launch(), scene.Camera()
        for frame in ['camera_depth_optical_frame', 'camera_rgb_optical_frame', 'camera_depth_optical_frame']:
            answer = self.ask(client, camera, frame=frame)
            self.check(answer, camera)
            self.assertEqual(answer['floor'].header.frame_id, frame)

    def test_a_stamp_is_older_than_the_newest_transform(self):
        client, camera = self.launch(output_frame='odom'), scene.Camera()
        tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        client.wait_for(lambda: tf.get_num_connections() >= 2, 'the node to listen to tf')
        start = self.clock.now

        def place(stamp):
            """The camera's x in odom: to and fro over 1.5 m."""
            gone = SPEED * (stamp - start).to_sec() % 3.0
            return gone if gone < 1.5 else 3.0 - gone

        def messages():
            """A frame that comes with the transform of a moment later. A box stands 3 m ahead of odom's origin."""
            stamp = self.clock.tick(DELAY)
            pose = TransformStamped(child_frame_id=scene.OPTICAL_FRAME)
            pose.header.stamp, pose.header.frame_id = stamp + rospy.Duration(DELAY), 'odom'
            pose.transform.translation.x, pose.transform.translation.z = place(pose.header.stamp), camera.height
            # The optical axis along x; of a pitch x, y and yaw know nothing.
            q = pose.transform.rotation
            q.x, q.y, q.z, q.w = -0.5, 0.5, -0.5, 0.5
            tf.publish(TFMessage([pose]))
            x = 3.0 - place(stamp)
            return camera.image(camera.render([scene.Box((x, x + 0.2), (-0.1, 0.1), (0, 0.3))]), stamp), camera.info(stamp)

        for _ in range(10):
            polygons = client.ask_until_answered(messages)['polygons']
            self.assertEqual(polygons.header.frame_id, 'odom')
            self.assertEqual(len(polygons.polygons), 1)
            front = min(p.x for p in polygons.polygons[0].boundary.points)
            # robot_radius before the box, and up to a cell and the tolerance more. By the newest transform it would be
            # SPEED * DELAY = 0.1 m farther on the way there.
            self.assertLess(front, 3.0 - 0.3 + 0.02)
            self.assertGreater(front, 3.0 - 0.3 - 0.12)

    def test_the_driver_dies_and_comes_back(self):
        client, camera = self.launch(respawn='true'), scene.Camera()
        self.check(self.ask(client, camera), camera)
        for _ in range(2):
            self.manager.crash()
            self.manager = self.start(Manager('camera_nodelet_manager', '/camera'))
            self.wait_for_nodelet(client)
            # Only a new reader of rospy's notices that its topic has moved.
            for name in ['floor', 'polygons']:
                client.stop_reading(name)
                client.read(name)
            client.answers.clear()
            self.check(self.ask(client, camera), camera)


if __name__ == '__main__':
    rospy.init_node('test_openni2_ways')
    rostest.rosrun('polygonal_perception', 'test_openni2_ways', OpenNI2WaysTest, sys.argv)
