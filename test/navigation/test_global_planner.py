#!/usr/bin/env python3
"""PolygonalGlobalPlanner in the real move_base, with dwa_local_planner and costmaps that know of nothing."""
import math
import os
import subprocess
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Point32, Polygon, PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Path
from nav_msgs.srv import GetPlan

from polygonal_perception.msg import FloorPlane, ObstaclePolygon, PlanStatus, PolygonArray

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, '..', 'ros')]
from launched import program  # noqa: E402
from driven_robot import DrivenRobot  # noqa: E402
from waiting import DEADLINE, wait_for  # noqa: E402

PLANNER = '/move_base/PolygonalGlobalPlanner'
GROWN = 0.3  # [m] the polygons, as if by a robot's radius
# A wall that is open to the robot, in odom: who goes straight to the goal is caught in it.
TRAP = ((2.0, -1.2), (2.4, -1.2), (2.4, 1.6), (0.8, 1.6), (0.8, 1.2), (2.0, 1.2))
MAP_TO_ODOM = (1.0, 2.0, 0.5)  # x, y [m], yaw [rad] as global_planner.test has them


def in_map(x, y):
    left, up, yaw = MAP_TO_ODOM
    return (left + math.cos(yaw) * x - math.sin(yaw) * y, up + math.sin(yaw) * x + math.cos(yaw) * y)


def pose(x, y, yaw=0.0, frame='odom'):
    result = PoseStamped()
    result.header.frame_id = frame
    result.pose.position.x, result.pose.position.y = x, y
    result.pose.orientation.z, result.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return result


def places(path):
    return [(p.pose.position.x, p.pose.position.y) for p in path.poses]


def length(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


class World:
    """Sends polygons, as long as they are on."""

    def __init__(self, *rings):
        self.rings, self.on = rings, True
        self._publisher = rospy.Publisher('/polygons', PolygonArray, queue_size=1)
        self._timer = rospy.Timer(rospy.Duration(0.1), self._publish)

    def _publish(self, _):
        if not self.on:
            return
        message = PolygonArray(floor_status=FloorPlane.FOUND, inflation_radius=GROWN)
        message.header.stamp, message.header.frame_id = rospy.Time.now(), 'odom'
        message.polygons = [ObstaclePolygon(boundary=Polygon([Point32(x, y, 0.0) for x, y in ring])) for ring in self.rings]
        self._publisher.publish(message)


class GlobalPlannerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.condition = threading.Condition()
        cls.messages = {}
        cls.readers = [rospy.Subscriber('%s/%s' % (PLANNER, topic), kind, cls.keep, topic)
                       for topic, kind in (('plan', Path), ('status', PlanStatus))]
        cls.robot = DrivenRobot()
        rospy.wait_for_service('/move_base/make_plan', DEADLINE)
        wait_for(cls.condition, lambda: all(r.get_num_connections() for r in cls.readers), "the planner's topics")
        make_plan = rospy.ServiceProxy('/move_base/make_plan', GetPlan)
        cls.make_plan = staticmethod(lambda start, goal: make_plan(start, goal, 0.0).plan)

    @classmethod
    def keep(cls, message, topic):
        with cls.condition:
            cls.messages.setdefault(topic, []).append(message)
            cls.condition.notify_all()

    def refusal(self, start, goal):
        """The planner's words, once it makes no plan."""
        with self.condition:
            self.messages.clear()

        def refused():
            is_empty = not self.make_plan(start, goal).poses
            return is_empty and [s for s in self.messages.get('status', ()) if s.status != PlanStatus.OK]
        return wait_for(self.condition, refused, 'a plan to be refused')[-1]

    def test_1_without_polygons_there_is_no_plan(self):
        status = self.refusal(pose(0.0, 0.0), pose(3.0, 0.0))
        self.assertEqual((status.status, status.message), (PlanStatus.NO_POLYGONS, 'no polygons have come on /polygons'))

    def test_2_a_plan_is_the_shortest_in_the_costmaps_frame(self):
        GlobalPlannerTest.world = World(TRAP)
        start, goal = pose(0.0, 0.0), pose(*in_map(3.0, 0.0), yaw=1.0, frame='map')
        shortest = math.dist((0.0, 0.0), (2.0, -1.2)) + 0.4 + math.dist((2.4, -1.2), (3.0, 0.0))
        plan = wait_for(self.condition, lambda: places(self.make_plan(start, goal)) and self.make_plan(start, goal), 'a plan')
        self.assertEqual({p.header.frame_id for p in plan.poses}, {'map'})
        points = places(plan)
        self.assertAlmostEqual(length(points), shortest, places=5)
        self.assertLess(max(math.dist(a, b) for a, b in zip(points, points[1:])), 0.05 + 1e-9)
        for point, wanted in ((points[0], in_map(0.0, 0.0)), (points[-1], in_map(3.0, 0.0))):
            self.assertLess(math.dist(point, wanted), 1e-5)
        end = plan.poses[-1].pose.orientation
        self.assertAlmostEqual(2.0 * math.atan2(end.z, end.w), 1.0, places=5)
        first = plan.poses[0].pose.orientation
        self.assertAlmostEqual(2.0 * math.atan2(first.z, first.w), math.atan2(-1.2, 2.0) + MAP_TO_ODOM[2], places=5)

    def test_3_a_goal_in_an_obstacle_is_reached_beside_it_or_refused(self):
        self.assertEqual(self.refusal(pose(0.0, 0.0), pose(3.0, 0.0, frame='nowhere')).status, PlanStatus.NO_GOAL)
        plan = self.make_plan(pose(0.0, 0.0), pose(2.1, 0.0))
        self.assertLess(math.dist(places(plan)[-1], in_map(2.0, 0.0)), 1e-5)
        square = ((2.0, -1.0), (4.0, -1.0), (4.0, 1.0), (2.0, 1.0))
        self.world.rings = (square,)
        status = self.refusal(pose(0.0, 0.0), pose(3.0, 0.0))
        self.assertEqual(status.status, PlanStatus.GOAL_BLOCKED, status)
        self.world.rings = (TRAP,)

    def test_4_it_drives_out_of_a_trap_to_the_goal(self):
        self.robot.place_at(1.5, 0.0, 0.0)
        client = actionlib.SimpleActionClient('/move_base', MoveBaseAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(DEADLINE)))
        client.send_goal(MoveBaseGoal(target_pose=pose(*in_map(3.2, 0.0), frame='map')))
        self.assertTrue(client.wait_for_result(rospy.Duration(90.0)), 'the robot is at (%.2f, %.2f)' % (self.robot.x, self.robot.y))
        self.assertEqual(client.get_state(), GoalStatus.SUCCEEDED, client.get_goal_status_text())
        self.assertLess(math.dist((self.robot.x, self.robot.y), (3.2, 0.0)), 0.3)
        # The local planner knows of no obstacle, and cuts the path's corners by some cells.
        inside = [p for p in self.robot.track if 2.0 + GROWN / 2 < p[0] < 2.4 - GROWN / 2 and -1.2 + GROWN / 2 < p[1] < 1.6]
        self.assertEqual(inside, [])

    def test_5_there_is_no_plan_on_old_polygons(self):
        self.world.on = False
        status = self.refusal(pose(0.0, 0.0), pose(3.0, 0.0))
        self.assertEqual(status.status, PlanStatus.NO_POLYGONS)
        self.assertRegex(status.message, r'^the newest polygons are 1\.\d* s old, accepted are 1 s$')
        self.world.on = True

    def test_6_the_documented_parameters_are_its_own(self):
        table = subprocess.check_output([program('global_planner_parameters')], text=True)
        text = open(os.path.join(HERE, '../../doc/paths.md')).read()
        self.assertEqual(text.split('<!-- global planner parameters: begin -->\n')[1].split('<!-- global planner')[0], table)


if __name__ == '__main__':
    rospy.init_node('test_global_planner')
    rostest.rosrun('polygonal_perception', 'global_planner', GlobalPlannerTest, sys.argv)
