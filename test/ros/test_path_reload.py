#!/usr/bin/env python3
"""The planner's nodelet comes and goes, is changed and misused, while polygons and goals arrive."""
import itertools
import sys
import unittest

import rospy
import rostest
from nav_msgs.srv import GetPlan

from bad_messages import POLYGONS
from path_client import goal_at
from reload_checks import ReloadChecks
from subjects import Path

# Beyond the box, in it, where nothing is known, and none.
GOALS = [goal_at(3.0), goal_at(1.5), goal_at(1e6), goal_at(float('nan')), goal_at(3.0, 'nowhere'), goal_at(3.0, '')]


class PathReloadTest(ReloadChecks, unittest.TestCase):
    SUBJECT = Path
    SPOILERS = [row[0] for row in POLYGONS.values()]
    CHANGES = [dict(goal_tolerance=0.0), dict(side_hysteresis=1.0), dict(goal_tolerance=-1.0),
               dict(side_hysteresis=float('nan')), dict(goal_tolerance=10.0, side_hysteresis=0.0),
               dict(goal_tolerance=0.3, side_hysteresis=0.1)]
    PARAMETERS = ['fixed_frame', 'robot_frame', 'tf_timeout', 'goal_tolerance', 'outside', 'side_hysteresis', 'diagnostic_period']

    def test_goals_and_requests_all_the_time(self):
        self.load()
        make_plan = rospy.ServiceProxy(Path.NAME + '/make_plan', GetPlan)
        make_plan.wait_for_service()
        for goal in itertools.islice(itertools.cycle(GOALS), 60):
            self.client.goal.publish(goal)
            make_plan(goal_at(0.0), goal, 0.5)
        self.client.goal.publish(GOALS[0])
        self.wait_for_answers(5)


if __name__ == '__main__':
    rospy.init_node('test_path_reload')
    rostest.rosrun('polygonal_perception', 'test_path_reload', PathReloadTest, sys.argv)
