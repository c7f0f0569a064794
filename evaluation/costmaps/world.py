"""One run: a simulated camera, what reads it, the time, and tf as the robot has it."""
import os
import subprocess
import threading
import time
import xmlrpc.client

import numpy as np
import rosgraph
import rospy
from nav_msgs.msg import OccupancyGrid
from nodelet.srv import NodeletList
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, LaserScan
from tf2_msgs.msg import TFMessage

from polygonal_perception.msg import PolygonArray

from poses import OPTICAL, Mount, to_pose, to_transform
from settings import RAW_CLOUD, UPDATES

RATE = 30  # [Hz] frames
UPDATE = round(RATE / UPDATES)  # frames from one update of a costmap to the next
DEADLINE = 60.0  # [s] for a node to start, and for what must come
PATIENCE = 2.0  # [s] for what may be late
CAMERA, MANAGER = '/simulated_camera', '/camera_manager'
TRUTH = CAMERA + '/ground_truth/obstacles'
OPTICAL_FRAME = 'camera_depth_optical_frame'


class Failure(Exception):
    """A run that cannot go on, and why."""


class Nodes:
    def __init__(self, programs):
        self.programs, self.processes = programs, {}

    def start(self, name, program, *arguments):
        command = [os.path.join(self.programs, program)] if isinstance(program, str) else program
        shown = None if os.environ.get('COMPARE_COSTMAPS_VERBOSE') else subprocess.DEVNULL
        self.processes[name] = subprocess.Popen([*command, '__name:=' + name, *arguments], stdout=shown, stderr=shown)

    def cpu(self):
        """[s] of CPU time that each has taken so far."""
        return {name: self._cpu(process.pid) for name, process in self.processes.items()}

    @staticmethod
    def _cpu(pid):
        with open('/proc/%d/stat' % pid) as file:
            user, system = file.read().rpartition(')')[2].split()[11:13]
        return (int(user) + int(system)) / os.sysconf('SC_CLK_TCK')

    def check(self):
        for name, process in self.processes.items():
            if process.poll() is not None:
                raise Failure('%s has ended with exit code %d' % (name, process.returncode))

    def stop(self):
        for process in self.processes.values():
            process.terminate()
        for process in self.processes.values():
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.processes.clear()


class Run:
    """What came of one."""

    def __init__(self, case, seed):
        self.case, self.seed, self.mount = case, seed, None
        self.start, self.poses = 0.0, {}  # by stamp [ns]: of the robot in odom, and of its camera's body on it
        self.images, self.info, self.truth = {}, None, None
        self.grids = {}  # by map: (stamp [s], message)
        self.cpu = {}  # by node: [s] a frame
        self.late = 0  # answers that had not come when time went on


class World:
    """Time stands still until what is expected of a frame has come: however busy the machine is, all see each frame."""

    def __init__(self, options):
        self.options = options
        self.condition = threading.Condition()
        self.nodes = Nodes(options.programs)
        self.now, self.run, self.readers = 10.0, None, []
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10, latch=True)
        self.tf = rospy.Publisher('/tf', TFMessage, queue_size=100)
        rospy.Subscriber('/true_tf', TFMessage, self._on_true_tf, queue_size=1000)

    def make_run(self, case, seed):
        try:
            motion = self._motion(case, seed)
            self.run = Run(case, seed)
            self.run.mount = Mount([body for _, body in motion], case.error)
            self._start_readers(case, motion[0])
            self._start_camera(case, seed)
            self._read_camera()
            self._play(motion)
            return self.run
        finally:
            self.nodes.stop()
            for reader in self.readers:
                reader.unregister()
            self.readers, self.run = [], None

    def _motion(self, case, seed):
        """The robot's poses in the run to come: its camera moves through it unseen."""
        self.run = Run(case, seed)
        self._start_camera(case, seed)
        start = self.now
        motion = [self.run.poses[self._next_frame(start, number)] for number in range(1, self.options.frames + 1)]
        self.nodes.stop()
        return motion

    def _start_readers(self, case, first):
        rospy.set_param('/polygonal_perception', dict(case.parameters, input='cloud'))
        self.nodes.start('polygonal_perception', 'polygonal_perception_node', 'points:=' + RAW_CLOUD)
        for each in self.options.maps:
            self.run.grids[each] = []
            if each.is_costmap:
                rospy.set_param('/%s/costmap' % each.node, each.parameters(case))
                self.nodes.start(each.node, ['rosrun', 'costmap_2d', 'costmap_2d_node'])
                self._read(each.topic, OccupancyGrid, lambda message, each=each: self._on_grid(each, message))
            else:
                rospy.set_param('/' + each.node, {'fixed_frame': 'odom', 'robot_frame': 'base_link'})
                self.nodes.start(each.node, 'polygon_map_node', 'observed_cells:=/polygonal_perception/observed_cells')
                self._read(each.topic, OccupancyGrid, lambda message: setattr(self, 'newest_map', message), queue_size=1)
        self._read('/polygonal_perception/scan', LaserScan, self._on_scan)
        self.scans, self.newest_map = 0, None

        def ready():
            # tf is where the run will begin.
            self._set_time(self.now + 0.01)
            self._send_tf(rospy.Time.from_sec(self.now), *first)
            return all(self.run.grids[each] for each in self.options.maps if each.is_costmap)
        self._wait(ready, 'the costmaps')

    def _start_camera(self, case, seed):
        options = self.options
        rospy.set_param(CAMERA, {
            'scene': options.scene, 'trajectory': case.robot, 'seed': seed, 'rate': RATE, 'width': options.width,
            'height': options.width * 3 // 4, 'max_height': case.max_height, 'base_frame': 'base', 'camera_frame': 'body',
            'optical_frame': OPTICAL_FRAME})
        # Not as a node of its own: a nodelet begins when its manager knows the time.
        remaps = '/tf:=/true_tf', '/tf_static:=/true_tf_static'
        self.nodes.start(MANAGER[1:], ['rosrun', 'nodelet', 'nodelet', 'manager'], *remaps)
        self._wait(lambda: self._set_time(self.now) or self._connections('/clock', 'i') > 0, 'the manager of the camera')
        load = ['load', 'polygonal_perception/SimulatedCamera', MANAGER, '--no-bond']
        self.nodes.start(CAMERA[1:], ['rosrun', 'nodelet', 'nodelet', *load], *remaps)
        loaded = rospy.ServiceProxy(MANAGER + '/list', NodeletList)
        self._wait(lambda: CAMERA in loaded().nodelets and self._connections('/true_tf') > 0, 'the simulated camera')

    def _read_camera(self):
        self._read('/camera/depth/image_raw', Image, self._on_image)
        self._read('/camera/depth/camera_info', CameraInfo, lambda message: setattr(self.run, 'info', message))
        self._read(TRUTH, PolygonArray, lambda message: setattr(self.run, 'truth', message))
        expected = {RAW_CLOUD: 1 + sum(each.reads_cloud for each in self.options.maps), '/camera/depth/image_raw': 1,
                    '/camera/depth/camera_info': 1, TRUTH: 1}
        self._wait(lambda: all(self._connections(topic) == count for topic, count in expected.items()),
                   'all to read the camera')

    def _play(self, motion):
        run, costmaps = self.run, [each for each in self.options.maps if each.is_costmap]
        for grids in run.grids.values():
            grids.clear()
        run.start, before = self.now, self.nodes.cpu()
        for number, (base, _) in enumerate(motion, 1):
            stamp = self._next_frame(run.start, number)
            if not np.allclose(run.poses[stamp][0], base, atol=1e-9):
                raise Failure('the camera moves otherwise than it did before')
            self._wait(lambda: stamp in run.images, 'an image')
            self._wait_a_little(lambda: self.scans >= number)
            if number % UPDATE == 0:
                updates = number // UPDATE
                self._wait_a_little(lambda: all(len(run.grids[each]) >= updates for each in costmaps))
                for each in self.options.maps:
                    if not each.is_costmap and self.newest_map is not None:
                        self._on_grid(each, self.newest_map)
            self.nodes.check()
        run.cpu = {name: (after - before[name]) / len(motion) for name, after in self.nodes.cpu().items()}

    # Time.

    def _set_time(self, now):
        self.now = now
        self.clock.publish(Clock(clock=rospy.Time.from_sec(now)))

    def _next_frame(self, start, number):
        """Lets time go on by one frame's and returns its stamp."""
        before = len(self.run.poses)
        self._set_time(start + number / RATE + 0.001)
        self._wait(lambda: len(self.run.poses) > before, 'frame %d' % number)
        return max(self.run.poses)

    def _wait(self, condition, what, deadline=DEADLINE):
        end = time.monotonic() + deadline
        with self.condition:
            while not condition():
                if time.monotonic() > end:
                    raise Failure('waited %.0f s in vain for %s' % (deadline, what))
                self.nodes.check()
                self.condition.wait(0.01)

    def _wait_a_little(self, condition):
        try:
            self._wait(condition, '', PATIENCE)
        except Failure:
            self.nodes.check()
            self.run.late += 1

    # What comes, and goes.

    def _read(self, topic, kind, callback, queue_size=50):
        def locked(message):
            with self.condition:
                if self.run is not None:
                    callback(message)
                self.condition.notify_all()
        self.readers.append(rospy.Subscriber(topic, kind, locked, queue_size=queue_size))

    def _on_true_tf(self, message):
        found = {t.child_frame_id: to_pose(t.transform) for t in message.transforms}
        stamp = message.transforms[0].header.stamp
        with self.condition:
            if self.run is None or 'base' not in found:
                return
            if self.run.mount is not None:
                self._send_tf(stamp, found['base'], found['body'])
            self.run.poses[stamp.to_nsec()] = found['base'], found['body']
            self.condition.notify_all()

    def _send_tf(self, stamp, base, true_body):
        body = true_body if self.run.case.tf_knows else self.run.mount.pose
        self.tf.publish(TFMessage([to_transform(base, stamp, 'odom', 'base_footprint'),
                                   to_transform(np.eye(4), stamp, 'base_footprint', 'base_link'),
                                   to_transform(body, stamp, 'base_link', 'camera_link'),
                                   to_transform(OPTICAL, stamp, 'camera_link', OPTICAL_FRAME)]))

    def _on_image(self, message):
        image = np.frombuffer(message.data, np.uint16).reshape(message.height, message.width)
        self.run.images[message.header.stamp.to_nsec()] = image

    def _on_grid(self, each, message):
        self.run.grids[each].append((message.header.stamp.to_sec(), message))

    def _on_scan(self, _):
        self.scans += 1

    @staticmethod
    def _connections(topic, direction='o'):
        """That the camera has to its readers. Those of one process have one in common."""
        try:
            uri = rosgraph.Master(rospy.get_name()).lookupNode(MANAGER)
            links = xmlrpc.client.ServerProxy(uri).getBusInfo(rospy.get_name())[2]
        except (rosgraph.MasterException, OSError):
            return 0  # not there yet
        return sum(link[2] == direction and link[4] == topic for link in links)
