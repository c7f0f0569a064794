#!/usr/bin/env python3
"""Opens the shipped view in rviz: each display loads and reads its topic."""
import os
import sys
import unittest

import rospy
import rostest
import yaml
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import Image, PointCloud2

from polygonal_perception.msg import FloorPlane, PolygonArray
from virtual_rviz import VirtualRviz, what_is_missing

START = 60.0  # [s] until rviz has subscribed; under a software renderer and a busy machine
VIEW = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'rviz', 'polygonal_perception.rviz')
TYPES = {
    'polygonal_perception/FloorPlane': FloorPlane,
    'polygonal_perception/PolygonArray': PolygonArray,
    'rviz/Image': Image,
    'rviz/Map': OccupancyGrid,
    'rviz/PointCloud2': PointCloud2,
}


@unittest.skipIf(what_is_missing(), 'not there: ' + what_is_missing())
class ViewTest(unittest.TestCase):
    def test_every_display_reads_its_topic(self):
        with open(VIEW) as file:
            displays = yaml.safe_load(file)['Visualization Manager']['Displays']
        topics = {d.get('Topic') or d['Image Topic']: TYPES[d['Class']]
                  for d in displays if d['Enabled'] and d['Class'] != 'rviz/TF'}
        self.assertLessEqual({FloorPlane, PolygonArray}, set(topics.values()))
        publishers = [rospy.Publisher(topic, kind, queue_size=1) for topic, kind in topics.items()]
        rviz = VirtualRviz(VIEW)
        try:
            rviz.wait_for(lambda: all(p.get_num_connections() > 0 for p in publishers),
                          'rviz to subscribe to ' + ', '.join(topics), START)
        finally:
            rviz.close()


if __name__ == '__main__':
    rospy.init_node('test_view')
    rostest.rosrun('polygonal_perception', 'test_view', ViewTest, sys.argv)
