"""The comments of the header, in the words of other languages."""

import re
import textwrap

WIDTH = 120


def sentences(text):
    """Cut after full stops that end a sentence: what follows begins one, "i.e. summits" and "a + ... + b" do not."""
    return re.split(r"(?<=[^.]\.) (?=[A-Z0-9`])", text)


def first_sentence(text):
    return sentences(text)[0]


def in_words(text, header, quote='"', true="True", false="False"):
    """A comment for a language that has words in place of constants, and other names for the functions of C."""
    functions = {one.name for one in header.functions}
    kept = [without_calls(one, functions) for one in sentences(text)]
    text = " ".join(one for one in kept if one)
    for name, words in header.words.items():
        group = next(iter(words.values())).name.removesuffix(next(iter(words)))
        listed = ", ".join(f"{quote}{word(one)}{quote}" for one in words)
        text = text.replace(f"`{group}`", listed)
        for one, constant in words.items():
            text = text.replace(f"`{constant.name}`", f"{quote}{word(one)}{quote}").replace(constant.name, f"{quote}{word(one)}{quote}")
    return flagged(text, true, false).replace("NULL by default", "Empty by default").replace("INFINITY", "infinity")


def flagged(text, true, false):
    """What 1 and what 0 mean, for a language that has other words for them."""
    return re.sub(r"\b1: (.*?); 0: ", rf"{true}: \1; {false}: ", text)


def without_calls(sentence, functions):
    """A sentence without the clause that names a function of C, as "call `asperity_...`" does; none where that is all."""
    called = [found.start() for found in re.finditer(r"`(asperity_\w+)", sentence) if found[1] in functions]
    if not called:
        return sentence
    before = re.match(r"(.*)[,;:] ", sentence[: called[0]])
    return before[1] + "." if before else ""


def word(constant):
    """ELASTIC_PLASTIC as "elastic-plastic"."""
    return constant.lower().replace("_", "-")


def wrapped(text, first, then=None, width=WIDTH):
    """Lines of at most so many characters, which begin as they are told to."""
    then = first if then is None else then
    return textwrap.wrap(text, width, initial_indent=first, subsequent_indent=then, break_long_words=False, break_on_hyphens=False)
