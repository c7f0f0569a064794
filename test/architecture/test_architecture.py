#!/usr/bin/env python3
"""Who may know whom, which namespace is whose, and what the libraries show to the outside.

    test_architecture.py [--libraries FOLDER] [--results FILE]

FOLDER has the built libraries; without it only the sources are looked at. FILE gets the results in JUnit's form.
"""
import collections
import pathlib
import re
import sys
import unittest

import cpp_source
import junit
import libraries

Room = collections.namedtuple('Room', 'folder namespace foreign knows')

# A room is a folder below src/ and include/polygonal_perception/, or one beside them. It knows itself, and what its line
# says; to know perception is to know the rooms in it, too. `foreign` begins the names of the headers that it may take
# from others, apart from the standard library's; ANY are ROS's, too.
ANY = ['']
BASE = ['geometry', 'parameters']
MEASURED = BASE + ['occupancy', 'mapping', 'perception', 'planning', 'cameras/simulation', 'reference']
ROOMS = [
    Room('geometry', 'geometry', ['Eigen/'], []),
    Room('parameters', 'parameters', [], []),
    Room('occupancy/grid', 'occupancy', ['Eigen/'], BASE),
    Room('occupancy/polygons', 'occupancy', ['Eigen/'], BASE + ['occupancy/grid']),
    Room('perception/input', 'perception', ['Eigen/'], BASE),
    Room('perception/planes', 'perception', ['Eigen/'], BASE + ['perception/input']),
    Room('perception/floor', 'perception', ['Eigen/'], BASE + ['perception/input', 'perception/planes']),
    Room('perception/grid', 'perception', ['Eigen/'], BASE + ['occupancy', 'perception/input']),
    Room('perception/scan', 'perception', ['Eigen/'], BASE + ['occupancy', 'perception/input', 'perception/grid']),
    Room('perception/segmentation', 'perception', ['Eigen/'],
         BASE + ['occupancy'] + ['perception/' + room for room in ('input', 'planes', 'floor')]),
    Room('perception', 'perception', ['Eigen/'], BASE + ['occupancy', 'perception']),
    Room('mapping', 'mapping', ['Eigen/', 'nlohmann/'], BASE + ['occupancy']),
    Room('planning', 'planning', ['Eigen/'], BASE),
    Room('ros/common', 'ros_common', ANY, BASE + ['occupancy']),
    Room('ros/perception', 'ros_perception', ANY, BASE + ['ros/common', 'occupancy', 'perception']),
    Room('ros/mapping', 'ros_mapping', ANY, BASE + ['ros/common', 'occupancy', 'mapping']),
    Room('ros/planning', 'ros_planning', ANY, BASE + ['ros/common', 'planning']),
    Room('ros/driving', 'ros_driving', ANY, BASE + ['ros/common', 'planning']),
    Room('plugins', 'plugins', ANY, BASE + ['ros/common', 'ros/planning', 'planning']),
    Room('cameras/simulation', 'simulation', ['Eigen/', 'embree3/', 'embree4/'], BASE + ['planning']),
    Room('cameras/simulation_ros', 'simulation_ros', ANY, BASE + ['ros/common', 'planning', 'cameras/simulation']),
    Room('cameras/openni2', 'openni2', ['OpenNI.h'], BASE),
    Room('cameras/openni2_ros', 'openni2_ros', ANY, BASE + ['ros/common', 'cameras/openni2']),
    Room('rviz', 'displays', ANY, ['geometry', 'ros/common']),
    Room('reference', 'reference', ANY, MEASURED),
    Room('evaluation', 'evaluation', ANY, MEASURED),
    Room('benchmark', 'benchmarks', ANY, MEASURED),
]
BESIDE_SRC = ['reference', 'evaluation', 'benchmark']
# The samples of the floor detector are drawn on a picture.
OPENCV_IN = ['src/ros/perception/samples_image.cpp']

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PUBLIC = 'include/polygonal_perception/'
STANDARD = re.compile(r'[a-z_0-9]+|(unistd|fcntl|poll|signal|sys/\w+)\.h')  # and POSIX
OPENCV = re.compile(r'opencv|cv_bridge/')
PCL = re.compile(r'pcl(_conversions|_ros)?/')
FOLDERS = {room.folder: room for room in ROOMS}


def room_of(path):
    """The room of a file of the project, None where it is in none; test/ is none."""
    for root in (PUBLIC, 'src/', ''):
        if path.startswith(root):
            folder = path[len(root):].rpartition('/')[0]
            while folder not in FOLDERS and folder:
                folder = folder.rpartition('/')[0]
            room = FOLDERS.get(folder)
            return room if room is None or bool(root) != (folder in BESIDE_SRC) else None
    return None


def may_know(room, other):
    return room == other or any((other.folder + '/').startswith(known + '/') for known in room.knows)


def read(*folders):
    """The C++ files below these folders."""
    files = (file for folder in folders for file in sorted((SOURCE / folder).rglob('*')))
    return [cpp_source.CppSource(str(file.relative_to(SOURCE)), file.read_text()) for file in files
            if file.suffix in ('.hpp', '.h', '.cpp', '.inc')]


def find(source, name):
    """The file of the project that a source includes by this name, or None."""
    folders = [pathlib.Path(source.path).parent, *map(pathlib.Path, ('include', 'src', '', 'test'))]
    return next((str(folder / name) for folder in folders if (SOURCE / folder / name).is_file()), None)


class ArchitectureTest(unittest.TestCase):
    libraries = None  # the folder, see above

    @classmethod
    def setUpClass(cls):
        cls.package = read('include', 'src')
        cls.measuring = read(*BESIDE_SRC)
        cls.tests = read('test', 'doc')
        assert cls.package and cls.measuring and cls.tests

    def none_of(self, problems):
        problems = list(problems)
        if problems:
            self.fail('\n'.join(problems))

    def test_each_file_is_in_a_room(self):
        self.none_of('%s is in no room: test_architecture.py has none of this folder' % source.path
                     for source in self.package + self.measuring
                     if room_of(source.path) is None and source.path != PUBLIC + 'export.hpp')

    def test_arrows(self):
        def problems():
            for source in self.package + self.measuring:
                room = room_of(source.path)
                for name in source.includes:
                    found = find(source, name)
                    if room is None or found is None or found == PUBLIC + 'export.hpp':
                        continue
                    other = room_of(found)
                    if other is None or not may_know(room, other):
                        yield '%s includes %s: %s may not know %s' % (
                            source.path, name, room.folder, other.folder if other else found.partition('/')[0])
        self.none_of(problems())

    def test_no_include_climbs(self):
        self.none_of('%s includes %s: begin at the project or at the room' % (source.path, name)
                     for source in self.package + self.measuring + self.tests for name in source.includes
                     if '..' in pathlib.PurePath(name).parts)

    def test_foreign_headers(self):
        def problems():
            for source in self.package:
                room = room_of(source.path)
                for name in source.includes:
                    if room is None or find(source, name) or STANDARD.fullmatch(name):
                        continue
                    if not name.startswith(tuple(room.foreign)):
                        yield '%s includes %s: beside the standard library %s knows %s' % (
                            source.path, name, room.folder, ' and '.join(room.foreign) or 'nothing')
        self.none_of(problems())

    def test_opencv_and_pcl_stay_outside(self):
        def problems():
            for source in self.package:
                for name in source.includes:
                    if OPENCV.match(name) and source.path not in OPENCV_IN:
                        yield '%s includes %s: OpenCV is for %s only' % (source.path, name, ', '.join(OPENCV_IN))
                    if PCL.match(name):
                        yield '%s includes %s: PCL is for benchmark, evaluation and test' % (source.path, name)
        self.none_of(problems())

    def test_namespaces(self):
        def problems():
            for source in self.package + self.measuring:
                room = room_of(source.path)
                if room is None:
                    continue
                expected = 'polygonal_perception::' + room.namespace
                for name in sorted(source.namespaces):
                    if name == 'polygonal_perception' or name.startswith('polygonal_perception::'):
                        if not (name + '::').startswith(expected + '::'):
                            yield '%s has the namespace %s, its room has %s' % (source.path, name, expected)
                for what in source.outside_namespaces:
                    yield '%s defines `%s` in no namespace, its room has %s' % (source.path, what, expected)
        self.none_of(problems())

    def test_each_type_has_a_name_of_its_own(self):
        places = collections.defaultdict(set)
        for source in self.package:
            for name in source.types:
                places[name].add(source.path)
        self.none_of('%s is in %s' % (name, ' and in '.join(sorted(files))) for name, files in sorted(places.items())
                     if len(files) > 1)

    def test_only_public_headers_export(self):
        exporting = {source.path for source in self.package if source.exported}
        private = {path for path in exporting if not path.startswith(PUBLIC)}
        self.none_of(['%s exports %s: only public headers do' % (source.path, ', '.join(sorted(source.exported)))
                      for source in self.package if source.path in private])

    def test_libraries_show_what_public_headers_export(self):
        self.need_libraries()
        exported = set()
        for source in self.package:
            exported |= source.exported
        self.none_of('%s shows %s, which no public header exports' % (library, name)
                     for library, symbols in sorted(self.symbols.items())
                     for name in sorted({symbol.name for symbol in symbols})
                     if not any((name + '::').startswith(known + '::') for known in exported))

    def test_each_symbol_is_in_one_library(self):
        self.need_libraries()
        places = collections.defaultdict(set)
        for library, symbols in self.symbols.items():
            for symbol in symbols:
                if symbol.is_strong:
                    places[symbol.text].add(library)
        self.none_of('%s is defined by %s' % (text, ' and '.join(sorted(found))) for text, found in sorted(places.items())
                     if len(found) > 1)

    def need_libraries(self):
        files = sorted(pathlib.Path(self.libraries).glob('libpolygonal_perception_*.so')) if self.libraries else []
        if not files:
            self.skipTest('no libraries of ours' + (' in ' + self.libraries if self.libraries else ''))
        self.symbols = {file.name: libraries.symbols(file) for file in files}
        self.assertTrue(any(self.symbols.values()), 'nm shows no symbol of ours')


if __name__ == '__main__':
    options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
    if not set(options) <= {'--libraries', '--results'} or len(sys.argv) % 2 == 0:
        sys.exit(__doc__)
    ArchitectureTest.libraries = options.get('--libraries')
    sys.exit(junit.run(ArchitectureTest, options.get('--results')))
