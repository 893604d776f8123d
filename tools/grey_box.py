"""What an owner without a network would fit to an arm in a plane: a yardstick (stand_in_figures.py)."""

import math

import numpy as np


class GreyBox:
    """Gain, offset, lag and length of each segment: its turn relaxes toward gain * pressure + offset."""

    SHARES = np.linspace(0.02, 1.0, 50)  # of what is left, in a frame

    def __init__(self, episodes, gaps):
        self.gaps = gaps  # of a segment
        self.segments = []
        for i in range(episodes[0].pressure_kpa.shape[1]):
            fits = [self.fit(episodes, i, share) for share in self.SHARES]
            best = int(np.argmin([error for error, _ in fits]))
            steps = [np.diff(e.backbone[:, self.gaps * i:self.gaps * (i + 1) + 1, :2], axis=1) for e in episodes]
            length = np.mean([np.hypot(s[..., 0], s[..., 1]).mean() for s in steps])
            self.segments.append((self.SHARES[best], *fits[best][1], length))

    def turns(self, episode, i):
        return episode.backbone[:, self.gaps * (i + 1), 2] - episode.backbone[:, self.gaps * i, 2]

    def fit(self, episodes, i, share):
        """Error, and gain and offset: for a given share they are linear."""
        terms, answers = [], []
        for episode in episodes:
            turn = self.turns(episode, i)
            lagged = np.zeros((len(turn), 2))
            for t in range(1, len(turn)):
                lagged[t] = lagged[t - 1] + share * (np.array([episode.pressure_kpa[t, i], 1.0]) - lagged[t - 1])
            terms.append(lagged)
            answers.append(turn - turn[0] * (1.0 - share) ** np.arange(len(turn)))
        terms, answers = np.vstack(terms), np.concatenate(answers)
        found = np.linalg.lstsq(terms, answers, rcond=None)[0]
        return np.abs(terms @ found - answers).mean(), found

    def tips(self, episode, first, count):
        """Of so many frames after the first, from its shape."""
        turn = np.array([self.turns(episode, i)[first] for i in range(len(self.segments))])
        places = []
        for t in range(first + 1, first + 1 + count):
            place, heading = np.zeros(2), 0.0
            for i, (share, gain, offset, length) in enumerate(self.segments):
                turn[i] += share * (gain * episode.pressure_kpa[t, i] + offset - turn[i])
                for _ in range(self.gaps):
                    half = heading + turn[i] / self.gaps / 2.0
                    place = place + length * np.array([math.cos(half), math.sin(half)])
                    heading += turn[i] / self.gaps
            places.append(place)
        return np.array(places)

    def errors_cm(self, episodes):
        """Mean error of the tip over one step, 32 frames and whole episodes."""
        found = {}
        for name, frames in zip(("one_step", "window_32", "open_loop"), (1, 32, None), strict=True):
            errors = []
            for episode in episodes:
                last = len(episode.time_s) - 1
                for first in range(0, last, frames or last):
                    count = min(frames or last, last - first)
                    apart = (self.tips(episode, first, count) -
                             episode.backbone[first + 1:first + 1 + count, -1, :2])
                    errors += np.hypot(*apart.T).tolist()
            found[name] = {"position_error_cm": {"mean": 100.0 * float(np.mean(errors))}}
        return found
