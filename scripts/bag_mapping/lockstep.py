"""Frames for the nodes one after the other: each is sent when the one before it has been answered or refused."""
import collections
import re
import threading
import time
import warnings

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from bag_mapping import raw_messages
from bag_mapping.bag_reading import BagError
from bag_mapping.nodes import DEADLINE, wait_for
from bag_mapping.transforms import time_of
from polygonal_perception.srv import MapFile

MAP = '/polygon_map'
MIDDLE = 'map_from_bag_middle'  # the frame that the map rolls with, and that does not move
NOT_FOUND = 0  # of FloorPlane
# A refusal is seen in the diagnostics: it costs so much of a wall clock's time.
DIAGNOSTIC_PERIOD = 0.02  # [s]
TF_TIMEOUT = 1.0  # [s] transforms are known to be under way


def pipeline_name(number, cameras):
    return '/polygonal_perception' + ('_%d' % number if len(cameras) > 1 else '')


def publisher(topic, kind, latch=False):
    """One that has written a message when it returns. Those with a queue drop messages when their threads do not get a turn."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore', SyntaxWarning)  # rospy advises against it
        return rospy.Publisher(topic, kind, latch=latch, tcp_nodelay=True, queue_size=None)


class Lockstep:
    """The nodes of one bag: a pipeline a camera, and the map."""

    def __init__(self, nodes, cameras, parameters, map_size):
        self._nodes, self._cameras, self._parameters = nodes, cameras, parameters
        self._fixed = parameters.value('fixed_frame')
        self._condition = threading.Condition()
        self._answers, self._status = 0, NOT_FOUND
        self._answered_stamp = None
        self._rejections, self._processed, self._reasons = {}, {}, {}
        self._sent = collections.Counter()
        self._pipelines = {camera.name: pipeline_name(k, cameras) for k, camera in enumerate(cameras)}
        self._set_parameters(map_size)

    def _set_parameters(self, map_size):
        rospy.set_param('/use_sim_time', True)
        usual = {'tf_timeout': TF_TIMEOUT, 'diagnostic_period': DIAGNOSTIC_PERIOD}
        for camera in self._cameras:
            values = dict(usual, **self._parameters.of('perception'))
            values.update(input=camera.kind, output_frame=self._fixed, publish_tf=False)
            rospy.set_param(self._pipelines[camera.name], values)
        values = dict(usual, **self._parameters.of('map'))
        values.update(map_size=map_size, fixed_frame=self._fixed, robot_frame=MIDDLE)
        if len(self._cameras) > 1:
            values['sources'] = [name.strip('/') for name in self._pipelines.values()]
        # inf is no number to XML-RPC's readers.
        rospy.set_param(MAP, {name: value for name, value in values.items() if value != float('inf')})

    def start(self, bag, standing, middle):
        """Starts the nodes and connects with them."""
        rospy.init_node('map_from_bag', disable_signals=True, disable_rosout=True)
        for camera in self._cameras:
            name = self._pipelines[camera.name]
            self._nodes.start('polygonal_perception_node', name, ('points', camera.topic), ('depth/image', camera.topic),
                              ('depth/camera_info', camera.topic + '/info_of_each'))
        only = next(iter(self._pipelines.values())) if len(self._cameras) == 1 else None
        self._nodes.start('polygon_map_node', MAP, *([('observed_cells', only + '/observed_cells')] if only else []))
        self._advertise(bag)
        self._subscribe()
        self._standing.publish(TFMessage(standing + [self._middle(middle)]))
        readers = len(self._cameras) + 1
        self._wait(lambda: all(p.get_num_connections() >= readers for p in (self._clock, self._tf, self._standing)), 'the nodes to read tf')
        self._wait(lambda: all(p.get_num_connections() for p in [*self._frames.values(), *self._infos.values()]), 'the pipeline to read the camera')
        self._wait(lambda: all(reader.get_num_connections() >= n for reader, n in self._readers), 'the nodes to answer')
        # A node goes on with the default: here that would be another map than the one that was asked for.
        for text in self._nodes.complaints('ERROR'):
            if text.startswith('parameter'):
                raise BagError(text.split('; ')[0])

    def _middle(self, place):
        transform = TransformStamped(child_frame_id=MIDDLE)
        transform.header.frame_id = self._fixed
        transform.transform.translation.x, transform.transform.translation.y = place
        transform.transform.rotation.w = 1.0
        return transform

    def _advertise(self, bag):
        self._clock = publisher('/clock', Clock)
        self._tf = publisher('/tf', TFMessage)
        self._standing = publisher('/tf_static', TFMessage, latch=True)
        self._frames = {c.name: publisher(c.topic, raw_messages.raw_type(*bag.definition(c.topic))) for c in self._cameras}
        self._infos = {c.name: publisher(c.topic + '/info_of_each', raw_messages.raw_type(*bag.definition(c.info)))
                       for c in self._cameras if c.info}

    def _subscribe(self):
        topics = {MAP + '/polygons', '/diagnostics'}
        nodes = {MAP, *self._pipelines.values()}

        # rospy never connects to a topic that is advertised in the moment in which it subscribes.
        def advertised():
            publishers = dict(rospy.get_master().getSystemState()[2][0])
            return topics <= set(publishers) and nodes <= set(publishers['/diagnostics'])
        self._wait(advertised, 'the nodes to start')
        self._readers = [(rospy.Subscriber(MAP + '/polygons', rospy.AnyMsg, self._on_answer, queue_size=100, tcp_nodelay=True), 1),
                         (rospy.Subscriber('/diagnostics', DiagnosticArray, self._on_diagnostics, queue_size=100), len(nodes))]

    def _wait(self, condition, what):
        return wait_for(condition, what, self._nodes.check_alive)

    def _on_answer(self, message):
        with self._condition:
            self._answers += 1
            self._answered_stamp = raw_messages.stamp_of(message._buff)
            self._status = raw_messages.floor_status_of(message._buff)
            self._condition.notify_all()

    def _on_diagnostics(self, message):
        with self._condition:
            for status in message.status:
                values = {pair.key: pair.value for pair in status.values}
                name = '/' + status.name.split(':')[0]
                self._rejections[name] = int(values['Frames rejected'])
                self._processed[name] = int(values['Frames answered']) + self._rejections[name]
                self._reasons[name] = values['Last rejection']
            self._condition.notify_all()

    def tell_transforms(self, transforms):
        """The newest first: where one is in the nodes' tf, those after it are, too, or a place at its own time would differ in the last bit.

        All in one message, for a reader's queue holds a hundred, and half a second may have more.
        """
        if transforms:
            self._tf.publish(TFMessage(transforms[::-1]))

    def ask(self, camera, frame, info, time_recorded):
        """Sends a frame; whether the map took it with a floor, and why it was refused."""
        stamp, pipeline = raw_messages.stamp_of(frame), self._pipelines[camera.name]
        with self._condition:
            answers = self._answers
            rejected = {name: self._rejections.get(name, 0) for name in (pipeline, MAP)}
        self._sent[pipeline] += 1
        self._clock.publish(Clock(time_of(time_recorded)))
        if info is not None:
            self._infos[camera.name].publish(raw_messages.with_stamp_of(info, frame))
        self._frames[camera.name].publish(frame)

        def outcome():
            if self._answers > answers and self._answered_stamp == stamp:
                return self._status != NOT_FOUND, ''
            if self._processed.get(pipeline, 0) >= self._sent[pipeline]:
                for name, count in rejected.items():
                    if self._rejections.get(name, 0) > count:
                        return False, self._reasons[name]
            return None
        end = time.monotonic() + DEADLINE
        with self._condition:
            while True:
                result = outcome()
                if result is not None:
                    return result
                if not self._condition.wait(1.0):
                    self._nodes.check_alive()
                if time.monotonic() > end:
                    raise BagError('the nodes say nothing of a frame: %s' % self._nodes.last_lines())

    def save(self, path):
        """What the map writes; its own sentence about it."""
        rospy.wait_for_service(MAP + '/save', DEADLINE)
        answer = rospy.ServiceProxy(MAP + '/save', MapFile)(str(path))
        if not answer.success:
            raise BagError('the map cannot be saved: %s' % answer.message)
        return answer.message


def kind_of(reason):
    """Reasons that differ in a number are one, and those for which tf has no transform."""
    if reason.startswith('no transform'):
        return reason.split(': ')[0]
    return re.sub(r'\d+(\.\d+)?', '#', reason)
