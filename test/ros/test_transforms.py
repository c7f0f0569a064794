#!/usr/bin/env python3
"""up_frame and output_frame: right at the frame's stamp, patient with late transforms, and never made up."""
import math
import sys
import time
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker

import scene
from node_client import FOUND, NOT_FOUND, OUTPUTS, Clock, NodeClient

IN_INPUT_FRAME = ['floor', 'floor_coefficients', 'planes', 'samples']
ELSEWHERE = ['markers', 'scan']  # deleted ones, and the floor frame, whose place in the output frame nobody needs


class TransformsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient(OUTPUTS)
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        cls.client.wait_for(lambda: cls.tf.get_num_connections() >= 2, 'the node to listen to tf')
        cls.clock = Clock()
        # Held upside down: from initial_up the ceiling side would be up.
        cls.camera = scene.Camera(height=0.8, pitch=0.3, roll=0.1, upside_down=True)
        cls.boxes = [scene.Box((1.82, 2.22), (-0.38, 0.12), (0, 0.3))]

    def setUp(self):
        # Far from the stamps of the test before.
        self.clock.tick(100.0)
        self.client.reset()

    def pose(self, stamp, x, y, yaw, child=scene.OPTICAL_FRAME):
        """The camera at x, y, yaw in odom, 0.8 m up, as it is held."""
        turn = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
        message = TransformStamped(child_frame_id=child)
        message.header.stamp, message.header.frame_id = stamp, 'odom'
        t, r = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = x, y, self.camera.height
        r.x, r.y, r.z, r.w = scene.quaternion_of(turn @ self.camera.rotation)
        return message

    def send_pose(self, *args):
        self.tf.publish(TFMessage([self.pose(*args)]))

    def wait_for_rejection(self, *texts):
        return self.client.wait_for_diagnostics(
            lambda s: any(v.key == 'Last rejection' and all(text in v.value for text in texts) for v in s.values),
            'a rejection with %s' % (texts,))

    def cloud(self, stamp):
        return self.camera.cloud(self.camera.render(self.boxes), stamp)

    def check_placed(self, answer, x, y, yaw):
        self.assertEqual(answer['floor'].status, FOUND)
        for name in ('occupancy_grid', 'inflated_grid', 'polygons', 'obstacle_points'):
            self.assertEqual(answer[name].header.frame_id, 'odom')
        c, s = math.cos(yaw), math.sin(yaw)
        turn, shift = np.array([[c, -s], [s, c]]), np.array([x, y])
        origin = answer['occupancy_grid'].info.origin
        np.testing.assert_allclose([origin.position.x, origin.position.y], turn @ [0.0, -2.5] + shift, atol=0.01)
        self.assertEqual(origin.position.z, 0.0)
        self.assertAlmostEqual(2 * math.atan2(origin.orientation.z, origin.orientation.w), yaw, delta=0.004)
        # The face of the box that the camera sees, and the outline around the box.
        points = np.frombuffer(answer['obstacle_points'].data, np.float32).reshape(-1, 3)
        local = (points[:, :2] - shift) @ turn
        self.assertAlmostEqual(local[:, 0].min(), 1.82, delta=0.02)
        self.assertAlmostEqual(local[:, 1].min(), -0.38, delta=0.04)
        self.assertAlmostEqual(local[:, 1].max(), 0.12, delta=0.04)
        self.assertAlmostEqual(points[:, 2].max(), 0.3, delta=0.02)
        polygon, = answer['polygons'].polygons
        ring = [((np.array([p.x, p.y]) - shift) @ turn).tolist() for p in polygon.boundary.points]
        for corner in [(1.82, -0.38), (1.82, 0.12), (1.55, -0.1), (1.9, 0.38)]:
            self.assertTrue(scene.inside(corner, ring), (corner, ring))
        for corner in [(1.3, -0.1), (1.9, 0.65), (1.9, -0.9)]:
            self.assertFalse(scene.inside(corner, ring), (corner, ring))
        extent = [(np.array([p.x, p.y]) - shift) @ turn for p in answer['polygons'].extent.points]
        np.testing.assert_allclose(extent, [(0.0, -2.5), (5.0, -2.5), (5.0, 2.5), (0.0, 2.5)], atol=1e-4)
        outline = next(m for m in answer['markers'].markers if m.ns == 'polygons/outline')
        self.assertEqual(outline.header.frame_id, 'odom')
        self.assertAlmostEqual(outline.points[0].x, polygon.boundary.points[0].x, places=4)

    def test_outputs_are_where_the_robot_is_at_the_stamp(self):
        for x, y, yaw in [(3.0, -2.0, 0.7), (-1.0, 4.0, -2.5)]:
            before, stamp, after = self.clock.tick(), self.clock.tick(), self.clock.tick()
            # Half way between the two, the pose is right in the middle.
            self.send_pose(before, x - 0.1, y, yaw - 0.1)
            self.send_pose(after, x + 0.1, y, yaw + 0.1)
            self.client.send(self.cloud(stamp))
            self.check_placed(self.client.answer(stamp), x, y, yaw)

    def test_a_camera_that_stands_still(self):
        message = self.pose(rospy.Time(1), 5.0, 6.0, 1.0, child='static_camera')
        static = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        static.publish(TFMessage([message]))
        self.client.wait_for(lambda: static.get_num_connections() > 0, 'the node to listen to static transforms')
        answer = self.client.ask(self.camera.cloud(self.camera.render(self.boxes), self.clock.tick(), 'static_camera'))
        self.assertEqual(answer['floor'].header.frame_id, 'static_camera')
        self.check_placed(answer, 5.0, 6.0, 1.0)

    def test_a_driver_that_turns_to_another_frame_and_its_axes(self):
        """First the optical frame, then the body's with x ahead: what was ahead in the one is up in the other."""
        self.send_pose(self.clock.tick(), 0, 0, 0)
        stamp = self.clock.tick()
        self.send_pose(self.clock.tick(), 0, 0, 0)
        self.client.send(self.cloud(stamp))
        self.check_placed(self.client.answer(stamp), 0, 0, 0)

        to_body = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]], np.float32)
        before, stamp, after = self.clock.tick(), self.clock.tick(), self.clock.tick()
        for when in (before, after):
            message = scene.transform('odom', 'body_camera', (0, 0, self.camera.height),
                                      self.camera.rotation @ to_body.T)
            message.header.stamp = when
            self.tf.publish(TFMessage([message]))
        cloud = self.cloud(stamp)
        cloud.header.frame_id = 'body_camera'
        points = np.frombuffer(cloud.data, np.float32).reshape(-1, 4).copy()
        points[:, :3] = points[:, :3] @ to_body.T
        cloud.data = points.tobytes()
        self.client.send(cloud)
        self.check_placed(self.client.answer(stamp), 0, 0, 0)

    def test_a_frame_waits_for_a_late_transform(self):
        self.send_pose(self.clock.tick(), 0, 0, 0)
        stamp = self.clock.tick()
        self.client.send(self.cloud(stamp))
        self.send_pose(self.clock.tick(), 1.0, 2.0, 0.5)
        # The pose at the stamp lies between the two.
        answer = self.client.answer(stamp)
        self.assertEqual(answer['occupancy_grid'].header.frame_id, 'odom')
        self.assertEqual(answer['floor'].status, FOUND)

    def test_other_calls_are_answered_while_a_frame_waits(self):
        def time_of_a_call():
            self.client.send(self.cloud(self.clock.tick()))
            start = time.monotonic()
            self.assertTrue(self.client.reset().success)
            return time.monotonic() - start
        # A busy machine may hold one up, too.
        self.assertLess(min(time_of_a_call() for _ in range(5)), 0.9, 'tf_timeout is 1 s here')

    def test_without_the_seed_there_is_no_floor_and_no_guess(self):
        stamp = self.clock.tick()
        self.client.send(self.camera.cloud(self.camera.render(self.boxes), stamp, frame='unknown_camera'))
        answer = self.client.answer(stamp, ['floor', 'floor_coefficients', 'markers'])
        self.assertEqual(answer['floor'].status, NOT_FOUND)
        # Everything for this stamp is published at once: what is not there now will not come.
        self.assertLessEqual(set(self.client.answered(stamp)), {'floor', 'floor_coefficients', 'planes', *ELSEWHERE})
        status = self.wait_for_rejection('no transform from', "'unknown_camera'", "'odom'", '%d.' % stamp.secs)
        self.assertGreater(int(next(v.value for v in status.values if v.key == 'Frames rejected')), 0)

        # The log is throttled, so that the frame may have to come again.
        def complained():
            self.client.send(self.camera.cloud(self.camera.render(self.boxes), self.clock.tick(), frame='unknown_camera'))
            return any('no transform from' in log.msg and "'unknown_camera'" in log.msg for log in self.client.logs)
        self.client.wait_for(complained, 'a complaint in the log')

    def test_a_floor_that_tf_does_not_call_level_is_refused(self):
        """The driver's frame_id is another than that of its points: their up is far from where tf has it."""
        before, stamp, after = self.clock.tick(), self.clock.tick(), self.clock.tick()
        for when in (before, after):
            message = scene.transform('odom', 'wrong_camera', (0, 0, 0.8))
            message.header.stamp = when
            self.tf.publish(TFMessage([message]))
        self.client.send(self.camera.cloud(self.camera.render(self.boxes), stamp, frame='wrong_camera'))
        self.assertEqual(self.client.answer(stamp, ['floor'])['floor'].status, NOT_FOUND)
        self.client.wait_for_diagnostics(
            lambda s: any(v.key == 'Floor not seen because' and "frame_id or tf is wrong" in v.value for v in s.values),
            'the reason')

    def test_a_seed_of_two_minutes_ago_is_none(self):
        before, stamp, after = self.clock.tick(), self.clock.tick(), self.clock.tick()
        self.send_pose(before, 0, 0, 0)
        self.send_pose(after, 0, 0, 0)
        self.assertEqual(self.client.ask(self.cloud(stamp))['floor'].status, FOUND)
        self.client.reset()
        stamp = self.clock.tick(120.0)
        self.client.send(self.cloud(stamp))
        self.assertEqual(self.client.answer(stamp, ['floor'])['floor'].status, NOT_FOUND)
        self.wait_for_rejection('no transform from', 'extrapolation', '%d.' % stamp.secs)

    def test_transforms_of_before_a_jump_back_are_forgotten(self):
        stamps = [self.clock.tick() for _ in range(6)]
        for stamp in stamps:
            self.send_pose(stamp, 1.0, 2.0, 0.0)
        self.client.ask(self.cloud(stamps[4]))
        # The second run of a simulation, say: where the robot was at this time in the first one says nothing.
        self.client.send(self.cloud(stamps[2]))
        answer = self.client.answer(stamps[2], ['floor', 'floor_coefficients', 'markers'])
        self.assertEqual(answer['floor'].status, NOT_FOUND)
        self.assertLessEqual(set(self.client.answered(stamps[2])), {'floor', 'floor_coefficients', 'planes', *ELSEWHERE})
        self.wait_for_rejection('no transform from', '%d.' % stamps[2].secs)

    def test_a_floor_without_a_place_is_published_alone(self):
        # The seed is there once; then localisation stops.
        before, stamp, after = self.clock.tick(), self.clock.tick(), self.clock.tick()
        self.send_pose(before, 0, 0, 0)
        self.send_pose(after, 0, 0, 0)
        self.client.ask(self.cloud(stamp))
        self.clock.tick(0.2)
        lost = self.clock.tick()
        self.client.send(self.cloud(lost))
        answer = self.client.answer(lost, [*IN_INPUT_FRAME, *ELSEWHERE])
        self.assertEqual(answer['floor'].status, FOUND)
        actions = {m.ns: m.action for m in answer['markers'].markers}
        self.assertEqual(actions, {'polygons/fill': Marker.DELETE, 'polygons/outline': Marker.DELETE,
                                   'floor/normal': Marker.ADD, 'floor/hull': Marker.ADD}, 'the polygons before are gone')
        self.assertLessEqual(set(self.client.answered(lost)), {*IN_INPUT_FRAME, *ELSEWHERE})
        self.wait_for_rejection('no transform from', 'extrapolation', '%d.' % lost.secs)


if __name__ == '__main__':
    rospy.init_node('test_transforms')
    rostest.rosrun('polygonal_perception', 'test_transforms', TransformsTest, sys.argv)
