"""From what devices speak to what limber speaks, and back. limber's pressures are kPa above the ambient pressure (gauge) and
signed: positive is the segment's right side, negative its left. A device counts in its own unit, often absolute, often in
raw steps, and has a channel for each side."""

KPA_PER = {"kPa": 1.0, "Pa": 1e-3, "hPa": 0.1, "mbar": 0.1, "bar": 100.0, "MPa": 1e3, "psi": 6.894757293168361,
           "atm": 101.325}
AMBIENT_KPA = 101.325  # at sea level; measure yours with the arm vented


class Unit:
    """A unit of pressure, gauge or absolute."""

    def __init__(self, name, absolute=False, ambient_kpa=AMBIENT_KPA):
        if name not in KPA_PER:
            raise ValueError(f"unit '{name}' is unknown; known: {', '.join(KPA_PER)}")
        self.kpa_per = KPA_PER[name]
        self.offset_kpa = ambient_kpa if absolute else 0.0

    def to_kpa(self, value):
        return value * self.kpa_per - self.offset_kpa

    def from_kpa(self, kpa):
        return (kpa + self.offset_kpa) / self.kpa_per


class Counts:
    """Raw counts of a converter that is linear between two points: (counts, kPa) at both."""

    def __init__(self, low, high):
        (self.low_counts, self.low_kpa), (high_counts, high_kpa) = low, high
        if high_counts == self.low_counts or high_kpa == self.low_kpa:
            raise ValueError(f"two different points needed; {low} and {high} found")
        self.counts_per_kpa = (high_counts - self.low_counts) / (high_kpa - self.low_kpa)

    def to_kpa(self, counts):
        return self.low_kpa + (counts - self.low_counts) / self.counts_per_kpa

    def from_kpa(self, kpa):
        """The nearest whole count."""
        return round(self.low_counts + (kpa - self.low_kpa) * self.counts_per_kpa)


def sides_of(signed_kpa):
    """One signed pressure per segment, as (right, left) per segment, none negative, in one list: right 0, left 0, right 1, …"""
    return [side for p in signed_kpa for side in (max(p, 0.0), max(-p, 0.0))]


def signed_of(sides_kpa):
    """The way back. Of a side that is still emptying while the other fills, what counts is the difference."""
    if len(sides_kpa) % 2:
        raise ValueError(f"{len(sides_kpa)} channels found; expected two per segment")
    return [right - left for right, left in zip(sides_kpa[::2], sides_kpa[1::2])]
