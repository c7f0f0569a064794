"""Bags of a robot that drives past boxes: made here, so that it is known where everything stands."""
import math

import numpy as np
import rosbag
import rospy
from tf2_msgs.msg import TFMessage

import scene

START = 1000.0  # [s] stamp of the first frame
RATE = 10.0  # [Hz]
HEIGHT, PITCH, AHEAD = 1.0, 0.5, 0.1  # [m], [rad], [m] of the camera on the robot
# [m] in odom. The robot drives from (0, 0) along x, and turns to the left.
STANDING = {'crate': scene.Box((2.0, 2.4), (-1.2, -0.8), (0.0, 0.5)),
            'post': scene.Box((2.6, 2.7), (0.6, 0.7), (0.0, 1.5)),
            'wall': scene.Box((4.5, 4.6), (-2.0, 3.0), (0.0, 1.2))}
LEAVING = scene.Box((2.0, 2.3), (-0.3, 0.0), (0.0, 0.5))  # is there in the first second


def about_z(yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def pose(t):
    """x, y and yaw of the robot, and its place, after t seconds."""
    yaw = 0.35 * max(0.0, t - 2.0)
    return np.array([0.4 * t, 0.15 * max(0.0, t - 2.0), 0.0]), yaw


def boxes_at(t):
    return list(STANDING.values()) + ([LEAVING] if t < 1.0 else [])


def standing_camera():
    """What tf says of the camera on the robot, which stays as it is."""
    view = scene.Camera(HEIGHT, PITCH)
    return scene.transform('base_link', scene.OPTICAL_FRAME, (AHEAD, 0.0, HEIGHT), view.rotation)


def view_from(t):
    """The camera in odom."""
    position, yaw = pose(t)
    view = scene.Camera(HEIGHT, PITCH)
    view.position = position + about_z(yaw) @ [AHEAD, 0.0, HEIGHT]
    view.rotation = about_z(yaw) @ view.rotation
    return view


def write(path, seconds=4.0, kind='depth', with_tf=True, tf_from=0.0, change=None, camera='camera', compression='lz4'):
    """A run of so many seconds. change(k, messages) makes other messages, by topic, of those of frame k."""
    names = {'depth': ('image_raw', 'camera_info'), 'cloud': ('points',)}[kind]
    # As a simulated clock has them: camera and transforms do not beat in step.
    with rosbag.Bag(str(path), 'w', compression=compression) as bag:
        if with_tf:
            bag.write('/tf_static', TFMessage([standing_camera()]), rospy.Time.from_sec(START))
            for k in range(int(-0.1 * 50), int((seconds + 0.1) * 50)):
                t = k / 50.0
                if t < tf_from:
                    continue
                position, yaw = pose(t)
                moving = scene.transform('odom', 'base_link', position, about_z(yaw))
                moving.header.stamp = rospy.Time.from_sec(START + t)
                # Odometry is often late.
                bag.write('/tf', TFMessage([moving]), moving.header.stamp + rospy.Duration(0.05))
        for k in range(int(seconds * RATE)):
            t, view = k / RATE, view_from(k / RATE)
            stamp = rospy.Time.from_sec(START + t)
            depth = view.render(boxes_at(t))
            made = (view.image(depth, stamp), view.info(stamp)) if kind == 'depth' else (view.cloud(depth, stamp),)
            messages = {'/%s/depth/%s' % (camera, name): message for name, message in zip(names, made)}
            for topic, message in (change(k, messages) if change else messages).items():
                bag.write(topic, message, stamp + rospy.Duration(0.01))
    return path
