"""A floor with boxes on it, seen by a depth camera: made and worked out here, apart from the code under test.

As a program it is such a camera.
"""
import math

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

OPTICAL_FRAME = 'camera_depth_optical_frame'


class Box:
    """An upright box on the floor, its sides along the floor frame's axes [m]."""

    def __init__(self, x, y, z):
        self.low = np.array([x[0], y[0], z[0]], float)
        self.high = np.array([x[1], y[1], z[1]], float)


class Camera:
    """A pinhole camera above the floor frame's origin. Pitch is positive when it looks down [rad]."""

    def __init__(self, height=1.0, pitch=0.4, roll=0.0, width=160, rows=120, focal_length=142.0, upside_down=False):
        self.height, self.width, self.rows, self.f = height, width, rows, focal_length
        self.cx, self.cy = (width - 1) / 2.0, (rows - 1) / 2.0
        if upside_down:
            roll += math.pi
        cp, sp, cr, sr = math.cos(pitch), math.sin(pitch), math.cos(roll), math.sin(roll)
        body = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
        # From optical axes (right, down, forward) to body axes (forward, left, up).
        self.rotation = body @ np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]], float)  # optical -> floor frame
        self.position = np.array([0, 0, height], float)

    @property
    def floor_normal(self):
        return self.rotation[2]

    def rays(self):
        """Directions with z = 1 in the optical frame, rows x width x 3."""
        u, v = np.meshgrid(np.arange(self.width), np.arange(self.rows))
        return np.stack([(u - self.cx) / self.f, (v - self.cy) / self.f, np.ones_like(u, float)], -1)

    def render(self, boxes=(), floor=True, max_depth=8.0):
        """Depth along the optical axis [m], NaN without a return."""
        directions = self.rays() @ self.rotation.T
        depth = np.full(directions.shape[:2], np.inf)
        with np.errstate(divide='ignore', invalid='ignore'):
            if floor:
                t = -self.height / directions[..., 2]
                depth = np.where(t > 0, np.minimum(depth, t), depth)
            for box in boxes:
                a, b = (box.low - self.position) / directions, (box.high - self.position) / directions
                enter, leave = np.minimum(a, b).max(-1), np.maximum(a, b).min(-1)
                depth = np.where((enter > 0) & (enter < leave), np.minimum(depth, enter), depth)
        return np.where(depth < max_depth, depth, np.nan)

    def points(self, depth):
        """In the optical frame, rows x width x 3."""
        return self.rays() * depth[..., None]

    def to_floor(self, points):
        return points @ self.rotation.T + self.position

    def cloud(self, depth, stamp, frame=OPTICAL_FRAME):
        """As openni2 sends them: 16 bytes a point."""
        message = PointCloud2(height=self.rows, width=self.width, point_step=16, row_step=16 * self.width)
        message.header.stamp, message.header.frame_id = stamp, frame
        message.fields = [PointField(n, 4 * i, PointField.FLOAT32, 1) for i, n in enumerate('xyz')]
        data = np.zeros((self.rows, self.width, 4), np.float32)
        data[..., :3] = self.points(depth)
        message.data = data.tobytes()
        return message

    def image(self, depth, stamp, encoding='16UC1', frame=OPTICAL_FRAME):
        message = Image(height=self.rows, width=self.width, encoding=encoding)
        message.header.stamp, message.header.frame_id = stamp, frame
        if encoding == '16UC1':
            data = np.round(np.nan_to_num(depth) * 1000.0).astype(np.uint16)
        else:
            data = depth.astype(np.float32)
        message.step, message.data = data.strides[0], data.tobytes()
        return message

    def info(self, stamp, frame=OPTICAL_FRAME):
        message = CameraInfo(height=self.rows, width=self.width, distortion_model='plumb_bob', D=[0.0] * 5)
        message.header.stamp, message.header.frame_id = stamp, frame
        message.K = [self.f, 0, self.cx, 0, self.f, self.cy, 0, 0, 1]
        message.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
        message.P = [self.f, 0, self.cx, 0, 0, self.f, self.cy, 0, 0, 0, 1, 0]
        return message


def transform(parent, child, position=(0, 0, 0), rotation=np.eye(3)):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    t, r = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = position
    r.x, r.y, r.z, r.w = quaternion_of(rotation)
    return message


def quaternion_of(r):
    """x, y, z, w of a rotation matrix, by its eigenvector."""
    k = np.array([[r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[2, 0] + r[0, 2], r[2, 1] - r[1, 2]],
                  [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], r[2, 1] + r[1, 2], r[0, 2] - r[2, 0]],
                  [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], r[1, 0] - r[0, 1]],
                  [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)]]) / 3.0
    values, vectors = np.linalg.eigh(k)
    return vectors[:, values.argmax()]


def occupied_cells(points, info, min_height, max_height, margin):
    """Cells that must be and cells that may be occupied, where points in the floor frame are known within `margin`."""
    p = points.reshape(-1, 3)
    p = p[np.isfinite(p).all(1)]
    must, may = (np.zeros((info.height, info.width), bool) for _ in range(2))
    origin = np.array([info.origin.position.x, info.origin.position.y])
    # A cell has to be occupied when a point is in it wherever within the margin it really lies.
    safe = p[(p[:, 2] > min_height + margin) & (p[:, 2] < max_height - margin)]
    maybe = p[(p[:, 2] > min_height - margin) & (p[:, 2] < max_height + margin)]

    def cells(q, shift):
        return np.floor((q[:, :2] + shift - origin) / info.resolution).astype(int)

    shifts = [np.array([sx, sy]) * margin for sx in (-1, 1) for sy in (-1, 1)]
    corners = np.stack([cells(safe, s) for s in shifts])
    for grid, index in [(must, corners[0][(corners == corners[0]).all((0, 2))])] + [(may, cells(maybe, s)) for s in shifts]:
        index = index[((index >= 0) & (index < [info.width, info.height])).all(1)]
        grid[index[:, 1], index[:, 0]] = True
    return must, may


def inflate(occupied, resolution, radius):
    """The cells whose square comes nearer than `radius` to the square of an occupied cell, straight from the definition."""
    result = occupied.copy()
    height, width = occupied.shape
    j, i = np.mgrid[0:height, 0:width]
    for oj, oi in zip(*np.nonzero(occupied)):
        gap_x, gap_y = np.maximum(np.abs(i - oi) - 1, 0), np.maximum(np.abs(j - oj) - 1, 0)
        result |= np.hypot(gap_x, gap_y) * resolution < radius - 1e-9
    return result


def inside(point, ring):
    """Whether a point is in a ring, by the even-odd rule."""
    x, y = point
    within = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            within = not within
    return within


def signed_area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])) / 2.0


if __name__ == '__main__':
    rospy.init_node('camera', anonymous=True)
    view, rate = Camera(), rospy.Rate(30)
    depth = view.render()
    points = rospy.Publisher('/camera/depth/points', PointCloud2, queue_size=2)
    while not rospy.is_shutdown():
        points.publish(view.cloud(depth, rospy.Time.now()))
        rate.sleep()
