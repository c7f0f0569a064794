"""A bag's transforms: those that stand still, and where cameras and robot went."""
import collections

import genpy
import numpy as np
import tf2_py

from bag_mapping import raw_messages
from bag_mapping.bag_reading import BagError

MOVING, STANDING = '/tf', '/tf_static'
STEP = raw_messages.SECOND // 10  # [ns] between two looks at where a camera is

# transforms: those that stand still; low, high: where cameras were [m]; robot: its frame, or a camera's where tf has none
Survey = collections.namedtuple('Survey', 'standing low high robot')


def time_of(nanoseconds):
    return genpy.Time(*divmod(nanoseconds, raw_messages.SECOND))


class Transforms:
    """What tf knows at a moment of the bag: the nodes' own library, so that it says what they would."""

    def __init__(self):
        self._buffer = tf2_py.BufferCore(genpy.Duration(10))  # [s] as long as the nodes remember
        self._newest = {}

    def add_standing(self, transforms):
        for transform in transforms:
            self._buffer.set_transform_static(transform, 'bag')

    def add(self, transforms):
        for transform in transforms:
            stamp = transform.header.stamp.to_nsec()
            # tf2 complains of each that comes twice.
            if self._newest.get(transform.child_frame_id) != stamp:
                self._newest[transform.child_frame_id] = stamp
                self._buffer.set_transform(transform, 'bag')

    def place(self, frame, fixed, stamp):
        """Where a frame is in another one, x and y; raises tf2_py.TransformException. Stamp 0: at the newest time."""
        t = self._buffer.lookup_transform_core(fixed, frame, time_of(stamp)).transform.translation
        return t.x, t.y

    def missing(self, frame, targets, stamp):
        """Why one of the targets cannot be reached from a frame, or nothing."""
        for target in targets:
            try:
                self._buffer.lookup_transform_core(target, frame, time_of(stamp))
            except tf2_py.TransformException as reason:
                return "no transform from '%s' to '%s': %s" % (frame, target, reason)
        return ''

    def frames(self):
        names = {line.split(':')[0].strip() for line in self._buffer.all_frames_as_yaml().splitlines() if line[:1].strip()}
        return sorted(names | set(self._newest))


def standing_in(bag):
    """The newest of each."""
    transforms = {}
    for message in bag.messages([STANDING] if STANDING in bag.types else []):
        transforms.update((transform.child_frame_id, transform) for transform in raw_messages.transforms_in(message.data))
    return list(transforms.values())


def survey(bag, cameras, fixed, robot):
    """Looks through all transforms: whether tf places the cameras in the fixed frame, and within which bounds they move.

    Also whether it knows the robot's frame.
    """
    if MOVING not in bag.types and STANDING not in bag.types:
        raise BagError('it holds no tf: a map needs to know where the camera is in %s' % fixed)
    known = Transforms()
    standing = standing_in(bag)
    known.add_standing(standing)
    frames = sorted({camera.frame for camera in cameras})
    places, has_robot, last = [], False, None

    def look():
        nonlocal has_robot
        for frame in frames:
            try:
                places.append(known.place(frame, fixed, 0))
            except tf2_py.TransformException:
                pass
        if not has_robot:
            has_robot = not known.missing(robot, [fixed], 0)
    for message in bag.messages([MOVING] if MOVING in bag.types else []):
        known.add(raw_messages.transforms_in(message.data))
        if last is None or not 0 <= message.time - last < STEP:
            last = message.time
            look()
    look()
    for frame in frames:
        missing = known.missing(frame, [fixed], 0)
        if missing:
            raise BagError("its tf does not lead from '%s' to '%s'; it knows %s (fixed_frame:=NAME takes another one)" % (
                frame, fixed, ', '.join(known.frames()) or 'no frame'))
    return Survey(standing, np.min(places, 0), np.max(places, 0), robot if has_robot else frames[0])
