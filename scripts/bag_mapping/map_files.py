"""A map as the node has saved it: cells and polygons."""
import json

import cv2
import numpy as np
import yaml

FREE, OCCUPIED = 254, 0  # grey values of a pgm as map_server reads it


class MapFiles:
    """Read back from NAME.yaml, NAME.pgm and NAME.geojson."""

    def __init__(self, base):
        description = yaml.safe_load(base.with_name(base.name + '.yaml').read_text())
        self.resolution = description['resolution']  # [m]
        self.origin = np.array(description['origin'][:2])  # [m] of the lower left corner
        image = cv2.imread(str(base.with_name(base.name + '.pgm')), cv2.IMREAD_UNCHANGED)
        self.cells = image[::-1]  # row 0 at the origin
        features = json.loads(base.with_name(base.name + '.geojson').read_text())['features']
        # Of each polygon its rings, the boundary first.
        self.polygons = [[np.array(ring) for ring in feature['geometry']['coordinates']] for feature in features]

    @property
    def free(self):
        return self.cells == FREE

    @property
    def occupied(self):
        return self.cells == OCCUPIED

    def seen_bounds(self):
        """First and last row and column in which anything was seen; the whole map where nothing was."""
        seen = self.free | self.occupied
        if not seen.any():
            return 0, self.cells.shape[0] - 1, 0, self.cells.shape[1] - 1
        rows, columns = np.flatnonzero(seen.any(1)), np.flatnonzero(seen.any(0))
        return rows[0], rows[-1], columns[0], columns[-1]

    def text(self):
        square = self.resolution ** 2
        bottom, top, left, right = self.seen_bounds()
        return '%d polygons; %.1f x %.1f m were seen: %.1f m2 free, %.1f m2 occupied; the map has %.0f x %.0f m, cells of %.3g m' % (
            len(self.polygons), (right - left + 1) * self.resolution, (top - bottom + 1) * self.resolution,
            np.count_nonzero(self.free) * square, np.count_nonzero(self.occupied) * square,
            self.cells.shape[1] * self.resolution, self.cells.shape[0] * self.resolution, self.resolution)
