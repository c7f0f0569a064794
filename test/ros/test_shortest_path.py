#!/usr/bin/env python3
"""A planner node that runs: polygons and goals in, paths, reasons and markers out."""
import math
import os
import subprocess
import sys
import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PointStamped, PoseStamped, TransformStamped
from nav_msgs.msg import Path
from nav_msgs.srv import GetPlan
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from bad_messages import POLYGONS
from launched import program
from path_client import polygons
from polygonal_perception.msg import FloorPlane, PlanStatus, PolygonArray
from waiting import DEADLINE, wait_for

NODE = '/shortest_path'
BOX = ((1.0, -1.0), (2.0, -1.0), (2.0, 3.0), (1.0, 3.0))


def transform(parent, child, x, y, yaw, stamp):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, stamp
    message.transform.translation.x, message.transform.translation.y = x, y
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return message


def pose(x, y, yaw=0.0, frame='odom', stamp=None):
    message = PoseStamped()
    message.header.frame_id, message.header.stamp = frame, stamp or rospy.Time()
    message.pose.position.x, message.pose.position.y = x, y
    message.pose.orientation.z, message.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return message


def corners(path):
    return [(round(p.pose.position.x, 6), round(p.pose.position.y, 6)) for p in path.poses]


def yaws(path):
    return [2.0 * math.atan2(p.pose.orientation.z, p.pose.orientation.w) for p in path.poses]


class ShortestPathTest(unittest.TestCase):
    stamp = rospy.Time(1000)

    @classmethod
    def setUpClass(cls):
        cls.condition = threading.Condition()
        cls.answers = {}
        cls.readers = [rospy.Subscriber('%s/%s' % (NODE, name), kind, cls.keep, name, queue_size=50)
                       for name, kind in (('path', Path), ('status', PlanStatus), ('markers', MarkerArray))]
        cls.polygons = rospy.Publisher('/polygons', PolygonArray, queue_size=10)
        cls.goal = rospy.Publisher('/goal', PoseStamped, queue_size=10)
        cls.point = rospy.Publisher('/clicked_point', PointStamped, queue_size=10)
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        ends = [*cls.readers, cls.polygons, cls.goal, cls.point, cls.tf]
        cls.wait_for(lambda: all(end.get_num_connections() > 0 for end in ends), 'connections')
        rospy.wait_for_service(NODE + '/make_plan', DEADLINE)
        cls.make_plan = rospy.ServiceProxy(NODE + '/make_plan', GetPlan)

    @classmethod
    def keep(cls, message, name):
        header = message.markers[0].header if name == 'markers' else message.header
        with cls.condition:
            cls.answers.setdefault(header.stamp.to_nsec(), {})[name] = message
            cls.condition.notify_all()

    @classmethod
    def wait_for(cls, condition, what):
        return wait_for(cls.condition, condition, what)

    def tick(self):
        ShortestPathTest.stamp += rospy.Duration(1.0)
        return ShortestPathTest.stamp

    def ask(self, boxes=(BOX,), robot=(0.0, 0.0, 0.0), status=FloorPlane.FOUND, frame='odom', stamp=None, spoil=None):
        """Sends polygons and the robot's place, and returns the answers to them."""
        stamp = stamp or self.tick()
        if robot:
            self.tf.publish(TFMessage([transform('odom', 'base_link', *robot, stamp=stamp)]))
        message = polygons(stamp, frame, boxes)
        message.floor_status = status
        if spoil:
            spoil(message)
        # Time may have been here before.
        answers = self.answers[message.header.stamp.to_nsec()] = {}
        self.polygons.publish(message)
        wait_for(self.condition, lambda: len(answers) == 3, 'path, status and markers',
                 seen=lambda: '; there are %s' % sorted(answers))
        return answers

    def send_goal(self, publisher, message, wanted, boxes=(BOX,)):
        """Until the node has it: it says so in the path's end."""
        publisher.publish(message)
        end = time.monotonic() + DEADLINE
        while time.monotonic() < end:
            answer = self.ask(boxes)
            if answer['path'].poses and corners(answer['path'])[-1] == wanted:
                return answer
        raise AssertionError('no path ends in %s, but in %s' % (wanted, corners(answer['path'])[-1:]))

    def test_1_without_a_goal_each_array_has_a_status(self):
        answer = self.ask()
        self.assertEqual(answer['status'].status, PlanStatus.NO_GOAL, answer['status'])
        self.assertEqual(answer['path'].poses, [])
        self.assertEqual([m.action for m in answer['markers'].markers], [Marker.DELETE] * 3)

    def test_2_a_path_goes_around(self):
        answer = self.send_goal(self.goal, pose(3.0, 0.0, 1.0), (3.0, 0.0))
        self.assertEqual(corners(answer['path']), [(0.0, 0.0), (1.0, -1.0), (2.0, -1.0), (3.0, 0.0)])
        for yaw, wanted in zip(yaws(answer['path']), (-math.pi / 4, 0.0, math.pi / 4, 1.0)):
            self.assertAlmostEqual(yaw, wanted, places=5)
        self.assertEqual({p.header.frame_id for p in answer['path'].poses}, {'odom'})
        status = answer['status']
        self.assertEqual((status.status, status.start_shift, status.goal_shift), (PlanStatus.OK, 0.0, 0.0), status)
        self.assertAlmostEqual(status.length, 2.0 * math.sqrt(2.0) + 1.0)
        markers = {m.ns: m for m in answer['markers'].markers}
        self.assertEqual(len(markers['path'].points), 4)
        self.assertEqual(len(markers['goal'].points), 4)
        self.assertGreater(len(markers['visibility_graph'].points), 3)

    def test_3_it_is_planned_anew_with_each_array(self):
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        self.assertEqual(corners(self.ask(boxes=())['path']), [(0.0, 0.0), (3.0, 0.0)])
        self.assertEqual(corners(self.ask(robot=(0.5, 0.5, 2.0))['path'])[0], (0.5, 0.5))
        wall = ((1.0, -9.0), (2.0, -9.0), (2.0, 9.0), (1.0, 9.0))
        closed = ((-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0))
        self.assertEqual(len(corners(self.ask(boxes=(wall,))['path'])), 4)
        self.assertEqual(self.ask(boxes=(closed,))['status'].status, PlanStatus.GOAL_BLOCKED)

    def test_4_a_blocked_start_and_goal_are_told(self):
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        answer = self.ask(robot=(1.2, 0.0, 0.0))
        self.assertEqual(corners(answer['path'])[:2], [(1.2, 0.0), (1.0, 0.0)])
        self.assertAlmostEqual(answer['status'].start_shift, 0.2, places=5)
        answer = self.send_goal(self.goal, pose(1.25, 0.0), (1.0, 0.0))
        self.assertAlmostEqual(answer['status'].goal_shift, 0.25, places=5)

    def test_5_a_clicked_point_has_no_yaw(self):
        message = PointStamped()
        message.header.frame_id = 'odom'
        message.point.x, message.point.y = 0.0, 2.0
        answer = self.send_goal(self.point, message, (0.0, 2.0))
        self.assertAlmostEqual(yaws(answer['path'])[-1], math.pi / 2.0, places=5)

    def test_6_a_goal_in_the_robots_frame_stays_where_it_was(self):
        self.ask(robot=(0.0, 0.0, math.pi / 2.0))
        stamp = ShortestPathTest.stamp
        self.send_goal(self.goal, pose(2.0, 0.0, frame='base_link', stamp=stamp), (0.0, 2.0))
        self.assertEqual(corners(self.ask(robot=(-1.0, 0.0, 0.0))['path'])[-1], (0.0, 2.0))

    def test_7_what_cannot_be_planned_on_is_said(self):
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        for status, text, arguments in (
                (PlanStatus.NO_POLYGONS, 'floor', dict(boxes=(), status=FloorPlane.NOT_FOUND)),
                (PlanStatus.NO_POLYGONS, 'clockwise', dict(boxes=(BOX[::-1],))),
                (PlanStatus.NO_POLYGONS, 'polygon 1', dict(boxes=(BOX, BOX[:2]))),
                (PlanStatus.START_BLOCKED, "from 'base_link' to 'elsewhere'", dict(frame='elsewhere')),
                (PlanStatus.START_BLOCKED, "from 'base_link' to 'odom'", dict(robot=None))):
            answer = self.ask(**arguments)
            self.assertEqual(answer['status'].status, status, answer['status'])
            self.assertIn(text, answer['status'].message)
            self.assertEqual(answer['path'].poses, [])
        self.assertEqual(self.ask()['status'].status, PlanStatus.OK)
        for name, (spoil, text) in POLYGONS.items():
            status = self.ask(spoil=spoil)['status']
            self.assertIn(text, status.message, name)
            self.assertNotEqual(status.status, PlanStatus.OK, name)
            self.assertEqual(self.ask()['status'].status, PlanStatus.OK, 'after ' + name)

    def test_71_a_stamp_at_the_end_of_its_range_ends_nothing(self):
        # tf's error has how far it is away, which no ros::Duration holds.
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        answer = self.ask(robot=None, stamp=rospy.Time(2 ** 32 - 1, 999999999))
        self.assertEqual(answer['status'].status, PlanStatus.START_BLOCKED, answer['status'])
        self.assertIn("from 'base_link' to 'odom'", answer['status'].message)
        self.assertEqual(self.ask()['status'].status, PlanStatus.OK)

    def test_72_time_that_jumps_back_begins_anew(self):
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        ShortestPathTest.stamp -= rospy.Duration(60.0)
        self.ask()
        self.assertEqual(self.ask()['status'].status, PlanStatus.NO_GOAL, 'after two of another time')
        # tf takes nothing that is older until it has been cleared.
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))

    def test_73_the_side_of_an_obstacle_is_kept(self):
        box = ((1.0, -1.0), (2.0, -1.0), (2.0, 1.0), (1.0, 1.0))

        def second(robot, frame='odom'):
            """The path's first corner after the robot, in odom."""
            x, y, yaw = robot if frame == 'base_link' else (0.0, 0.0, 0.0)
            c, s = math.cos(yaw), math.sin(yaw)
            moved = [(c * (px - x) + s * (py - y), c * (py - y) - s * (px - x)) for px, py in box]
            answer = self.ask(boxes=(moved,), robot=robot, frame=frame)
            px, py = corners(answer['path'])[1]
            return answer, (round(x + c * px - s * py, 4), round(y + s * px + c * py, 4))
        self.send_goal(self.goal, pose(3.0, 0.0), (3.0, 0.0))
        self.send_goal(self.goal, pose(3.1, 0.4), (3.1, 0.4))
        self.assertEqual(second((0.0, 0.1, 0.0))[1], (1.0, 1.0))
        answer, corner = second((0.0, -0.5, 0.0))
        self.assertEqual(corner, (1.0, 1.0), 'the other is a little shorter')
        self.assertIn('longer than the shortest to stay on its side', answer['status'].message)
        plan = self.make_plan(pose(0.0, -0.5), pose(3.1, 0.4), 0.0).plan
        self.assertEqual(corners(plan)[1], (1.0, -1.0), 'a plan by itself is the shortest')
        for yaw in (0.3, 1.0):
            self.assertEqual(second((0.0, -0.5, yaw), 'base_link')[1], (1.0, 1.0))
        self.assertEqual(second((0.0, -0.8, 0.0))[1], (1.0, -1.0), 'much shorter')
        self.send_goal(self.goal, pose(3.0, -1.5), (3.0, -1.5), (box,))
        answer = self.send_goal(self.goal, pose(3.0, 0.1), (3.0, 0.1), (box,))
        self.assertEqual(corners(answer['path'])[1], (1.0, 1.0), 'of another goal nothing is kept')

    def test_8_make_plan(self):
        self.ask()
        plan = self.make_plan(pose(0.0, 0.0), pose(3.0, 0.0, 2.0), 0.0).plan
        self.assertEqual(corners(plan), [(0.0, 0.0), (1.0, -1.0), (2.0, -1.0), (3.0, 0.0)])
        self.assertEqual(plan.header.stamp, ShortestPathTest.stamp)
        self.assertAlmostEqual(yaws(plan)[-1], 2.0, places=5)
        self.assertEqual(corners(self.make_plan(pose(0.0, 0.0), pose(1.4, 0.0), 0.0).plan), [])
        self.assertEqual(corners(self.make_plan(pose(0.0, 0.0), pose(1.4, 0.0), 0.5).plan), [(0.0, 0.0), (1.0, 0.0)])
        self.assertEqual(self.make_plan(pose(0.0, 0.0, frame='nowhere'), pose(1.4, 0.0), 0.5).plan.poses, [])
        self.assertEqual(self.make_plan(pose(float('nan'), 0.0), pose(1.4, 0.0), 0.5).plan.poses, [])

    def test_9_the_documented_parameters_are_the_nodes_own(self):
        table = subprocess.check_output([program('shortest_path_parameters')], text=True)
        text = open(os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../doc/paths.md')).read()
        self.assertEqual(text.split('<!-- path parameters: begin -->\n')[1].split('<!-- path parameters: end -->')[0], table)


if __name__ == '__main__':
    rospy.init_node('test_shortest_path')
    rostest.rosrun('polygonal_perception', 'test_shortest_path', ShortestPathTest, sys.argv)
