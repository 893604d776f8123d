"""A yardstick for arms in space, in NumPy alone: constant curvature behind dead time and lag, and a linear step of
what it misses. Rotations are matrices [n x 3 x 3]; a gap is (d, omega), as docs/model.md has it."""

import numpy as np


def matrices(q):
    """Rotations [n x 3 x 3] of quaternions x, y, z, w [n x 4]."""
    x, y, z, w = q.T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                     2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                     2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=-1).reshape(-1, 3, 3)


class Episode:
    """What an imported recording holds: pressures or set points behind a lag, and gaps' coordinates."""

    def __init__(self, group):
        self.asked = group["setpoint_kpa"][()]
        poses = group["backbone"][()]
        valid = np.all(np.isfinite(poses.reshape(len(poses), -1)), axis=1)
        self.valid = valid if "tracked" not in group else valid & group["tracked"][()].astype(bool)
        self.poses = poses

    def gaps(self):
        """(d, omega) of every gap [n x gaps x 6]."""
        found = []
        for i in range(1, self.poses.shape[1]):
            r0, r1 = matrices(self.poses[:, i - 1, 3:]), matrices(self.poses[:, i, 3:])
            d = np.einsum("nji,nj->ni", r0, self.poses[:, i, :3] - self.poses[:, i - 1, :3])
            found.append(np.hstack([d, logarithm(np.einsum("nji,njk->nik", r0, r1))]))
        return np.stack(found, axis=1)


def logarithm(r):
    """Rotation vectors [n x 3]."""
    cosine = ((np.trace(r, axis1=1, axis2=2) - 1.0) / 2.0).clip(-1.0, 1.0)
    angle = np.arccos(cosine)
    axis = np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1)
    return axis * (0.5 / np.sinc(angle / np.pi))[:, None]


def exponential(omega):
    """Rotations, and the matrices that turn a length along x into a chord."""
    angle = np.linalg.norm(omega, axis=1)[:, None, None]
    k = np.zeros((len(omega), 3, 3))
    k[:, 2, 1], k[:, 0, 2], k[:, 1, 0] = omega.T
    k = k - np.swapaxes(k, 1, 2)
    safe = np.maximum(angle, 1e-6)
    a, b = (1 - np.cos(safe)) / safe**2, (safe - np.sin(safe)) / safe**3
    return np.eye(3) + np.sinc(angle / np.pi) * k + a * k @ k, np.eye(3) + a * k + b * k @ k


def places(gaps):
    """Plates [n x gaps x 3] of gaps' coordinates."""
    rotation, place, found = np.tile(np.eye(3), (len(gaps), 1, 1)), np.zeros((len(gaps), 3)), []
    for i in range(gaps.shape[1]):
        place = place + np.einsum("nij,nj->ni", rotation, gaps[:, i, :3])
        rotation = rotation @ exponential(gaps[:, i, 3:])[0]
        found.append(place)
    return np.stack(found, axis=1)


class ResidualModel:
    """Constant curvature behind dead time and lag, and a linear step of what it misses."""

    def __init__(self, episodes, rate_hz):
        self.rate_hz = rate_hz
        tries = [(self.fit_shapes(episodes, dead, share), dead, share)
                 for dead in range(0, 1 + round(0.4 * rate_hz)) for share in (0.15, 0.3, 0.5, 0.75, 1.0)]
        (_, self.shapes), self.dead, self.share = min(tries, key=lambda found: found[0][0])
        steps, answers = [], []
        for episode in episodes:
            residual, lagged = self.residual(episode)
            both = episode.valid[1:] & episode.valid[:-1]
            steps.append(self.terms(residual[:-1], lagged[1:], lagged[:-1])[both])
            answers.append(residual[1:][both])
        steps, answers = np.vstack(steps), np.vstack(answers)
        self.step = np.linalg.solve(steps.T @ steps + 1e-3 * np.eye(steps.shape[1]), steps.T @ answers)

    @staticmethod
    def terms(residual, now, before):
        return np.hstack([residual, now / 100.0, (now - before) / 10.0, np.ones((len(now), 1))])

    def lagged(self, asked, dead, share):
        late = np.vstack([np.repeat(asked[:1], dead, axis=0), asked])[:len(asked)]
        for t in range(1, len(late)):
            late[t] = late[t - 1] + share * (late[t] - late[t - 1])
        return late

    def fit_shapes(self, episodes, dead, share):
        terms, answers = [], []
        for episode in episodes:
            lagged = self.lagged(episode.asked, dead, share)[episode.valid]
            terms.append(np.hstack([lagged / 100.0, np.ones((len(lagged), 1))]))
            gaps = episode.gaps()[episode.valid]
            length = np.linalg.norm(gaps[:, :, :3], axis=2, keepdims=True)
            answers.append(np.concatenate([gaps[:, :, 4:], length], axis=2).reshape(len(gaps), -1))
        terms, answers = np.vstack(terms), np.vstack(answers)
        found = np.linalg.lstsq(terms, answers, rcond=None)[0]
        return np.square(terms @ found - answers).mean(), found

    def simple(self, lagged):
        """Gaps' coordinates [n x gaps x 6]."""
        shape = (np.hstack([lagged / 100.0, np.ones((len(lagged), 1))]) @ self.shapes).reshape(len(lagged), -1, 3)
        gaps = np.zeros((*shape.shape[:2], 6))
        gaps[:, :, 4:] = shape[:, :, :2]
        for i in range(shape.shape[1]):
            chord = exponential(gaps[:, i, 3:])[1][:, :, 0]
            gaps[:, i, :3] = chord * (shape[:, i, 2] / np.linalg.norm(chord, axis=1))[:, None]
        return gaps

    def residual(self, episode):
        lagged = self.lagged(episode.asked, self.dead, self.share)
        return (episode.gaps() - self.simple(lagged)).reshape(len(lagged), -1), lagged

    def errors_mm(self, episodes, frames=32):
        """Mean over plates and at the tip, over windows of so many frames that are never corrected."""
        plates, tips = [], []
        for episode in episodes:
            residual, lagged = self.residual(episode)
            simple = self.simple(lagged)
            for first in range(0, len(lagged) - frames - 1, frames):
                if not episode.valid[first]:
                    continue
                now, predicted = residual[first:first + 1], []
                for t in range(first + 1, first + 1 + frames):
                    now = self.terms(now, lagged[t:t + 1], lagged[t - 1:t]) @ self.step
                    predicted.append(now.reshape(-1, 6))
                span = slice(first + 1, first + 1 + frames)
                apart = places(simple[span] + np.array(predicted)) - episode.poses[span, 1:, :3]
                apart = 1e3 * np.linalg.norm(apart, axis=2)[episode.valid[span]]
                plates += apart.mean(axis=1).tolist()
                tips += apart[:, -1].tolist()
        return float(np.mean(plates)), float(np.mean(tips))
