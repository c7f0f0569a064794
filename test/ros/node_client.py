"""Feeds a node under test and collects what it publishes, with deadlines and without sleeps."""
import threading
import time

import rospy
import std_srvs.srv
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import OccupancyGrid
from pcl_msgs.msg import ModelCoefficients
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud2
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from polygonal_perception.msg import FloorPlane, ObservedCells, PlaneArray, PolygonArray

OUTPUTS = {
    'floor': FloorPlane,
    'floor_coefficients': ModelCoefficients,
    'planes': PlaneArray,
    'occupancy_grid': OccupancyGrid,
    'observed_grid': OccupancyGrid,
    'observed_cells': ObservedCells,
    'scan': LaserScan,
    'inflated_grid': OccupancyGrid,
    'polygons': PolygonArray,
    'markers': MarkerArray,
    'obstacle_points': PointCloud2,
    'samples': Image,
}
NOT_FOUND, FOUND, HELD, ASSUMED = FloorPlane.NOT_FOUND, FloorPlane.FOUND, FloorPlane.HELD, FloorPlane.ASSUMED
DEADLINE = 30.0  # [s] on a busy machine
PATIENCE = 5.0  # [s] with a reader that finds no publisher


def header_of(message):
    return message.markers[0].header if isinstance(message, MarkerArray) else message.header


class NodeClient:
    """Talks to a node whose inputs are under a camera's namespace. It runs already, or is not awaited."""

    OUTPUTS = OUTPUTS
    SHARED_TOPICS = ('/tf', '/rosout', '/diagnostics')  # on which it publishes, too

    def __init__(self, outputs=('floor', 'occupancy_grid', 'inflated_grid', 'polygons'), node='/polygonal_perception',
                 runs=True, **inputs):
        self.node = node
        self.condition = threading.Condition()
        self.readers, self.listeners = {}, {}
        if runs:
            self.wait_advertised()
        self.answers, self.logs, self.diagnostics, self.transforms = {}, [], [], []
        self.listeners = {
            '/rosout': rospy.Subscriber('/rosout', Log, lambda m: self._append(self.logs, m)),
            '/tf': rospy.Subscriber('/tf', TFMessage, lambda m: [self._append(self.transforms, t) for t in m.transforms]),
            '/diagnostics': rospy.Subscriber('/diagnostics', DiagnosticArray, self._on_diagnostics),
        }
        self.publishers = self._advertise(**inputs)
        for name in outputs:
            self.read(name)
        if outputs:
            self.wait_connected()

    def _advertise(self, depth=False, image='image_rect', camera='/camera/depth'):
        if depth:
            self.image = rospy.Publisher(camera + '/' + image, Image, queue_size=10)
            self.info = rospy.Publisher(camera + '/camera_info', CameraInfo, queue_size=10)
            return [self.image, self.info]
        self.cloud = rospy.Publisher(camera + '/points', PointCloud2, queue_size=10)
        return [self.cloud]

    def _append(self, to, message):
        with self.condition:
            to.append(message)
            self.condition.notify_all()

    def _on_diagnostics(self, message):
        for status in message.status:
            if status.name.startswith(self.node[1:] + ':'):
                self._append(self.diagnostics, status)

    def _on_answer(self, name, message):
        with self.condition:
            self.answers.setdefault(header_of(message).stamp.to_nsec(), {})[name] = message
            self.condition.notify_all()

    def read(self, name):
        self.readers[name] = rospy.Subscriber(self.node + '/' + name, self.OUTPUTS[name],
                                              lambda m, name=name: self._on_answer(name, m), queue_size=50)

    def listen(self, topic, kind, callback):
        """A reader of somebody else's topic, which is awaited as in wait_advertised()."""
        self.wait_for(lambda: topic in dict(rospy.get_published_topics()), topic + ' to be advertised')
        return rospy.Subscriber(topic, kind, callback)

    def stop_reading(self, name):
        self.readers.pop(name).unregister()

    def _read_anew(self):
        """Subscribes once more to what has no connection.

        Of a topic that goes and comes back roscore's news may overtake one another, and rospy then stays without its publisher.
        """
        for name in [name for name, reader in self.readers.items() if reader.get_num_connections() == 0]:
            self.stop_reading(name)
            self.read(name)
        for topic, reader in self.listeners.items():
            if reader.get_num_connections() == 0:
                kind, callback = reader.data_class, reader.callback  # unregister() takes them
                reader.unregister()
                self.listeners[topic] = rospy.Subscriber(topic, kind, callback)

    def close(self):
        for end in [*self.publishers, *self.readers.values(), *self.listeners.values()]:
            end.unregister()

    def wait_for(self, condition, what, deadline=DEADLINE):
        """Waits until condition() gives something, and returns it."""
        begin = time.monotonic()
        end, read_anew = begin + deadline, begin + PATIENCE
        with self.condition:
            while True:
                result = condition()
                if result:
                    return result
                left = end - time.monotonic()
                if left <= 0:
                    raise AssertionError('waited %.0f s in vain for %s' % (deadline, what))
                if time.monotonic() > read_anew:
                    self._read_anew()
                    read_anew = time.monotonic() + PATIENCE
                # Connections come and go without a notification.
                self.condition.wait(min(left, 0.05))

    def wait_advertised(self):
        """Waits until the node has advertised what it publishes.

        rospy never connects to a topic that is advertised in the moment in which it subscribes: the master's answer, which
        does not have the new publisher, may overtake the news of it.
        """
        topics = [self.node + '/' + name for name in self.OUTPUTS] + list(self.SHARED_TOPICS)

        def advertised():
            publishers = dict(rospy.get_master().getSystemState()[2][0])
            process = set(publishers.get(topics[0], []))
            return process and all(process <= set(publishers.get(topic, [])) for topic in topics)
        # Twice as long, since launch files may start others first.
        self.wait_for(advertised, self.node + ' to advertise ' + ', '.join(topics), 2 * DEADLINE)

    def wait_connected(self):
        self.wait_for(lambda: all(p.get_num_connections() > 0 for p in self.publishers),
                      'the node to subscribe to ' + ', '.join(p.resolved_name for p in self.publishers))
        self.wait_for(lambda: all(r.get_num_connections() > 0 for r in [self.listeners[self.SHARED_TOPICS[0]], *self.readers.values()]),
                      'the node to publish')

    def send(self, *messages):
        for message in messages:
            by_type = {p.data_class: p for p in self.publishers}
            by_type[type(message)].publish(message)

    def answer(self, stamp, names=None, deadline=DEADLINE):
        """What the node published for a stamp, by topic; waits until `names` (default: all that are read) are there."""
        names = set(self.readers if names is None else names)
        key = stamp.to_nsec()
        try:
            self.wait_for(lambda: names <= set(self.answers.get(key, {})), 'an answer', deadline)
        except AssertionError as error:
            raise AssertionError('%s: got %s of %s for %s' % (error, sorted(self.answers.get(key, {})), sorted(names), stamp))
        return self.answers[key]

    def ask(self, message, names=None):
        self.send(message)
        return self.answer(message.header.stamp, names)

    def ask_until_answered(self, make_messages, deadline=2 * DEADLINE):
        """Sends what make_messages() gives, again and again, until it is answered: for a node that comes and goes."""
        asked = []

        def answer():
            # A question more each tenth of a second.
            if not asked or time.monotonic() - asked[-1][1] > 0.1:
                messages = make_messages()
                self.send(*messages)
                asked.append((messages[0].header.stamp.to_nsec(), time.monotonic()))
            return next((self.answers[key] for key, _ in asked if set(self.readers) <= set(self.answers.get(key, {}))), None)

        return self.wait_for(answer, 'an answer', deadline)

    def answered(self, stamp):
        return sorted(self.answers.get(stamp.to_nsec(), {}))

    def wait_for_log(self, *texts):
        """The first log message that has all the texts in it."""
        try:
            return self.wait_for(lambda: next((l.msg for l in self.logs if all(t in l.msg for t in texts)), None), 'a log')
        except AssertionError:
            raise AssertionError('no log message with %s; there were:\n%s' % (texts, '\n'.join(l.msg for l in self.logs)))

    def wait_for_diagnostics(self, condition, what):
        try:
            return self.wait_for(lambda: next((s for s in reversed(self.diagnostics[-1:]) if condition(s)), None), what)
        except AssertionError:
            raise AssertionError('no diagnostics with %s; the last were:\n%s' % (what, self.diagnostics[-1:]))

    def reset(self):
        rospy.wait_for_service(self.node + '/reset', DEADLINE)
        return rospy.ServiceProxy(self.node + '/reset', std_srvs.srv.Trigger)()


class Clock:
    """Stamps a thirtieth of a second apart."""

    def __init__(self, start=None):
        self.now = start or rospy.Time.now()

    def tick(self, seconds=1.0 / 30.0):
        self.now = self.now + rospy.Duration(seconds)
        return self.now
