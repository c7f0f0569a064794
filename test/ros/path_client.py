"""Feeds the planner's node polygons and a goal, and collects what it publishes."""
import rospy
from geometry_msgs.msg import Point32, Polygon, PoseStamped
from nav_msgs.msg import Path
from visualization_msgs.msg import MarkerArray

from map_client import StandingClient
from node_client import FOUND
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


def goal_at(x, frame='odom'):
    goal = PoseStamped()
    goal.header.frame_id, goal.pose.position.x, goal.pose.orientation.w = frame, x, 1.0
    return goal


class PathClient(StandingClient):
    """Talks to a planner whose robot wants to get beyond the box."""

    OUTPUTS = {'path': Path, 'status': PlanStatus, 'markers': MarkerArray}

    def __init__(self, outputs=('path', 'status'), node='/shortest_path', runs=True):
        super().__init__(outputs, node, runs=runs)

    def _advertise_inputs(self):
        self.goal = rospy.Publisher('/goal', PoseStamped, queue_size=1, latch=True)
        self.goal.publish(goal_at(3.0))
        return [rospy.Publisher('/polygons', PolygonArray, queue_size=10)]

    def close(self):
        super().close()
        self.goal.unregister()
