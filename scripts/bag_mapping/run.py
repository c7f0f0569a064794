"""One bag from its file to its map."""
import collections
import contextlib
import pathlib
import tempfile
import time

import tf2_py

from bag_mapping import cameras as depth_cameras
from bag_mapping import picture, raw_messages
from bag_mapping.bag_reading import Bag, BagError, with_transforms_ahead
from bag_mapping.lockstep import Lockstep, kind_of
from bag_mapping.map_files import MapFiles
from bag_mapping.nodes import Nodes
from bag_mapping.read_ahead import ReadAhead
from bag_mapping.transforms import MOVING, Transforms, survey

AHEAD = raw_messages.SECOND // 2  # [ns] how far ahead of the frames tf is read
ENDINGS = ('.geojson', '.pgm', '.yaml', '.png')


class Run:
    """Reads a bag, asks the nodes about each frame, and writes what became of it."""

    def __init__(self, path, options, progress):
        self.path, self.options, self.progress = path, options, progress
        self.parameters = options.parameters
        self.folder = options.output or path.parent
        self.frames = self.answered = self.with_floor = 0
        self.refused, self.reasons = collections.Counter(), {}
        self.track = []  # x, y [m] of the robot at each frame that was answered

    def make(self):
        """Writes the files and returns the text about them."""
        begin = time.monotonic()
        with contextlib.ExitStack() as stack:
            # Also for genpy, which would clean up only when Python itself ends the process.
            tempfile.tempdir = stack.enter_context(tempfile.TemporaryDirectory(prefix='map_from_bag.'))
            bag = stack.enter_context(Bag(self.path))
            self.cameras = depth_cameras.choose(bag, self.options)
            topics = [topic for camera in self.cameras for topic in (camera.topic, camera.info) if topic] + [MOVING]
            messages = stack.enter_context(ReadAhead(self.path, topics)).messages()
            fixed, robot = self.parameters.value('fixed_frame'), self.parameters.value('robot_frame')
            self.survey = survey(bag, self.cameras, fixed, robot)
            self.map_size, self.whole_size = self.parameters.map_size(self.survey.low, self.survey.high)
            unfinished = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(
                prefix='.%s.' % self.path.stem, suffix='.unfinished', dir=str(self.folder))))
            nodes = stack.enter_context(Nodes(pathlib.Path(tempfile.tempdir)))
            self._map(bag, messages, nodes, unfinished / self.path.stem)
            self.seconds = bag.end - bag.start
            self.complaints = nodes.complaints()
            self.files = MapFiles(unfinished / self.path.stem)
            picture.draw(self.files, self.track, unfinished / (self.path.stem + '.png'))
            for ending in ENDINGS:
                (unfinished / (self.path.stem + ending)).replace(self.folder / (self.path.stem + ending))
        return self._text(time.monotonic() - begin)

    def _map(self, bag, messages, nodes, path):
        lockstep = Lockstep(nodes, self.cameras, self.parameters, self.map_size)
        lockstep.start(bag, self.survey.standing, (self.survey.low + self.survey.high) / 2.0)
        by_topic = {camera.topic: camera for camera in self.cameras}
        infos = {camera.info: bag.first(camera.info) for camera in self.cameras if camera.info}
        total = sum(bag.counts[topic] for topic in by_topic)
        transforms = Transforms()
        transforms.add_standing(self.survey.standing)
        for message, ahead in with_transforms_ahead(messages, lambda topic: topic == MOVING, AHEAD):
            moved = transforms.add(transform for data in ahead for transform in raw_messages.transforms_in(data))
            lockstep.tell_transforms(moved)
            if message.topic in infos:
                infos[message.topic] = message.data
            else:
                self._ask(lockstep, transforms, by_topic[message.topic], message, infos)
                self.progress(self.frames, total)
        if not self.answered:
            raise BagError('none of its %d frames became part of a map: %s' % (self.frames, self.reasons_text()))
        lockstep.save(path)

    def _ask(self, lockstep, transforms, camera, message, infos):
        self.frames += 1
        stamp = raw_messages.stamp_of(message.data)
        # The node would wait for what does not come, and then say the same.
        reason = transforms.missing(raw_messages.frame_of(message.data), self.parameters.frames(), stamp)
        if not reason:
            has_floor, reason = lockstep.ask(camera, message.data, infos.get(camera.info), message.time)
        if reason:
            kind = kind_of(reason)
            self.refused[kind] += 1
            self.reasons.setdefault(kind, reason)
            return
        self.answered += 1
        self.with_floor += has_floor
        with contextlib.suppress(tf2_py.TransformException):
            self.track.append(transforms.place(self.survey.robot, self.parameters.value('fixed_frame'), stamp))

    def reasons_text(self):
        return '; '.join('%d x %s' % (count, self.reasons[kind]) for kind, count in self.refused.most_common())

    def _text(self, wall):
        base = self.folder / self.path.stem
        lines = ['%s: %s and %s' % (self.path, base.with_name(base.name + ENDINGS[0]), ', '.join(ENDINGS[1:]))]
        counts = '%d frames of %s, %d answered' % (self.frames, ', '.join(c.topic for c in self.cameras), self.answered)
        if self.with_floor < self.answered:
            counts += ' (%d of them without a floor)' % (self.answered - self.with_floor)
        refused = sum(self.refused.values())
        lines.append(counts + ', %d refused' % refused + (': ' + self.reasons_text() if refused else ''))
        lines.append('%.1f s of bag in %.1f s (%.1f times real time)' % (self.seconds, wall, self.seconds / wall))
        lines.append(self.files.text())
        if self.whole_size > self.map_size:
            x, y = (self.survey.low + self.survey.high) / 2.0
            lines.append('cut: what the cameras could see needs a map of %.0f m; this one ends %.1f m from (%.1f, %.1f)' % (
                self.whole_size, self.map_size / 2.0, x, y))
        if self.survey.robot != self.parameters.value('robot_frame'):
            lines.append("tf does not know '%s': the track is that of '%s'" % (self.parameters.value('robot_frame'), self.survey.robot))
        refusals = tuple(self.reasons.values())
        lines += ['the nodes say: ' + text for text in self.complaints if text not in refusals][:5]
        return '\n  '.join(lines)
