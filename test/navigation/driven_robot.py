"""A robot without a body: it drives as cmd_vel says, at once, and tells odometry and tf."""
import math
import threading

import rospy
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage


class DrivenRobot:
    """Stands at the origin of odom until somebody drives it. track has each place it was in."""

    PERIOD = 0.02  # [s]

    def __init__(self):
        self.x = self.y = self.yaw = 0.0
        self.track = []
        self._lock = threading.Lock()
        self._command = Twist()
        self._tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        self._odometry = rospy.Publisher('/odom', Odometry, queue_size=10)
        self._reader = rospy.Subscriber('/cmd_vel', Twist, self._obey, queue_size=1, tcp_nodelay=True)
        self._last = rospy.Time.now()
        self._timer = rospy.Timer(rospy.Duration(self.PERIOD), self._step)

    def place_at(self, x, y, yaw):
        with self._lock:
            self.x, self.y, self.yaw, self.track = x, y, yaw, []

    def _obey(self, command):
        with self._lock:
            self._command = command

    def _step(self, _):
        with self._lock:
            now = rospy.Time.now()
            passed, self._last = (now - self._last).to_sec(), now
            v, w = self._command.linear.x, self._command.angular.z
            middle = self.yaw + w * passed / 2.0
            self.x += v * math.cos(middle) * passed
            self.y += v * math.sin(middle) * passed
            self.yaw += w * passed
            self.track.append((self.x, self.y))
            self._publish(now, v, w)

    def _publish(self, now, v, w):
        transform = TransformStamped(child_frame_id='base_link')
        transform.header.stamp, transform.header.frame_id = now, 'odom'
        transform.transform.translation.x, transform.transform.translation.y = self.x, self.y
        transform.transform.rotation.z, transform.transform.rotation.w = math.sin(self.yaw / 2.0), math.cos(self.yaw / 2.0)
        self._tf.publish(TFMessage([transform]))
        odometry = Odometry(header=transform.header, child_frame_id='base_link')
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = self.x, self.y
        odometry.pose.pose.orientation = transform.transform.rotation
        odometry.twist.twist.linear.x, odometry.twist.twist.angular.z = v, w
        self._odometry.publish(odometry)
