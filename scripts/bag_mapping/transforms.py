"""A bag's transforms: those that stand still, and where cameras and robot went."""
import collections
import contextlib

import genpy
import numpy as np
import tf2_py

from bag_mapping import raw_messages
from bag_mapping.bag_reading import BagError

MOVING, STANDING = '/tf', '/tf_static'
STEP = raw_messages.SECOND // 10  # [ns] between two looks at where a camera is
# A compressed bag is unpacked to the last image for all of its transforms: of a long one a part has to do.
SHORT, PERIOD, PART = 5.0, 1.0, 0.2  # [s]

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
        """Returns those that are new: tf2 complains of each that comes twice."""
        new = []
        for transform in transforms:
            stamp = transform.header.stamp.to_nsec()
            if self._newest.get(transform.child_frame_id) != stamp:
                self._newest[transform.child_frame_id] = stamp
                self._buffer.set_transform(transform, 'bag')
                new.append(transform)
        return new

    def place(self, frame, fixed, stamp):
        """Where a frame is in another one, x and y; raises tf2_py.TransformException. Stamp 0: at the newest time."""
        t = self._buffer.lookup_transform_core(fixed, frame, time_of(stamp)).transform.translation
        return t.x, t.y

    def missing(self, frame, targets, stamp):
        """Why one of the targets cannot be reached from a frame at a frame's stamp, or nothing."""
        if stamp == 0:
            return "no transform from '%s': header.stamp is 0, accepted is the frame's time" % frame
        for target in targets:
            try:
                self._buffer.lookup_transform_core(target, frame, time_of(stamp))
            except tf2_py.TransformException as reason:
                return "no transform from '%s' to '%s': %s" % (frame, target, str(reason).strip(' .'))
        return ''

    def frames(self):
        names = {line.split(':')[0].strip() for line in self._buffer.all_frames_as_yaml().splitlines() if line[:1].strip()}
        return sorted(names | set(self._newest))


def standing_in(bag):
    """The newest of each."""
    transforms = {}
    for message in bag.messages([STANDING]):
        transforms.update((transform.child_frame_id, transform) for transform in raw_messages.transforms_in(message.data))
    return list(transforms.values())


def part_of(bag):
    """A fifth of each second's transforms, and the last ones; all of a short bag."""
    if bag.end - bag.start < SHORT:
        yield from bag.messages([MOVING])
        return
    begin = bag.start
    while begin + PERIOD < bag.end:
        yield from bag.messages([MOVING], begin, begin + PART)
        begin += PERIOD
    yield from bag.messages([MOVING], bag.end - PERIOD)


class Ways:
    """Where cameras and robot go in the fixed frame, as transforms come in."""

    def __init__(self, frames, fixed, robot, standing):
        self.frames, self.fixed, self.robot = frames, fixed, robot
        self.known, self.places, self.has_robot = Transforms(), {frame: [] for frame in frames}, False
        self.known.add_standing(standing)

    def follow(self, messages):
        last = None
        for message in messages:
            self.known.add(raw_messages.transforms_in(message.data))
            if last is None or not 0 <= message.time - last < STEP:
                last = message.time
                self.look()
        self.look()
        return all(self.places.values())

    def look(self):
        for frame, places in self.places.items():
            with contextlib.suppress(tf2_py.TransformException):
                places.append(self.known.place(frame, self.fixed, 0))
        if not self.has_robot:
            with contextlib.suppress(tf2_py.TransformException):
                self.has_robot = bool(self.known.place(self.robot, self.fixed, 0))

    def bounds(self):
        """Two corners, with as much around them as a camera moves between two looks."""
        places = [np.array(places) for places in self.places.values()]
        stride = max(np.abs(np.diff(way, axis=0)).max(initial=0.0) for way in places) / 2.0
        places = np.vstack(places)
        return places.min(0) - stride, places.max(0) + stride


def survey(bag, cameras, fixed, robot):
    """Looks through the transforms: whether tf places the cameras in the fixed frame, and within which bounds they move.

    Also whether it knows the robot's frame.
    """
    if MOVING not in bag.types and STANDING not in bag.types:
        raise BagError('it holds no tf: a map needs to know where the camera is in %s' % fixed)
    frames, standing = sorted({camera.frame for camera in cameras}), standing_in(bag)
    # Transforms that come seldom are not in each part.
    for messages in (part_of(bag), bag.messages([MOVING])):
        ways = Ways(frames, fixed, robot, standing)
        if ways.follow(messages) and ways.has_robot:
            break
    for frame, places in ways.places.items():
        if not places:
            raise BagError("its tf does not lead from '%s' to '%s'; it knows %s (fixed_frame:=NAME takes another one)" % (
                frame, fixed, ', '.join(ways.known.frames()) or 'no frame'))
    return Survey(standing, *ways.bounds(), robot if ways.has_robot else frames[0])
