"""Messages as bytes: what is in a bag goes to the nodes as it is. Only the beginning of each is looked at."""
import struct

import genpy
from tf2_msgs.msg import TFMessage

SECOND = 10 ** 9  # [ns]


def stamp_of(data):
    """[ns] of a message that begins with a header."""
    _, seconds, nanoseconds = struct.unpack_from('<III', data)
    return seconds * SECOND + nanoseconds


def text_at(data, offset):
    """A string, and where it ends."""
    (length,) = struct.unpack_from('<I', data, offset)
    begin = offset + 4
    return bytes(data[begin:begin + length]).decode('utf-8', 'replace'), begin + length


def frame_of(data):
    return text_at(data, 12)[0]


def size_and_encoding(image):
    """Width, height and encoding of a sensor_msgs/Image."""
    _, at = text_at(image, 12)
    height, width = struct.unpack_from('<II', image, at)
    return width, height, text_at(image, at + 8)[0]


def cloud_size(cloud):
    """Width and height of a sensor_msgs/PointCloud2."""
    _, at = text_at(cloud, 12)
    height, width = struct.unpack_from('<II', cloud, at)
    return width, height


def floor_status_of(polygons):
    """Of a PolygonArray."""
    return polygons[text_at(polygons, 12)[1]]


def with_stamp_of(info, image):
    """A camera_info as if it had come with the image."""
    return info[:4] + image[4:12] + info[12:]


def transforms_in(data):
    return TFMessage().deserialize(data).transforms


def raw_type(name, md5sum, definition):
    """A message class whose content is bytes, for rospy.Publisher."""
    class Raw(genpy.Message):
        __slots__ = ['data']
        _slot_types = ['uint8[]']
        _type, _md5sum, _full_text, _has_header = name, md5sum, definition, False

        def serialize(self, buff):
            buff.write(self.data)
    return Raw
