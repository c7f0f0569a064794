#!/usr/bin/env python3
"""Says for every frame whether the robot's centre may be 1.5 m ahead of the camera."""
import rospy
from polygonal_perception.msg import PolygonArray


def crosses_odd(ring, x, y):
    """Whether a ray from (x, y) along +x crosses a ring an odd number of times."""
    p = ring.points
    return sum((a.y > y) != (b.y > y) and x < a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y)
               for a, b in zip(p, p[1:] + p[:1])) % 2 == 1


def is_free(array, x, y):
    """Polygons do not overlap and holes lie inside: outside means an even number of crossings with all rings."""
    rings = [ring for polygon in array.polygons for ring in [polygon.boundary, *polygon.holes]]
    return sum(crosses_odd(ring, x, y) for ring in rings) % 2 == 0


def state_of(array, x, y):
    # Outside of the extent nothing is known; without a floor it is empty.
    if not crosses_odd(array.extent, x, y):
        return 'unknown'
    return 'free' if is_free(array, x, y) else 'blocked'


def on_polygons(array):
    rospy.loginfo('1.5 m ahead: %s', state_of(array, 1.5, 0.0))


rospy.init_node('is_free')
reader = rospy.Subscriber('polygonal_perception/polygons', PolygonArray, on_polygons, queue_size=1)
rospy.spin()
