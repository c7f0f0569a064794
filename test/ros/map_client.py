"""Feeds the map's node observations that are made cell by cell, and collects what it publishes."""
import math

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from node_client import FOUND, NodeClient
from polygonal_perception.msg import ObservedCells, PolygonArray

SIDE = 40  # cells of a sensor's grid, of 5 cm


def transform(stamp, child, x=0.0, y=0.0, z=0.0, yaw=0.0):
    """Of a frame in odom."""
    t = TransformStamped()
    t.header.stamp, t.header.frame_id, t.child_frame_id = stamp, 'odom', child
    t.transform.translation.x, t.transform.translation.y, t.transform.translation.z = x, y, z
    t.transform.rotation.z, t.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return t


def observation(stamp, frame='odom', hits=(), everything_seen=True):
    """A grid 2 m ahead of a sensor and 1 m to each side; hits are (x, y, bits) in its frame."""
    m = ObservedCells()
    m.header.stamp, m.header.frame_id = stamp, frame
    m.floor_status = FOUND
    m.info.resolution, m.info.width, m.info.height = 0.05, SIDE, SIDE
    m.info.origin.position.y, m.info.origin.orientation.w = -1.0, 1.0
    m.slab_height = 0.07
    hit, free, floor = np.zeros((3, SIDE, SIDE), np.uint8)
    if everything_seen:
        free[:], floor[:] = 255, 1
    for x, y, bits in hits:
        hit[int((y + 1.0) / 0.05), int(x / 0.05)] = bits
    m.hit, m.free, m.floor = hit.tobytes(), free.tobytes(), floor.tobytes()
    return m


class StandingClient(NodeClient):
    """Talks to a node whose robot stands in the middle of odom for all times."""

    SHARED_TOPICS = ('/rosout', '/diagnostics')

    def _advertise(self):
        self.place = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        self.place.publish(TFMessage([transform(rospy.Time.now(), 'base_link')]))
        return self._advertise_inputs()

    def wait_connected(self):
        super().wait_connected()
        self.wait_for(lambda: self.place.get_num_connections() > 0, 'the node to listen to tf')

    def close(self):
        super().close()
        self.place.unregister()


class MapClient(StandingClient):
    """Talks to a map's node of one source."""

    OUTPUTS = {'observed_grid': OccupancyGrid, 'occupancy_grid': OccupancyGrid, 'inflated_grid': OccupancyGrid,
               'polygons': PolygonArray, 'markers': MarkerArray}

    def __init__(self, outputs=('occupancy_grid', 'polygons'), node='/polygon_map', runs=True):
        super().__init__(outputs, node, runs=runs)

    @staticmethod
    def _advertise_inputs():
        return [rospy.Publisher('/observed_cells', ObservedCells, queue_size=10)]
