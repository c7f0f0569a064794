"""A picture of a map: what was seen free, what stands, the polygons, and the robot's way."""
import cv2
import numpy as np

# Blue, green, red.
UNSEEN, FREE, OCCUPIED = (214, 211, 208), (255, 255, 255), (70, 60, 50)
POLYGON, TRACK, START, END, INK = (40, 60, 220), (200, 120, 20), (60, 160, 40), (200, 120, 20), (60, 55, 50)
LONGEST, MOST_PIXELS_A_CELL = 1400, 16  # [px] of the longer side, of a cell
MARGIN = 0.5  # [m] around what was seen
LEGEND = 64  # [px] below the map
SHIFT = 4  # bits of a pixel's fractions, for cv2
FONT = cv2.FONT_HERSHEY_SIMPLEX


class Canvas:
    """Pixels over a part of the map's frame, y up."""

    def __init__(self, files, low, high):
        self.scale = min(LONGEST / max(high - low), MOST_PIXELS_A_CELL / files.resolution)  # [px/m]
        self.low, self.size = low, np.maximum(np.ceil((high - low) * self.scale), 1).astype(int)
        self.image = self._cells(files)

    def _cells(self, files):
        x = self.low[0] + (np.arange(self.size[0]) + 0.5) / self.scale
        y = self.low[1] + (self.size[1] - np.arange(self.size[1]) - 0.5) / self.scale
        column = np.floor((x - files.origin[0]) / files.resolution).astype(int)
        row = np.floor((y - files.origin[1]) / files.resolution).astype(int)
        coloured = np.full(files.cells.shape + (3,), UNSEEN, np.uint8)
        coloured[files.free], coloured[files.occupied] = FREE, OCCUPIED
        # A cell around it for what lies beyond the map.
        padded = np.pad(coloured, ((1, 1), (1, 1), (0, 0)), 'edge')
        padded[[0, -1]], padded[:, [0, -1]] = UNSEEN, UNSEEN
        return np.ascontiguousarray(padded[np.clip(row + 1, 0, padded.shape[0] - 1)][:, np.clip(column + 1, 0, padded.shape[1] - 1)])

    def pixels(self, points):
        """In cv2's fractions."""
        p = (np.asarray(points, float) - self.low) * self.scale
        p[:, 1] = self.size[1] - p[:, 1]
        return np.rint((p - 0.5) * 2 ** SHIFT).astype(np.int32)

    def fill(self, rings, colour, strength):
        over = self.image.copy()
        cv2.fillPoly(over, [self.pixels(ring) for ring in rings], colour, cv2.LINE_AA, SHIFT)
        cv2.addWeighted(over, strength, self.image, 1.0 - strength, 0.0, self.image)

    def line(self, points, closed, colour, width):
        cv2.polylines(self.image, [self.pixels(points)], closed, colour, width, cv2.LINE_AA, SHIFT)

    def dot(self, point, colour):
        (centre,) = self.pixels([point])
        cv2.circle(self.image, tuple(int(v) for v in centre), 7 << SHIFT, FREE, -1, cv2.LINE_AA, SHIFT)
        cv2.circle(self.image, tuple(int(v) for v in centre), 5 << SHIFT, colour, -1, cv2.LINE_AA, SHIFT)


def bounds(files, track):
    bottom, top, left, right = files.seen_bounds()
    corners = [files.origin + files.resolution * np.array([left, bottom]), files.origin + files.resolution * np.array([right + 1, top + 1])]
    corners += [ring for polygon in files.polygons for ring in polygon] + ([np.array(track)] if track else [])
    points = np.vstack(corners)
    return points.min(0) - MARGIN, points.max(0) + MARGIN


def round_length(longest):
    """[m] 1, 2 or 5 times a power of ten, and no longer."""
    power = 10.0 ** np.floor(np.log10(longest))
    return max(k * power for k in (1, 2, 5) if k * power <= longest)


def legend(canvas, width):
    """A scale bar, and what the colours mean."""
    strip = np.full((LEGEND, width, 3), 255, np.uint8)
    strip[0] = UNSEEN
    length = round_length(min(width / 4.0, 300.0) / canvas.scale)
    pixels = int(round(length * canvas.scale))
    left, y = 20, 42
    for x0, x1, y0, y1 in ((left, left + pixels, y, y), (left, left, y - 6, y + 6), (left + pixels, left + pixels, y - 6, y + 6)):
        cv2.line(strip, (x0, y0), (x1, y1), INK, 2)
    cv2.putText(strip, '%g m' % length, (left, y - 14), FONT, 0.55, INK, 1, cv2.LINE_AA)
    x = left + pixels + 40
    for text, colour, kind in (('seen free', FREE, 'cell'), ('occupied', OCCUPIED, 'cell'), ('not seen', UNSEEN, 'cell'),
                               ('polygons', POLYGON, 'line'), ('track', TRACK, 'line'), ('start', START, 'dot')):
        if kind == 'cell':
            cv2.rectangle(strip, (x, y - 16), (x + 18, y + 2), colour, -1)
            cv2.rectangle(strip, (x, y - 16), (x + 18, y + 2), INK, 1)
        elif kind == 'line':
            cv2.line(strip, (x, y - 7), (x + 18, y - 7), colour, 2, cv2.LINE_AA)
        else:
            cv2.circle(strip, (x + 9, y - 7), 5, colour, -1, cv2.LINE_AA)
        cv2.putText(strip, text, (x + 25, y), FONT, 0.5, INK, 1, cv2.LINE_AA)
        x += 25 + cv2.getTextSize(text, FONT, 0.5, 1)[0][0] + 24
    return strip, x


def draw(files, track, path):
    canvas = Canvas(files, *bounds(files, track))
    for rings in files.polygons:
        canvas.fill(rings, POLYGON, 0.12)
    for rings in files.polygons:
        for ring in rings:
            canvas.line(ring, True, POLYGON, 2)
    if track:
        canvas.line(track, False, TRACK, 2)
        canvas.dot(track[0], START)
        canvas.dot(track[-1], END)
    _, needed = legend(canvas, int(canvas.size[0]))
    width = max(needed, int(canvas.size[0]))
    strip, _ = legend(canvas, width)
    side = width - int(canvas.size[0])
    image = cv2.copyMakeBorder(canvas.image, 0, 0, side // 2, side - side // 2, cv2.BORDER_CONSTANT, value=UNSEEN)
    if not cv2.imwrite(str(path), np.vstack([image, strip])):
        raise OSError('%s cannot be written' % path)
