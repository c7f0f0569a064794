#!/usr/bin/env python3
"""A driving node that runs, tick by tick of simulated time: commands, reasons and markers out."""
import math
import os
import subprocess
import sys
import threading
import unittest

import rospy
import rostest
from dynamic_reconfigure.msg import Config
from dynamic_reconfigure.srv import Reconfigure
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from nav_msgs.msg import Odometry, Path
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from bad_messages import set_to, within
from launched import program
from path_client import polygon, polygons
from polygonal_perception.msg import DriveStatus, FloorPlane, ObstaclePolygon, PolygonArray, TrackedPolygon, TrackedPolygonArray
from waiting import DEADLINE, wait_for

NODE = '/dynamic_window'
PERIOD = 0.05  # [s]
WALL = ((2.0, -3.0), (2.5, -3.0), (2.5, 3.0), (2.0, 3.0))
AHEAD = ((0.0, 0.0), (1.9, 0.0))


class Robot:
    """Does what it is told, within its limits."""

    def __init__(self):
        self.x = self.y = self.yaw = self.v = self.w = 0.0

    def follow(self, command):
        self.v += max(-1.0 * PERIOD, min(1.0 * PERIOD, command.linear.x - self.v))
        self.w += max(-3.0 * PERIOD, min(3.0 * PERIOD, command.angular.z - self.w))
        self.yaw += self.w * PERIOD
        self.x += self.v * math.cos(self.yaw) * PERIOD
        self.y += self.v * math.sin(self.yaw) * PERIOD


class DynamicWindowTest(unittest.TestCase):
    now = 100.0  # [s] simulated

    @classmethod
    def setUpClass(cls):
        cls.condition = threading.Condition()
        cls.commands, cls.answers = [], {}
        cls.readers = [rospy.Subscriber('/cmd_vel', Twist, cls.on_command, queue_size=50),
                       rospy.Subscriber(NODE + '/status', DriveStatus, cls.keep, 'status', queue_size=50),
                       rospy.Subscriber(NODE + '/markers', MarkerArray, cls.keep, 'markers', queue_size=50)]
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        cls.inputs = {name: rospy.Publisher('/' + name, kind, queue_size=10)
                      for name, kind in (('polygons', PolygonArray), ('tracked_polygons', TrackedPolygonArray), ('path', Path),
                                         ('odom', Odometry), ('tf', TFMessage))}
        ends = [*cls.readers, cls.clock, *cls.inputs.values()]
        cls.wait_for(lambda: all(end.get_num_connections() > 0 for end in ends), 'connections')
        cls.read_all = rospy.ServiceProxy(NODE + '/set_parameters', Reconfigure)
        # The node's clock starts with the first tick.
        cls.wait_for(lambda: cls.advance() or cls.commands, 'the first command')
        cls.wait_for(lambda: cls.answers.get(round(cls.now, 3)), 'the last of them')

    @classmethod
    def on_command(cls, message):
        with cls.condition:
            cls.commands.append(message)
            cls.condition.notify_all()

    @classmethod
    def keep(cls, message, name):
        header = message.markers[0].header if name == 'markers' else message.header
        with cls.condition:
            cls.answers.setdefault(round(header.stamp.to_sec(), 3), {})[name] = message
            cls.condition.notify_all()

    @classmethod
    def wait_for(cls, condition, what):
        return wait_for(cls.condition, condition, what, DEADLINE)

    @classmethod
    def advance(cls):
        DynamicWindowTest.now += PERIOD
        cls.clock.publish(Clock(rospy.Time.from_sec(cls.now)))

    @staticmethod
    def header_of(message, frame, stamp):
        message.header.frame_id, message.header.stamp = frame, rospy.Time.from_sec(stamp)
        return message

    def path(self, points, yaw=0.0, frame='odom'):
        message = self.header_of(Path(), frame, self.now + PERIOD)
        for x, y in points:
            pose = PoseStamped()
            pose.pose.position.x, pose.pose.position.y = x, y
            pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
            message.poses.append(pose)
        return message

    def odometry(self, robot):
        message = self.header_of(Odometry(), 'odom', self.now + PERIOD)
        message.pose.pose.position.x, message.pose.pose.position.y = robot.x, robot.y
        message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(robot.yaw / 2.0), math.cos(robot.yaw / 2.0)
        message.twist.twist.linear.x, message.twist.twist.angular.z = robot.v, robot.w
        return message

    def person(self, x, y, velocity):
        message = self.header_of(TrackedPolygonArray(), 'odom', self.now + PERIOD)
        one = TrackedPolygon(id=1, inflation_radius=0.3)
        one.polygon = ObstaclePolygon(boundary=polygon([(x - 0.4, y - 0.4), (x + 0.4, y - 0.4), (x + 0.4, y + 0.4), (x - 0.4, y + 0.4)]))
        one.velocity.x, one.velocity.y = velocity
        message.polygons = [one]
        return message

    def nobody(self):
        message = self.person(0.0, 0.0, (0.0, 0.0))
        message.polygons = []
        return message

    def tick(self, robot, path=AHEAD, boxes=(WALL,), **changed):
        """All inputs of a tick, but for those that are changed, or None: not sent. @return its command, status and markers"""
        stamp = self.now + PERIOD
        messages = dict(polygons=polygons(rospy.Time.from_sec(stamp), 'odom', boxes), odom=self.odometry(robot), tracked_polygons=self.nobody(),
                        path=path if isinstance(path, Path) else self.path(path))
        messages.update(changed)
        for name, message in messages.items():
            if message is not None:
                self.inputs[name].publish(message)
        return self.command()

    def command(self):
        count = len(self.commands)
        # The inputs of a tick come before its clock does. One thread of the node reads all of its connections: when it has
        # answered a request it has read what came before.
        self.read_all(Config())
        self.advance()
        key = round(self.now, 3)
        self.wait_for(lambda: len(self.commands) > count and len(self.answers.get(key, {})) == 2, 'a command at %s' % key)
        self.assertEqual(len(self.commands), count + 1, 'one command a tick')
        return self.commands[-1], self.answers[key]['status'], self.answers[key]['markers']

    def drive(self, ticks, **inputs):
        robot = Robot()
        for _ in range(ticks):
            command, status, _ = self.tick(robot, **inputs)
            robot.follow(command)
        return robot, status

    def assert_stops(self, robot, wanted, text, **changed):
        """It brakes as fast as it may, and says why."""
        speed = robot.v
        command, status, markers = self.tick(robot, **changed)
        self.assertEqual(status.status, wanted, status)
        self.assertIn(text, status.message)
        self.assertAlmostEqual(command.linear.x, max(0.0, speed - 1.0 * PERIOD), places=6)
        self.assertEqual([m.action for m in markers.markers], [Marker.DELETE] * 2)

    def test_drives_ahead_and_arrives(self):
        robot, status = self.drive(100)
        self.assertEqual(status.status, DriveStatus.ARRIVED, status)
        self.assertLess(abs(robot.x - 1.9), 0.11)
        self.assertLess(robot.v, 0.01)

    def test_arcs_are_drawn(self):
        command, status, markers = self.tick(Robot())
        self.assertEqual(status.status, DriveStatus.DRIVING, status)
        self.assertAlmostEqual(command.linear.x, 0.05, places=6)
        self.assertGreater(status.time_to_collision, 1.0)
        tried, chosen = markers.markers
        self.assertGreater(len(tried.points), 100)
        self.assertEqual(len(chosen.points), 16)
        self.assertEqual(markers.markers[0].header.frame_id, 'odom')

    def test_stops_before_a_wall_on_the_path(self):
        robot, _ = self.drive(120, path=((0.0, 0.0), (5.0, 0.0)))
        self.assertLess(robot.x, 2.0)
        self.assertGreater(robot.x, 1.8)

    def test_stops_without_what_it_needs(self):
        def fast():
            robot, status = self.drive(15)
            self.assertEqual(status.status, DriveStatus.DRIVING, status)
            self.assertGreater(robot.v, 0.5)
            return robot
        without_floor = polygons(rospy.Time.from_sec(self.now + 16 * PERIOD), 'odom', ())
        without_floor.floor_status = FloorPlane.NOT_FOUND
        self.assert_stops(fast(), DriveStatus.NO_FLOOR, 'no floor was found', polygons=without_floor)
        self.assert_stops(fast(), DriveStatus.NO_PATH, 'the path is empty', path=())
        bad = self.path(AHEAD)
        bad.poses[1].pose.position.x = float('nan')
        robot = fast()
        bad.header.stamp = rospy.Time.from_sec(self.now + PERIOD)
        self.assert_stops(robot, DriveStatus.NO_PATH, 'not finite', path=bad)
        self.assert_stops(fast(), DriveStatus.STALE, 'fewer than 3', boxes=(WALL[:2],))
        robot = fast()
        elsewhere = polygons(rospy.Time.from_sec(self.now + PERIOD), 'elsewhere', (WALL,))
        self.assert_stops(robot, DriveStatus.STALE, "from 'elsewhere' to 'odom'", polygons=elsewhere)
        odd = self.odometry(fast())
        odd.twist.twist.linear.x = float('inf')
        robot = Robot()
        robot.v = self.commands[-1].linear.x
        self.assert_stops(robot, DriveStatus.STALE, 'not finite', odom=odd)
        # An obstacle that runs the wrong way, or crosses itself, would be open from outside.
        self.assert_stops(fast(), DriveStatus.STALE, 'clockwise', boxes=(WALL[::-1],))
        self.assert_stops(fast(), DriveStatus.STALE, 'polygon 1', boxes=(WALL, (WALL[0], WALL[2], WALL[1], WALL[3])))

    def test_odometry_that_is_none_is_refused(self):
        for text, spoil in (('unit quaternion', within('pose.pose.orientation', z=0.0, w=0.0)),
                            ('within 1000 km', within('pose.pose.position', x=1e7)),
                            ('above 100 m/s', within('twist.twist.linear', x=1e6)),
                            ('above 100 m/s', within('twist.twist.angular', z=-1e300)),
                            ('header.frame_id is empty', set_to(header_frame_id=''))):
            odometry = self.odometry(Robot())
            spoil(odometry)
            _, status, _ = self.tick(Robot(), odom=odometry)
            self.assertEqual(status.status, DriveStatus.STALE, status)
            self.assertIn(text, status.message)
            self.assertEqual(self.tick(Robot())[1].status, DriveStatus.DRIVING, 'after ' + text)

    def test_what_moves_beyond_belief_is_refused(self):
        for text, spoil in (('100 m/s', within('velocity', x=1e300)), ('100 m/s', within('velocity', y=float('nan'))),
                            ('no covariance', set_to(velocity_covariance=[-1.0, 0.0, 0.0, 1.0])),
                            ('no covariance', set_to(velocity_covariance=[float('nan')] * 4)),
                            ('no covariance', set_to(velocity_covariance=[1e300, 0.0, 0.0, 0.0])),
                            ('clockwise', lambda one: one.polygon.boundary.points.reverse())):
            people = self.person(1.5, 2.0, (0.0, 0.0))
            spoil(people.polygons[0])
            _, status, _ = self.tick(Robot(), tracked_polygons=people)
            self.assertEqual(status.status, DriveStatus.STALE, status)
            self.assertIn(text, status.message)
        self.assertEqual(self.tick(Robot(), tracked_polygons=self.nobody())[1].status, DriveStatus.DRIVING)

    def test_time_that_jumps_back_begins_anew(self):
        DynamicWindowTest.now -= 50.0
        count = len(self.commands)
        self.wait_for(lambda: self.advance() or len(self.commands) > count, 'a command of the new time')
        self.wait_for(lambda: self.answers.get(round(self.now, 3)), 'the last of them')
        self.assertIn('no odometry has come', self.answers[round(self.now, 3)]['status'].message)
        self.assertEqual(self.tick(Robot())[1].status, DriveStatus.DRIVING)

    def test_stops_when_inputs_end_and_goes_on(self):
        for name in ('polygons', 'odom'):
            robot, _ = self.drive(15)
            # Of half a second they are still good.
            for k in range(10):
                command, status, _ = self.tick(robot, **{name: None})
                self.assertEqual(status.status, DriveStatus.DRIVING, '%s %d: %s' % (name, k, status))
                robot.follow(command)
            command, status, _ = self.tick(robot, **{name: None})
            self.assertEqual(status.status, DriveStatus.STALE, '%s: %s' % (name, status))
            self.assertIn(name, status.message)
            self.assertLess(command.linear.x, robot.v)
            _, status, _ = self.tick(robot)
            self.assertEqual(status.status, DriveStatus.DRIVING, 'they are back')

    def test_waits_for_who_comes(self):
        robot = Robot()
        for k in range(60):
            command, status, _ = self.tick(robot, tracked_polygons=self.person(1.5, -2.0 + 0.8 * k * PERIOD, (0.0, 0.8)))
            robot.follow(command)
            near = abs(robot.x - 1.5) < 0.4 and abs(robot.y + 2.0 - 0.8 * k * PERIOD) < 0.4
            self.assertFalse(near and robot.v > 0.05, 'driven into somebody after %d ticks' % k)

    def test_polygons_of_another_frame_are_moved(self):
        def farthest(markers):
            return max(p.x for p in markers.markers[0].points)
        beyond = ((0.0, 0.0), (5.0, 0.0))
        _, _, markers = self.tick(Robot(), path=beyond)
        self.assertGreater(farthest(markers), 1.1)

        def moved():
            """In odom the wall is 1 m nearer."""
            stamp = self.now + PERIOD
            t = self.header_of(TransformStamped(child_frame_id='map'), 'odom', stamp)
            t.transform.translation.x, t.transform.rotation.w = -1.0, 1.0
            self.inputs['tf'].publish(TFMessage([t]))
            _, status, markers = self.tick(Robot(), polygons=polygons(rospy.Time.from_sec(stamp), 'map', (WALL,)), path=beyond)
            return status.status == DriveStatus.DRIVING and markers
        # tf has a thread of its own.
        markers = self.wait_for(moved, 'a tick for which tf was there')
        self.assertLess(farthest(markers), 1.0)

    def test_the_documented_parameters_are_the_nodes_own(self):
        table = subprocess.check_output([program('dynamic_window_parameters')], text=True)
        text = open(os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../doc/driving.md')).read()
        self.assertEqual(text.split('<!-- driving parameters: begin -->\n')[1].split('<!-- driving parameters: end -->')[0], table)


if __name__ == '__main__':
    rospy.init_node('test_dynamic_window', disable_rostime=True)
    rostest.rosrun('polygonal_perception', 'test_dynamic_window', DynamicWindowTest, sys.argv)
