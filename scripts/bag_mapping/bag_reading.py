"""A bag's messages, as bytes; what is wrong with a bag, in a sentence."""
import collections
import contextlib
import struct

import genpy
import rosbag

Message = collections.namedtuple('Message', 'topic data time')  # bytes; time [ns] at which it was recorded

# What rosbag throws at a file that is damaged: its own errors, and whatever its bytes lead to.
DAMAGE = (rosbag.bag.ROSBagException, struct.error, EOFError, OSError, RuntimeError, ValueError, KeyError, IndexError, MemoryError)


class BagError(Exception):
    """What is wrong with a bag, for the user."""


@contextlib.contextmanager
def damage_told():
    try:
        yield
    except rosbag.bag.ROSBagUnindexedException:
        raise BagError('it has no index: it was cut off or is still being recorded; `rosbag reindex` makes one of what is there')
    except DAMAGE as error:
        raise BagError('it cannot be read: %s' % (str(error) or type(error).__name__))


class Bag:
    """A bag that is open. Its errors are BagErrors."""

    def __init__(self, path):
        if not path.is_file():
            raise BagError('there is no such file' if not path.exists() else 'is no file')
        if path.stat().st_size == 0:
            raise BagError('it is empty')
        with damage_told():
            self._bag = rosbag.Bag(str(path))
            self.types = {topic: info.msg_type for topic, info in self._bag.get_type_and_topic_info().topics.items()}
            self.counts = {topic: info.message_count for topic, info in self._bag.get_type_and_topic_info().topics.items()}
            if self.counts:
                self.start, self.end = self._bag.get_start_time(), self._bag.get_end_time()  # [s]
        if not sum(self.counts.values()):
            raise BagError('it holds no message')

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._bag.close()

    def definition(self, topic):
        """Type, md5sum and text of a topic's messages, as they were recorded."""
        connection = next(self._bag._get_connections([topic]))  # rosbag has no public way to it
        return connection.datatype, connection.md5sum, connection.msg_def

    def messages(self, topics, start=None, end=None):
        """In the order in which they were recorded; start and end [s] of the recording's clock."""
        topics = [topic for topic in topics if topic in self.types]
        if not topics:
            return
        start, end = (None if time is None else genpy.Time.from_sec(time) for time in (start, end))
        with damage_told():
            for topic, raw, time in self._bag.read_messages(topics, start, end, raw=True):
                yield Message(topic, raw[1], time.to_nsec())

    def first(self, topic):
        return next(self.messages([topic])).data


def with_transforms_ahead(messages, is_transform, ahead):
    """Each message that is no transform, with the transforms that were recorded since the one before it.

    They come from `ahead` [ns] beyond the message, so that one which is late by less is there in time.
    """
    waiting, transforms = collections.deque(), []
    for message in messages:
        while waiting and message.time > waiting[0].time + ahead:
            yield waiting.popleft(), transforms
            transforms = []
        if is_transform(message.topic):
            transforms.append(message.data)
        else:
            waiting.append(message)
    while waiting:
        yield waiting.popleft(), transforms
        transforms = []
