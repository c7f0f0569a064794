"""Poses as 4x4 matrices."""
import math

import cv2
import numpy as np
from geometry_msgs.msg import TransformStamped

# From the robot's body (x ahead, y left) to a camera's optical frame (x right, y down).
OPTICAL = np.array([[0, 0, 1, 0], [-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 0, 1]], float)


def to_pose(transform):
    q, t = transform.rotation, transform.translation
    x, y, z, w = q.x, q.y, q.z, q.w
    pose = np.eye(4)
    pose[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    pose[:3, 3] = t.x, t.y, t.z
    return pose


def to_transform(pose, stamp, parent, child):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, stamp
    t, q = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = pose[:3, 3]
    vector = cv2.Rodrigues(pose[:3, :3])[0].ravel()
    angle = np.linalg.norm(vector)
    q.x, q.y, q.z = vector * (math.sin(angle / 2) / angle if angle > 0 else 0.5)
    q.w = math.cos(angle / 2)
    return message


def pitch_and_roll(pose):
    """Of a body; pitch is positive when it looks down."""
    return math.asin(-pose[2, 0]), math.atan2(pose[2, 1], pose[2, 2])


def level_but_for(height, pitch, roll):
    cp, sp, cr, sr = math.cos(pitch), math.sin(pitch), math.cos(roll), math.sin(roll)
    pose = np.eye(4)
    pose[:3, :3] = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    pose[2, 3] = height
    return pose


class Mount:
    """Where tf says that the camera is on the robot: where it is on average, but for an error [rad] of its pitch."""

    def __init__(self, bodies, error):
        tilts = np.array([pitch_and_roll(pose) for pose in bodies])
        heights = [pose[2, 3] for pose in bodies]
        pitch, roll = tilts.mean(0)
        self.pose = level_but_for(np.mean(heights), pitch - error, roll)
        self.height, self.pitch = np.mean(heights), pitch
        self.sway = np.abs(tilts - [pitch, roll]).max(0)  # [rad] the most of pitch and roll
