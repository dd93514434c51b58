# SPDX-License-Identifier: LGPL-2.1-or-later
"""What random scenes have led to, in a JSON file that is written anew after every scene: a run of the driver that is ended
keeps what it found, and goes on where it stopped. One entry for each build, seed, generator and size of scenes;
scripts/stability_page.py shows them."""
import collections
import json
import os
import re

FASTER_THAN = (1, 5, 20, 60, 300)  # processor seconds of a scene: the classes in the record
SLOWEST = 5                        # scenes named


def numbers_of(text):
    """{0, 1, 2, 5} of "0-2, 5"."""
    found = set()
    for part in filter(None, text.split(", ")):
        first, _, last = part.partition("-")
        found.update(range(int(first), int(last or first) + 1))
    return found


def text_of(numbers):
    """"0-2, 5" of {0, 1, 2, 5}."""
    parts = []
    for number in sorted(numbers):
        if parts and parts[-1][1] == number - 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ", ".join(str(first) if first == last else f"{first}-{last}" for first, last in parts)


def kind_of(reason):
    """A reason without its numbers and names."""
    return re.sub(r"[-+]?\d[\d.e+-]*|'[^']*'", "*", reason)[:120]


def count(counts, key):
    counts[key] = counts.get(key, 0) + 1


def stopped_scenes(entry):
    """How many scenes stopped, by reason."""
    return collections.Counter({reason: len(numbers_of(numbers)) for reason, numbers in entry["stopped"].items()})


class Record:
    """The entry of one build, seed, generator and size in a file; without a file it is kept in memory only."""

    def __init__(self, file, key):
        """@param key build, seed, generator, work
        Errors: ValueError or KeyError if the file is not a record."""
        self.file = file
        self.entries = json.loads(file.read_text(encoding="utf-8")) if file and file.exists() else []
        same = [entry for entry in self.entries if all(entry[name] == value for name, value in key.items())]
        if not same:
            same = [{**key, "numbers": "", "completed": 0, "stopped": {}, "failed": [], "processor_s": 0., "classes": {},
                     "slowest": [], "kinds": {}, "commits": {}}]
            self.entries += same
        self.entry = same[0]
        self.numbers = numbers_of(self.entry["numbers"])

    def failed(self):
        """Numbers of the scenes that failed when they last ran."""
        return {failure["scene"] for failure in self.entry["failed"]}

    def add(self, number, outcome, kinds, commit):
        """Take in what a scene led to; one that failed before may come again, another one is not counted twice."""
        entry = self.entry
        if number in self.numbers and number not in self.failed():
            return
        entry["failed"] = [failure for failure in entry["failed"] if failure["scene"] != number]
        if outcome.failure:
            entry["failed"].append({"scene": number, "what": outcome.failure[0], "detail": outcome.failure[1]})
        elif outcome.status == 0:
            entry["completed"] += 1
        else:
            kind = kind_of(outcome.reason)
            entry["stopped"][kind] = text_of(numbers_of(entry["stopped"].get(kind, "")) | {number})
        entry["processor_s"] = round(entry["processor_s"] + outcome.processor, 2)
        if number not in self.numbers:
            bound = next((f"below {bound} s" for bound in FASTER_THAN if outcome.processor < bound), "more")
            count(entry["classes"], bound)
            for group, kind in kinds:
                count(entry["kinds"].setdefault(group, {}), kind)
            count(entry["commits"], commit)
            self.numbers.add(number)
            entry["numbers"] = text_of(self.numbers)
        slow = [*entry["slowest"], {"scene": number, "processor_s": round(outcome.processor, 1)}]
        entry["slowest"] = sorted(slow, key=lambda one: -one["processor_s"])[:SLOWEST]
        self.write()

    def write(self):
        """The whole file or nothing: a run may be ended at any moment."""
        if self.file is None:
            return
        draft = self.file.with_suffix(".part")
        draft.write_text(json.dumps(self.entries, indent=1, sort_keys=True) + "\n", encoding="utf-8")
        os.replace(draft, self.file)

    def lines(self):
        """Totals in words."""
        entry, stopped = self.entry, stopped_scenes(self.entry)
        failures = collections.Counter(failure["what"] for failure in entry["failed"])
        head = (f"{len(self.numbers)} scenes of seed {entry['seed']}: {sum(failures.values())} failed, "
                f"{sum(stopped.values())} stopped with a reason, {entry['processor_s']:.0f} s of a processor")
        return [head, *(f"  failed   {n:5d}  {what}" for what, n in failures.most_common()),
                *(f"  stopped  {n:5d}  {what}" for what, n in stopped.most_common())]
