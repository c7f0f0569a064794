"""Ways to spoil a message, by name; where it is to be refused, with the text that says why."""
import numpy as np
import rospy
from geometry_msgs.msg import Point32, Polygon
from sensor_msgs.msg import PointField

from polygonal_perception.msg import ObstaclePolygon

LARGEST = 2 ** 32 - 1
NAN, INFINITY = float('nan'), float('inf')
# Of parameters: of wrong types and out of all ranges.
BAD_VALUES = ['', 'much', -1, 0, 10 ** 9, -1e300, 1e300, float('inf'), float('nan'), True, [], [1, 2], [0, 0, 0], {'a': {'b': 1}}]


def set_to(**values):
    """Spoils a message by other values of its fields; `header_...` are the header's."""
    def spoil(message):
        for name, value in values.items():
            if name.startswith('header_'):
                setattr(message.header, name[len('header_'):], value)
            else:
                setattr(message, name, value)
    return spoil


def within(path, **values):
    """The same for a message in the message."""
    def spoil(message):
        for name in path.split('.'):
            message = getattr(message, name)
        set_to(**values)(message)
    return spoil


def field(index, **values):
    def spoil(message):
        set_to(**values)(message.fields[index])
    return spoil


def without_field(name):
    def spoil(message):
        message.fields = [f for f in message.fields if f.name != name]
    return spoil


def cut_to(size):
    def spoil(message):
        message.data = message.data[:size]
    return spoil


def calibration(fx=100.0, fy=100.0, cx=80.0, cy=60.0, projection=True):
    """Intrinsics in P, or in K alone where `projection` is false."""
    def spoil(info):
        info.K = [fx, 0, cx, 0, fy, cy, 0, 0, 1]
        info.P = [fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0] if projection else [0.0] * 12
    return spoil


HEADERS = {
    'an_empty_frame_id': (set_to(header_frame_id=''), 'header.frame_id is empty, accepted is the name of a tf frame'),
    'a_leading_slash': (set_to(header_frame_id='/camera'), "header.frame_id is '/camera', accepted is a name without a"),
    'a_frame_id_of_a_megabyte': (set_to(header_frame_id='/' + 'x' * 2 ** 20), 'bytes left out] xxx'),
    'the_floor_s_frame_id': (set_to(header_frame_id='floor'), "header.frame_id is 'floor', which is floor_frame"),
}
# The images of the camera have 160 x 120 pixels.
CLOUDS = {
    'a_height_of_1': (set_to(height=1), 'height is 1, accepted is an organised cloud'),
    'a_height_of_0': (set_to(height=0), 'height is 0, accepted is an organised cloud'),
    'a_huge_height': (set_to(height=LARGEST), 'height is 4294967295, accepted is 2 to 65535'),
    'a_height_beyond_the_data': (set_to(height=121), 'data has 307200 bytes, accepted is height x row_step = 309760'),
    'a_width_of_0': (set_to(width=0), 'width is 0, accepted is 2 to 65535'),
    'a_width_of_1': (set_to(width=1), 'width is 1, accepted is 2 to 65535'),
    'a_huge_width': (set_to(width=65536), 'width is 65536, accepted is 2 to 65535'),
    # 65536 x 65536 is 0 in 32 bits.
    'sizes_whose_product_overflows': (set_to(width=65536, height=65536, row_step=0), 'width is 65536, accepted is'),
    # 16 x 65535 x 65535 is 68717379600, and 4292870160 in 32 bits.
    'bytes_that_overflow': (set_to(width=65535, height=65535, row_step=16 * 65535),
                            'data has 307200 bytes, accepted is height x row_step = 68717379600'),
    'a_row_step_of_0': (set_to(row_step=0), 'row_step is 0, accepted is at least width x point_step = 2560'),
    'a_row_step_too_small': (set_to(row_step=2559), 'row_step is 2559, accepted is at least width x point_step = 2560'),
    'a_huge_row_step': (set_to(row_step=LARGEST), 'accepted is height x row_step = 515396075400'),
    'a_point_step_of_0': (set_to(point_step=0), "field 'x' at offset 0 does not fit a point_step of 0"),
    'a_point_step_too_small': (set_to(point_step=11), "field 'z' at offset 8 does not fit a point_step of 11"),
    # 160 x 26843546 is 64 in 32 bits.
    'a_point_step_that_overflows': (set_to(point_step=26843546), 'accepted is at least width x point_step = 4294967360'),
    'a_huge_point_step': (set_to(point_step=LARGEST), 'accepted is at least width x point_step = 687194767200'),
    'data_too_short': (cut_to(307199), 'data has 307199 bytes, accepted is height x row_step = 307200'),
    'no_data': (cut_to(0), 'data has 0 bytes, accepted is height x row_step = 307200'),
    'an_offset_past_the_point': (field(1, offset=13), "field 'y' at offset 13 does not fit a point_step of 16"),
    # 4294967295 + 4 is 3 in 32 bits.
    'an_offset_that_overflows': (field(0, offset=LARGEST), "field 'x' at offset 4294967295 does not fit a point_step of"),
    'coordinates_that_overlap': (field(1, offset=2), "fields 'x' and 'y' overlap at offsets 0 and 2, accepted are 4 bytes each"),
    'coordinates_in_one_place': (set_to(fields=[PointField(n, 0, PointField.FLOAT32, 1) for n in 'xyz']),
                                 "fields 'x' and 'y' overlap at offsets 0 and 0"),
    'a_count_of_2': (field(2, count=2), "field 'z' has count 2, accepted is 1"),
    'a_huge_count': (field(2, count=LARGEST), "field 'z' has count 4294967295, accepted is 1"),
    'big_endian': (set_to(is_bigendian=True), 'is_bigendian is true, accepted is false'),
    'a_name_with_a_space': (field(0, name='x '), "field 'x' is missing, needed are x, y and z"),
    'a_name_in_capitals': (field(1, name='Y'), "field 'y' is missing, needed are x, y and z"),
    'the_first_of_two_x': (set_to(fields=[PointField(n, 4 * i, t, 1) for i, (n, t) in enumerate(zip('xxyz', (8, 7, 7, 7)))]),
                           "field 'x' has datatype 8, accepted is FLOAT32 (7)"),
    'no_fields': (set_to(fields=[]), "field 'x' is missing, needed are x, y and z"),
    **{'no_' + name: (without_field(name), "field '%s' is missing, needed are x, y and z" % name) for name in 'xyz'},
    **{'datatype_%d' % t: (field(0, datatype=t), "field 'x' has datatype %d, accepted is FLOAT32 (7)" % t)
       for t in (0, 1, 2, 3, 4, 5, 6, PointField.FLOAT64, 9, 255)},
}
IMAGES = {
    'a_height_of_1': (set_to(height=1), 'height is 1, accepted is 2 to 65535'),
    'a_height_of_0': (set_to(height=0), 'height is 0, accepted is 2 to 65535'),
    'a_width_of_0': (set_to(width=0), 'width is 0, accepted is 2 to 65535'),
    'a_width_of_1': (set_to(width=1), 'width is 1, accepted is 2 to 65535'),
    'a_huge_size': (set_to(width=LARGEST, height=LARGEST), 'width is 4294967295, accepted is 2 to 65535'),
    'sizes_whose_product_overflows': (set_to(width=65536, height=65536, step=0), 'width is 65536, accepted is 2 to 65535'),
    'bytes_that_overflow': (set_to(width=65535, height=65535, step=2 * 65535),
                            'data has 38400 bytes, accepted is height x step = 8589672450'),
    'a_step_of_0': (set_to(step=0), 'step is 0, accepted is at least 320'),
    'a_step_too_small': (set_to(step=319), 'step is 319, accepted is at least 320'),
    'a_huge_step': (set_to(step=LARGEST), 'data has 38400 bytes, accepted is height x step = 515396075400'),
    'data_too_short': (cut_to(38399), 'data has 38399 bytes, accepted is height x step = 38400'),
    'no_data': (cut_to(0), 'data has 0 bytes, accepted is height x step = 38400'),
    'data_of_half_the_metres': (set_to(encoding='32FC1'), 'step is 320, accepted is at least 640'),
    'big_endian': (set_to(is_bigendian=1), 'is_bigendian is true, accepted is false'),
    **{'encoding_' + (e or 'empty'): (set_to(encoding=e), "encoding is '%s', accepted are 16UC1 (in depth_unit) and 32FC1 (m)" % e)
       for e in ('', 'bgr8', '8UC1', '16SC1', '16UC3', '32FC3', '64FC1', 'mono8', '16uc1', '16UC1 ', '\x01', 'compressed; png')},
    'an_encoding_of_a_megabyte': (set_to(encoding='16UC1' * 2 ** 18), "UC116UC1', accepted are 16UC1 (in depth_unit) and 32FC1 (m)"),
}
INFOS = {
    'fx_of_0': (calibration(fx=0.0, projection=False), 'camera_info has fx, fy, cx, cy of 0, 100, 80, 60; accepted are finite'),
    'a_negative_fx': (calibration(fx=-1.0), 'camera_info has fx, fy, cx, cy of -1, 100, 80, 60'),
    'fx_of_nan': (calibration(fx=NAN), 'camera_info has fx, fy, cx, cy of nan, 100, 80, 60'),
    'an_infinite_fx': (calibration(fx=INFINITY), 'camera_info has fx, fy, cx, cy of inf, 100, 80, 60'),
    'fy_of_0': (calibration(fy=0.0), 'camera_info has fx, fy, cx, cy of 100, 0, 80, 60'),
    'fy_of_nan': (calibration(fy=NAN), 'camera_info has fx, fy, cx, cy of 100, nan, 80, 60'),
    'cx_of_nan': (calibration(cx=NAN), 'camera_info has fx, fy, cx, cy of 100, 100, nan, 60'),
    'an_infinite_cy': (calibration(cy=-INFINITY), 'camera_info has fx, fy, cx, cy of 100, 100, 80, -inf'),
    # Its rays leave the range of floats.
    'a_tiny_fx': (calibration(fx=1e-300), 'camera_info has fx, fy, cx, cy of 1e-300, 100, 80, 60; accepted are finite'),
    'fx_in_metres': (calibration(fx=0.005), 'all pixels within 89 deg of the axis'),
    'a_huge_cx': (calibration(cx=1e300), 'camera_info has fx, fy, cx, cy of 100, 100, 1e+300, 60'),
    'a_tiny_fx_in_the_projection': (lambda info: (calibration()(info), set_to(P=[1e-310, *info.P[1:]])(info)),
                                    'camera_info has fx, fy, cx, cy of 1e-310, 100, 80, 60'),
    'a_region_far_off': (lambda info: setattr(info.roi, 'x_offset', LARGEST), 'all pixels within 89 deg of the axis'),
    'another_region': (lambda info: (setattr(info.roi, 'width', 10), setattr(info.roi, 'height', 10)),
                       'camera_info is for an image of 10x10, the image has 160x120'),
    'no_calibration': (set_to(K=[0.0] * 9, P=[0.0] * 12), 'camera_info has fx, fy, cx, cy of 0, 0, 0, 0'),
    'another_size': (set_to(width=320, height=240), 'camera_info is for an image of 320x240, the image has 160x120'),
    'a_huge_size': (set_to(width=LARGEST, height=LARGEST), 'camera_info is for an image of 4294967295x4294967295, the'),
    'binning': (set_to(binning_x=2, binning_y=2), 'camera_info is for an image of 80x60, the image has 160x120'),
    'huge_binning': (set_to(binning_x=LARGEST), 'camera_info is for an image of 0x120, the image has 160x120'),
}




# The grid has 40 x 40 cells.
CELLS = {
    **{'a_resolution_of_%s' % v: (within('info', resolution=v), 'info.resolution is %s, accepted is 0.001 to 10 m' % t)
       for v, t in ((0.0, '0'), (-1.0, '-1'), (1e30, '1e+30'), (NAN, 'nan'), (INFINITY, 'inf'))},
    **{'a_slab_height_of_%s' % v: (set_to(slab_height=v), 'slab_height is %s, accepted is a finite number above 0 m' % t)
       for v, t in ((0.0, '0'), (-1.0, '-1'), (NAN, 'nan'), (INFINITY, 'inf'))},
    'another_slab_height': (set_to(slab_height=0.1), 'slab_height is 0.1 and in the map 0.07, accepted are sensors with the same'),
    'too_many_cells': (within('info', width=2001, height=2000), 'info.width x info.height is 2001 x 2000, accepted are at most 4e6 cells'),
    # 65536 x 65536 is 0 in 32 bits.
    'sizes_whose_product_overflows': (within('info', width=65536, height=65536), 'accepted are at most 4e6 cells'),
    'huge_sizes': (within('info', width=LARGEST, height=LARGEST), 'accepted are at most 4e6 cells'),
    'no_cells_but_a_huge_height': (lambda cells: (within('info', width=0, height=LARGEST)(cells), set_to(hit=b'', free=b'', floor=b'')(cells)),
                                   'info.width x info.height is 0 x 4294967295, accepted are at most 4e6 cells'),
    'sizes_beyond_the_data': (within('info', width=41), 'hit has 1600 cells, accepted is 1640, info.width times info.height'),
    **{name + '_too_short': (set_to(**{name: bytes(1599)}), name + ' has 1599 cells, accepted is 1600') for name in ('hit', 'free', 'floor')},
    **{name + '_too_long': (set_to(**{name: bytes(1601)}), name + ' has 1601 cells, accepted is 1600') for name in ('hit', 'free', 'floor')},
    **{'no_' + name: (set_to(**{name: b''}), name + ' has 0 cells, accepted is 1600') for name in ('hit', 'free', 'floor')},
    **{'a_place_of_%s' % v: (within('info.origin.position', x=v), 'info.origin is no pose: accepted is a place within 1000 km')
       for v in (1e7, 1e300, NAN, -INFINITY)},
    'no_rotation': (within('info.origin.orientation', w=0.0), 'info.origin is no pose: accepted is a place within 1000 km and a unit'),
    'a_rotation_of_nan': (within('info.origin.orientation', z=NAN), 'info.origin is no pose'),
    'a_rotation_too_long': (within('info.origin.orientation', w=2.0), 'info.origin is no pose'),
    'a_frame_nobody_knows': (set_to(header_frame_id='nowhere'), "no transform from 'nowhere' to 'odom'"),
    'a_stamp_of_0': (set_to(header_stamp=rospy.Time()), 'header.stamp is 0'),
}


def vertex(index, **values):
    """Of the first polygon's boundary, which runs from (1, -1) to the right."""
    def spoil(array):
        set_to(**values)(array.polygons[0].boundary.points[index])
    return spoil


def boundary(change):
    """Its vertices."""
    def spoil(array):
        ring = array.polygons[0].boundary
        ring.points = change(ring.points)
    return spoil


def hole(change):
    """One with the boundary's vertices."""
    def spoil(array):
        array.polygons[0].holes = [Polygon(change(array.polygons[0].boundary.points))]
    return spoil


# Of these a planner's status tells the text.
POLYGONS = {
    **{'a_vertex_at_%s' % v: (vertex(1, x=v), 'polygon 0: the boundary has a coordinate that is not finite, in vertex 1')
       for v in (NAN, INFINITY, -INFINITY)},
    'a_height_of_nan': (vertex(2, z=NAN), 'not finite, in vertex 2'),
    'a_vertex_too_far_away': (vertex(1, x=1e9), 'has a number that is not 0 or from 10^-100 to 10^8 m'),
    'two_vertices': (boundary(lambda points: points[:2]), 'polygon 0: the boundary has 2 vertices, fewer than 3'),
    'no_vertices': (boundary(lambda points: []), 'polygon 0: the boundary has 0 vertices, fewer than 3'),
    'a_clockwise_boundary': (boundary(lambda points: points[::-1]), 'ring 0, a boundary, runs clockwise'),
    'a_hole_of_two_vertices': (hole(lambda points: points[:2]), 'polygon 0: hole 0 has 2 vertices, fewer than 3'),
    'a_hole_beside_its_boundary': (hole(lambda points: [Point32(p.x + 5.0, p.y, 0.0) for p in points[::-1]]),
                                   'a hole lies outside of its boundary'),
    'a_second_polygon_of_one_vertex': (lambda array: array.polygons.append(ObstaclePolygon(Polygon(array.extent.points[:1]), [])),
                                       'polygon 1: the boundary has 1 vertices, fewer than 3'),
    'no_floor': (lambda array: (set_to(floor_status=0)(array), array.polygons.clear()), 'without a floor nobody knows what stands where'),
    'a_frame_nobody_knows': (set_to(header_frame_id='nowhere'), "no transform from 'base_link' to 'nowhere'"),
    'no_frame': (set_to(header_frame_id=''), 'header.frame_id is empty, accepted is the name of a tf frame'),
    'a_stamp_of_0': (set_to(header_stamp=rospy.Time()), 'header.stamp is 0'),
}


def padded(step):
    """Rows that begin anywhere."""
    def spoil(image):
        rows = [image.data[at:at + image.step] for at in range(0, len(image.data), image.step)]
        image.data, image.step = b''.join(row + b'\xff' * (step - len(row)) for row in rows), step
    return spoil


def all_values(value, kind):
    """A frame of one value."""
    def spoil(message):
        if kind == np.float32 and hasattr(message, 'encoding'):
            message.encoding, message.step = '32FC1', 640
            message.data = bytes(640 * 120)
        message.data = np.full(len(message.data) // np.dtype(kind).itemsize, value, kind).tobytes()
    return spoil


def random_data(message):
    message.data = np.random.RandomState(1).bytes(len(message.data))


# Strange, but as good as any.
STRANGE_HEADERS = {
    'spaces_in_the_frame_id': set_to(header_frame_id='a camera frame'),
    'a_frame_id_of_a_megabyte_without_a_slash': set_to(header_frame_id='x' * 2 ** 20),
    'the_largest_seq': set_to(header_seq=LARGEST),
}
STRANGE_CLOUDS = {
    'counts_of_0': lambda cloud: [setattr(f, 'count', 0) for f in cloud.fields],
    'a_second_x': lambda cloud: cloud.fields.append(PointField('x', 12, PointField.FLOAT64, 7)),
    'ten_thousand_fields': lambda cloud: cloud.fields.extend(PointField('f%d' % i, LARGEST, i % 256, 0) for i in range(10000)),
    'more_data_than_points': lambda cloud: setattr(cloud, 'data', cloud.data + bytes(100000)),
    'is_dense_in_spite_of_nan': set_to(is_dense=True),
}
STRANGE_IMAGES = {
    'mono16': set_to(encoding='mono16'),
    'an_odd_step': padded(321),
    'more_data_than_rows': lambda image: setattr(image, 'data', image.data + bytes(100000)),
}
STRANGE_INFOS = {
    'no_size': set_to(width=0, height=0),
    'distortion_left_over': set_to(D=[0.3, -0.2, NAN, INFINITY, 0.0], R=[0.0] * 9),
    'a_hundred_thousand_distortions': set_to(D=[0.0] * 100000),
    'another_frame': set_to(header_frame_id='another'),
    'an_older_stamp': set_to(header_stamp=rospy.Time(1)),
    'the_whole_region': lambda info: (setattr(info.roi, 'width', 160), setattr(info.roi, 'height', 120)),
}
STRANGE_CELLS = {
    'no_cells': lambda cells: (within('info', width=0, height=0)(cells), set_to(hit=b'', free=b'', floor=b'')(cells)),
    'one_row': lambda cells: within('info', width=1600, height=1)(cells),
    'hits_everywhere': set_to(hit=b'\xff' * 1600),
    'any_numbers': lambda cells: [setattr(cells, n, np.random.RandomState(1).bytes(1600)) for n in ('hit', 'free', 'floor')],
    'cells_of_a_millimetre': within('info', resolution=0.001),
    'cells_of_10_metres': within('info', resolution=10.0),
    'a_place_far_away': within('info.origin.position', x=9e5, y=-9e5),
    'a_tilted_grid': within('info.origin.orientation', x=0.6, w=0.8),
    'the_largest_seq': set_to(header_seq=LARGEST),
}
NUMBERS = (0.0, 1.0, -1.0, 1e-45, 1e-38, 1e30, -1e38, 3.4e38, INFINITY, -INFINITY, NAN)
EMPTY = {'random_data': random_data, **{'nothing_but_%g' % v: all_values(v, np.float32) for v in NUMBERS}}
EMPTY_IMAGES = {'nothing_but_%d_mm' % v: all_values(v, np.uint16) for v in (0, 1, 32767, 65535)}
