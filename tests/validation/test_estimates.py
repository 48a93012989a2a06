"""Bands of estimates cover published measurements, and say more than simpler rules do."""

from __future__ import annotations

from estimates import CHOICES, RULES, left_out, scored, studies


def test_bands_cover_nine_in_ten_and_score_above_simpler_rules() -> None:
    score, covers, count = scored("this library")
    assert covers >= 0.9 and count == len(studies())
    assert all(score > scored(rule)[0] for rule in RULES if rule != "this library")
    # Where many asperities touch a constant is closer, and the page says so.
    assert scored("constant ± 5 %", "many")[0] > scored("this library", "many")[0] > 0
    assert scored("this library", "ball")[1] >= 0.85


def test_no_choice_of_the_priors_is_worse_without_the_study_that_is_scored() -> None:
    """A choice that were made for these studies would score less where each is left out; its band would cover fewer points."""
    score, *_ = scored("this library")
    for choice in CHOICES:
        without, covers, _ = left_out(choice)
        assert without > score - 0.05 and covers >= 0.9, (choice, without, covers)
