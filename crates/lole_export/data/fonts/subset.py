"""Makes NotoSansJP-Regular.otf and NotoSansJP-Bold.otf from the Noto Sans CJK collections.

    pip install fonttools
    python subset.py FOLDER_WITH_NotoSansCJK-Regular.ttc_AND_NotoSansCJK-Bold.ttc

Kept are all characters that a Japanese spreadsheet can save (code page 932: JIS X 0208 with the
extensions for names), Latin-1, the Hawaiian letters with kahakō and the ʻokina, and punctuation.
Hinting and vertical layout are left out, kerning is kept. The outlines are not changed.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTCollection


def characters():
    points = set()
    for lead in [*range(0x81, 0xA0), *range(0xE0, 0xFD)]:
        for trail in range(0x40, 0xFD):
            try:
                text = bytes([lead, trail]).decode("cp932")
            except UnicodeDecodeError:
                continue
            if len(text) == 1:
                points.add(ord(text))
    points |= set(range(0x20, 0x7F)) | set(range(0xA0, 0x180))
    points |= set(range(0x3000, 0x3100)) | set(range(0x2010, 0x2028))
    points |= set(map(ord, "‰′″€ʻʼ™←↑→↓−≈≠≤≥✓□〜￥"))
    return points


def main(folder):
    for weight in ["Regular", "Bold"]:
        source = str(folder / f"NotoSansCJK-{weight}.ttc")
        names = [font["name"].getDebugName(4) for font in TTCollection(source).fonts]
        number = next(i for i, name in enumerate(names) if "Sans CJK JP" in name)
        options = subset.Options()
        options.font_number = number
        options.layout_features = ["kern", "ccmp", "locl", "mark"]
        options.hinting = False
        options.notdef_outline = True
        options.recalc_timestamp = False
        options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 7, 13, 14]
        options.drop_tables += ["vhea", "vmtx", "VORG", "BASE", "DSIG"]
        font = subset.load_font(source, options)
        subsetter = subset.Subsetter(options)
        subsetter.populate(unicodes=characters())
        subsetter.subset(font)
        font.save(f"NotoSansJP-{weight}.otf")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
