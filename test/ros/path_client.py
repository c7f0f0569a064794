"""Feeds the planner's node polygons and a goal, and collects what it publishes."""
import rospy
from geometry_msgs.msg import Point32, Polygon, PoseStamped
from nav_msgs.msg import Path
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from map_client import transform
from node_client import FOUND, NodeClient
from polygonal_perception.msg import ObstaclePolygon, PlanStatus, PolygonArray

BOX = ((1.0, -1.0), (2.0, -1.0), (2.0, 1.0), (1.0, 1.0))
EXTENT = ((-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0))


def polygon(ring):
    return Polygon([Point32(x, y, 0.0) for x, y in ring])


def polygons(stamp, frame='odom', boxes=(BOX,)):
    """What a map sends."""
    m = PolygonArray(floor_status=FOUND, inflation_radius=0.3, extent=polygon(EXTENT))
    m.header.stamp, m.header.frame_id = stamp, frame
    m.polygons = [ObstaclePolygon(boundary=polygon(box)) for box in boxes]
    return m


class PathClient(NodeClient):
    """Talks to a planner whose robot stands in the middle of odom for all times, and wants to get beyond the box."""

    OUTPUTS = {'path': Path, 'status': PlanStatus, 'markers': MarkerArray}
    SHARED_TOPICS = ('/rosout', '/diagnostics')

    def __init__(self, outputs=('path', 'status'), node='/shortest_path', runs=True):
        super().__init__(outputs, node, runs=runs)

    def _advertise(self):
        self.place = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        self.place.publish(TFMessage([transform(rospy.Time.now(), 'base_link')]))
        self.goal = rospy.Publisher('/goal', PoseStamped, queue_size=1, latch=True)
        goal = PoseStamped()
        goal.header.frame_id, goal.pose.position.x, goal.pose.orientation.w = 'odom', 3.0, 1.0
        self.goal.publish(goal)
        return [rospy.Publisher('/polygons', PolygonArray, queue_size=10)]

    def wait_connected(self):
        super().wait_connected()
        self.wait_for(lambda: self.place.get_num_connections() > 0, 'the node to listen to tf')

    def close(self):
        super().close()
        self.place.unregister()
        self.goal.unregister()
