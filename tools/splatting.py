"""Draws particles as small spheres into an image, with numpy alone: no OpenGL and no screen are needed.

Everything is given in the picture's own frame: x to the right and y upwards in pixels, depth towards the viewer.
"""

import numpy as np

SHADE = np.array([0.50, 0.53, 0.57], np.float32)


class Canvas:
    """An image that keeps, in each pixel, the nearest sphere, its depth and its normal."""

    def __init__(self, width, height):
        self.shape = (height, width)
        self.depth = np.full(height * width, -np.inf, np.float32)
        self.colour = np.ones((height * width, 3), np.float32)
        self.normal = np.zeros((height * width, 2), np.float32)

    def spheres(self, x, y, depth, radius, colour):
        """Adds spheres: centre (x, y), `radius` in pixels, colours (n, 3); depth in pixels as well, so that spheres
        cut each other where they should. Within one call radii may differ by perspective, not in kind."""
        height, width = self.shape
        inside = (x > -radius) & (x < width + radius) & (y > -radius) & (y < height + radius)
        inside &= self._may_be_seen(x, y, depth, radius)
        if not inside.any():
            return
        x, y, depth, radius = (values[inside].astype(np.float32) for values in (x, y, depth, radius))
        colour = np.asarray(colour, np.float32)[inside]
        order = np.argsort(depth)  # where two meet in a pixel the last one written, the nearest, stays
        x, y, depth, radius, colour = x[order], y[order], depth[order], radius[order], colour[order]

        column, row = np.floor(x).astype(np.int32), np.floor(height - y).astype(np.int32)
        off_x, off_y = column + 0.5 - x, (height - y) - (row + 0.5)
        reach = int(np.ceil(radius.max()))
        owner = np.full(height * width, -1, np.int32)
        for i in range(-reach, reach + 1):
            for j in range(-reach, reach + 1):
                dx, dy = off_x + i, off_y - j
                bulge = radius**2 - dx**2 - dy**2
                at_column, at_row = column + i, row + j
                use = np.flatnonzero((bulge > 0) & (at_column >= 0) & (at_column < width) & (at_row >= 0)
                                     & (at_row < height))
                pixel = at_row[use] * width + at_column[use]
                front = depth[use] + np.sqrt(bulge[use])
                nearer = front > self.depth[pixel]
                pixel, use = pixel[nearer], use[nearer]
                self.depth[pixel] = front[nearer]
                owner[pixel] = use
        drawn = np.flatnonzero(owner >= 0)
        who = owner[drawn]
        self.colour[drawn] = colour[who]
        self.normal[drawn, 0] = (drawn % width + 0.5 - x[who]) / radius[who]
        self.normal[drawn, 1] = (height - (drawn // width + 0.5) - y[who]) / radius[who]

    def _may_be_seen(self, x, y, depth, radius):
        """False for particles deep inside a dense body: more than three diameters behind the nearest particle in
        their own and in all neighbouring squares of one diameter."""
        size = 2 * float(np.median(radius)) if len(radius) else 1.0
        a = ((x - x.min()) / size).astype(int) + 1 if len(x) else x
        b = ((y - y.min()) / size).astype(int) + 1 if len(y) else y
        if not len(x) or (a.max() + 2) * (b.max() + 2) > 20_000_000:
            return np.ones(len(x), bool)
        front = np.full((a.max() + 2, b.max() + 2), -np.inf)
        order = np.argsort(depth)
        front[a[order], b[order]] = depth[order]
        least = np.minimum.reduce([np.roll(front, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)])
        return depth > least[a, b] - 3 * size

    def image(self, depth_cue=0.0, front=0.0, sphere=1.0, surface=0.0, occlusion=0.0, size=10.0):
        """The shaded picture (height, width, 4). `sphere` and `surface` say how strongly the form of the single
        particle and of the whole body is lit, `occlusion` how dark hollows are, `depth_cue` how much of its colour what
        is further back loses to a shade of grey (per pixel of depth behind `front`); `size` is the diameter of
        a particle in pixels."""
        height, width = self.shape
        covered = np.isfinite(self.depth).reshape(height, width)
        picture = np.ones((height, width, 4), np.float32)
        picture[..., 3] = covered
        if not covered.any():
            return picture
        depth = np.where(covered, self.depth.reshape(height, width), 0.0)
        nx, ny = (self.normal[:, k].reshape(height, width) * sphere for k in (0, 1))
        light, steep = np.ones((height, width), np.float32), 1.0
        if surface > 0:
            smooth = blurred(depth, covered, 0.9 * size)
            slope_y, slope_x = np.gradient(smooth)
            steep = np.sqrt(1 + slope_x**2 + slope_y**2)
            nx, ny = nx - surface * slope_x / steep, ny + surface * slope_y / steep
        nz = np.sqrt(np.clip(1 - nx**2 - ny**2, 0.05, 1))
        length = np.sqrt(nx**2 + ny**2 + nz**2)
        toward = np.array([-0.42, 0.62, 0.66]) / np.linalg.norm([-0.42, 0.62, 0.66])
        lit = (nx * toward[0] + ny * toward[1] + nz * toward[2]) / length
        light *= 0.6 + 0.56 * np.clip(lit, 0, 1) if sphere + surface > 0 else 1
        if occlusion > 0:
            for reach, share in ((1.5 * size, 0.45), (5 * size, 0.55)):
                hollow = np.clip((blurred(depth, covered, reach) - depth) / (0.8 * reach), 0, 1)
                light *= 1 - occlusion * share * hollow / np.sqrt(steep)  # grazing faces only look hollow
        colour = self.colour.reshape(height, width, 3) * light[..., None]
        if depth_cue > 0:
            fog = np.clip((front - depth) * depth_cue, 0, 0.85)[..., None]
            colour = colour * (1 - fog) + fog * SHADE
        picture[..., :3] = np.where(covered[..., None], np.clip(colour, 0, 1), 1)
        return picture


def blurred(values, mask, reach):
    """The mean of `values` over where `mask` holds, in a window of about `reach` pixels each way."""
    def box(array, r):
        for axis in (0, 1):
            padded = np.pad(array, [(r + 1, r) if k == axis else (0, 0) for k in (0, 1)], mode="edge")
            total = padded.cumsum(axis=axis, dtype=np.float64)
            ahead, behind = (total[2 * r + 1:], total[: -2 * r - 1]) if axis == 0 else \
                (total[:, 2 * r + 1:], total[:, : -2 * r - 1])
            array = (ahead - behind) / (2 * r + 1)
        return array

    r = max(1, int(reach / 2))
    weight = box(box(mask.astype(np.float64), r), r)
    return np.where(mask, box(box(np.where(mask, values, 0.0), r), r) / np.maximum(weight, 1e-9), 0.0)


def halved(picture):
    """Half the size, each pixel the mean of four: smooth edges."""
    height, width = picture.shape[0] // 2 * 2, picture.shape[1] // 2 * 2
    p = picture[:height, :width].astype(np.float64)
    alpha = p[..., 3:]
    p = np.concatenate([p[..., :3] * alpha, alpha], axis=2)
    p = (p[::2, ::2] + p[1::2, ::2] + p[::2, 1::2] + p[1::2, 1::2]) / 4
    p[..., :3] /= np.maximum(p[..., 3:], 1e-6)
    return np.clip(p, 0, 1)
