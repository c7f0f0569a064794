#!/usr/bin/env python3
"""Opens the shipped views in rviz: each display loads and reads its topic."""
import os
import sys
import unittest

import rospy
import rostest
import yaml
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import Image, PointCloud2
from visualization_msgs.msg import MarkerArray

from polygonal_perception.msg import FloorPlane, PolygonArray
from virtual_rviz import VirtualRviz, what_is_missing

START = 60.0  # [s] until rviz has subscribed; under a software renderer and a busy machine
VIEWS = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'rviz')
TOPICS = ('Topic', 'Image Topic', 'Marker Topic')  # what displays call it
TYPES = {
    'polygonal_perception/FloorPlane': FloorPlane,
    'polygonal_perception/PolygonArray': PolygonArray,
    'rviz/Image': Image,
    'rviz/Map': OccupancyGrid,
    'rviz/MarkerArray': MarkerArray,
    'rviz/PointCloud2': PointCloud2,
}


@unittest.skipIf(what_is_missing(), 'not there: ' + what_is_missing())
class ViewTest(unittest.TestCase):
    def check(self, name, kinds):
        view = os.path.join(VIEWS, name)
        with open(view) as file:
            displays = yaml.safe_load(file)['Visualization Manager']['Displays']
        topics = {next(d[key] for key in TOPICS if key in d): TYPES[d['Class']]
                  for d in displays if d['Enabled'] and d['Class'] != 'rviz/TF'}
        self.assertLessEqual(kinds, set(topics.values()))
        publishers = [rospy.Publisher(topic, kind, queue_size=1) for topic, kind in topics.items()]
        rviz = VirtualRviz(view)
        try:
            rviz.wait_for(lambda: all(p.get_num_connections() > 0 for p in publishers),
                          'rviz to subscribe to ' + ', '.join(topics), START)
        finally:
            rviz.close()
            for publisher in publishers:
                publisher.unregister()
        return topics

    def test_a_frame(self):
        self.check('polygonal_perception.rviz', {FloorPlane, PolygonArray})

    def test_a_map_beside_the_frame(self):
        topics = self.check('polygon_map.rviz', {OccupancyGrid, PolygonArray})
        self.assertLessEqual({'/polygon_map/polygons', '/polygonal_perception/polygons'}, set(topics))


if __name__ == '__main__':
    rospy.init_node('test_view')
    rostest.rosrun('polygonal_perception', 'test_view', ViewTest, sys.argv)
