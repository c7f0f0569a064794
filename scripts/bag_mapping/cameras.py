"""Which of a bag's topics are depth cameras."""
import collections
import re

from bag_mapping import raw_messages
from bag_mapping.bag_reading import BagError

# name: the camera's namespace; kind: depth or cloud; topic: of the images or clouds; info: of the camera_infos, or None
Camera = collections.namedtuple('Camera', 'name kind topic info frame')

IMAGE, INFO, CLOUD = 'sensor_msgs/Image', 'sensor_msgs/CameraInfo', 'sensor_msgs/PointCloud2'
DEPTH_ENCODINGS = ('16UC1', '32FC1', 'mono16')
# Rectified images first, the depth camera's own view before one that was carried over to another camera's.
PREFERRED = ('image_rect', 'image_rect_raw', 'image_raw', 'image')


def name_of(topic):
    """The camera's namespace: what comes before the part that is called depth, or the topic's own."""
    parts = topic.strip('/').split('/')
    before = next((k for k, part in enumerate(parts[:-1]) if re.match(r'depth|aligned_depth|points?$', part)), len(parts) - 1)
    return '/' + '/'.join(parts[:max(before, 1)])


def info_beside(bag, topic):
    info = topic.rpartition('/')[0] + '/camera_info'
    return info if bag.types.get(info) == INFO else None


def rank(camera):
    folder, _, last = camera.topic.rpartition('/')
    is_own = re.search(r'registered|aligned', folder) is None
    return (camera.kind != 'depth', not is_own, PREFERRED.index(last) if last in PREFERRED else len(PREFERRED), camera.topic)


def depth_camera(bag, topic, info):
    first = bag.first(topic)
    if raw_messages.size_and_encoding(first)[2] not in DEPTH_ENCODINGS:
        return None
    return Camera(name_of(topic), 'depth', topic, info, raw_messages.frame_of(first))


def cloud_camera(bag, topic):
    first = bag.first(topic)
    if raw_messages.cloud_size(first)[1] <= 1:
        return None
    return Camera(name_of(topic), 'cloud', topic, None, raw_messages.frame_of(first))


def all_in(bag):
    """Every topic that a pipeline can read, the best of a camera first; and why others cannot be read."""
    found, unfit = [], []
    for topic, kind in sorted(bag.types.items()):
        if kind == IMAGE:
            info = info_beside(bag, topic)
            camera = depth_camera(bag, topic, info)
            if camera and not info:
                unfit.append('%s has no camera_info beside it' % topic)
            elif camera:
                found.append(camera)
        elif kind == CLOUD:
            camera = cloud_camera(bag, topic)
            if camera:
                found.append(camera)
            else:
                unfit.append('the clouds of %s are not organised' % topic)
        elif kind == 'sensor_msgs/CompressedImage' and topic.endswith('/compressedDepth'):
            unfit.append('%s is compressed, which the bag tool does not read' % topic)
    return sorted(found, key=rank), unfit


def named(bag, options):
    """The one camera whose topics were given."""
    topic = options.image or options.points
    wanted = IMAGE if options.image else CLOUD
    if bag.types.get(topic) != wanted:
        there = ', '.join(sorted(t for t, kind in bag.types.items() if kind == wanted)) or 'none'
        raise BagError('it has no %s on %s; there are: %s' % (wanted, topic, there))
    if options.points:
        camera = cloud_camera(bag, topic)
        if camera is None:
            raise BagError('the clouds of %s are not organised (height 1), which the pipeline needs' % topic)
        return camera
    info = options.camera_info or info_beside(bag, topic)
    if bag.types.get(info) != INFO:
        raise BagError('it has no camera_info for %s%s; --camera-info names it' % (topic, ' on %s' % info if info else ' beside it'))
    camera = depth_camera(bag, topic, info)
    if camera is None:
        raise BagError('%s has no depth images: they are %s, accepted are %s' % (
            topic, raw_messages.size_and_encoding(bag.first(topic))[2], ', '.join(DEPTH_ENCODINGS)))
    return camera


def choose(bag, options):
    """The cameras that the map is made from."""
    if options.image or options.points:
        return [named(bag, options)]
    found, unfit = all_in(bag)
    best = {}
    for camera in found:
        best.setdefault(camera.name, camera)
    if not best:
        raise BagError('it has no depth images with camera_info and no organised clouds%s' % ''.join('; ' + text for text in unfit))
    if not options.camera:
        return list(best.values())
    chosen = ['/' + name.strip('/') for name in options.camera]
    for name in chosen:
        if name not in best:
            raise BagError("it has no camera '%s'; there are: %s" % (name, ', '.join(sorted(best))))
    return [best[name] for name in dict.fromkeys(chosen)]
