"""The customary prefixes of the vocabularies that models use."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from kinlint.resources import data

_DECLARATION = re.compile(r'sh:prefix "([^"]+)" ; sh:namespace "([^"]+)"')


@cache
def model_prefixes() -> Mapping[str, str]:
    """The prefixes that rules use, which are those of the metamodels."""
    text = (data("shapes") / "prefixes.ttl").read_text(encoding="utf-8")
    return dict(_DECLARATION.findall(text))
