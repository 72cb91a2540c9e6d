#!/usr/bin/env python3
"""Makes the page's face of Japanese letters out of the one that pages are printed with.

    pip install fonttools
    python tools/letters.py

Kept are kana, punctuation, the kanji of JIS level 1 (rows 16 to 47 of JIS X 0208), every letter
of the program's own sentences, and the letters of Hawaiian. The license stands beside
the face of printed pages.
"""

import pathlib

from fontTools import subset, ttLib


def wanted(repository: pathlib.Path) -> set[int]:
    letters = set(range(0x3000, 0x3100)) | set(range(0xFF01, 0xFFA0)) | set(range(0x20, 0x7F))
    letters |= set(map(ord, "ʻāēīōūĀĒĪŌŪ…–—‘’“”×÷±°→←↑↓①②③④⑤⑥⑦⑧⑨⑩■□▲△▼▽◆◇○●◎★☆※〒"))
    for row in range(16, 48):
        for cell in range(1, 95):
            try:
                letters.add(ord(bytes([row + 0xA0, cell + 0xA0]).decode("euc_jp")))
            except UnicodeDecodeError:
                pass  # Row 47 is not full.
    for source in repository.glob("crates/**/*.rs"):
        letters |= set(map(ord, source.read_text(encoding="utf-8")))
    return letters


def main() -> None:
    repository = pathlib.Path(__file__).resolve().parent.parent
    target = repository / "crates/lole_web/site/letters.otf"
    face = ttLib.TTFont(repository / "crates/lole_export/data/fonts/NotoSansJP-Regular.otf")
    options = subset.Options()
    options.layout_features = []
    options.hinting = False
    options.desubroutinize = False
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    options.notdef_outline = True
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=wanted(repository))
    subsetter.subset(face)
    face.save(target)
    print(f"{target}: {len(face.getBestCmap())} letters, {target.stat().st_size} bytes")


main()
