#!/usr/bin/env python3
"""The whole chain: a simulated robot drives through an office by what its camera sees, to where somebody clicks."""
import math
import sys
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Log

from polygonal_perception.msg import DriveStatus, PlanStatus
from waiting import wait_for

DEADLINE = 90.0  # [s] for a way of some metres, on a busy machine
GOAL = (1.8, 0.8)
NEAR = 0.45  # [m] to a goal: the planner may shift it by its tolerance, and the driver stop within its own


class DriveTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.condition = threading.Condition()
        cls.newest, cls.bumps = {}, []
        cls.readers = [rospy.Subscriber(name, kind, cls.keep, name)
                       for name, kind in (('/odom', Odometry), ('/dynamic_window/status', DriveStatus), ('/shortest_path/status', PlanStatus))]
        cls.log = rospy.Subscriber('/rosout', Log, lambda m: 'bumped' in m.msg and cls.bumps.append(m.msg))
        cls.goal = rospy.Publisher('/move_base_simple/goal', PoseStamped, queue_size=1)
        wait_for(cls.condition, lambda: len(cls.newest) == 3 and cls.goal.get_num_connections() > 0, 'the nodes', DEADLINE)

    @classmethod
    def keep(cls, message, name):
        with cls.condition:
            cls.newest[name] = message
            cls.condition.notify_all()

    def status(self):
        return self.newest['/dynamic_window/status']

    def distance_to(self, goal):
        p = self.newest['/odom'].pose.pose.position
        return math.hypot(p.x - goal[0], p.y - goal[1])

    def seen(self):
        return '; it is at %s: %s, %s' % (self.newest['/odom'].pose.pose.position, self.status().message,
                                          self.newest['/shortest_path/status'].message)

    def test_goes_where_it_is_told(self):
        self.assertEqual(self.status().status, DriveStatus.NO_PATH, self.status())
        self.assertGreater(self.distance_to(GOAL), 3.0, 'the way is too short to show anything')
        message = PoseStamped()
        message.header.frame_id = 'odom'
        message.pose.position.x, message.pose.position.y = GOAL
        message.pose.orientation.w = 1.0
        self.goal.publish(message)
        wait_for(self.condition, lambda: self.status().status == DriveStatus.DRIVING, 'the robot to start', DEADLINE, self.seen)
        wait_for(self.condition, lambda: self.status().status == DriveStatus.ARRIVED and self.distance_to(GOAL) < NEAR,
                 'the robot to arrive at %s' % (GOAL,), DEADLINE, self.seen)
        self.assertEqual(self.bumps, [])


if __name__ == '__main__':
    rospy.init_node('test_drive')
    rostest.rosrun('polygonal_perception', 'test_drive', DriveTest, sys.argv)
