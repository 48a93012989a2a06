"""The figures of Adams and Müftü (2005), section 3, and the page that compares them with what the paper says; and the
figures of where the model is valid.

`curves` has the surfaces behind each figure, `drawing` the pictures, `page` the comparison in numbers. `contacts` has
real contacts and `measured` measured friction, both drawn by `validity`; `calibrated` has the model calibrated at one
load against measurements at others, drawn by `front`.
Drawing needs matplotlib (extra `plot`).
"""
