"""Parses an XML file with an independent parser and says what it holds.

Prints one line a tag, "tag count", sorted, and then one line "text: ..." for each text in it.
Exits with 1 and the parser's message where the file is not well-formed.
"""

import collections
import sys
import xml.etree.ElementTree


def main(path):
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except xml.etree.ElementTree.ParseError as error:
        print(f"{path}: {error}")
        return 1
    elements = list(root.iter())
    tags = collections.Counter(element.tag.split("}")[-1] for element in elements)
    for tag, count in sorted(tags.items()):
        print(tag, count)
    for element in elements:
        if element.text and element.text.strip():
            print("text:", " ".join(element.text.split()))
    return 0


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.exit(main(sys.argv[1]))
