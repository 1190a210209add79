"""The part in Python of benchmarks/python.cpp: measure.py WHAT CALLS THREADS SCENE [FILE].

Prints the median of the seconds of WHAT, that of what it is held against if this is Python too, and a count.
"""

import statistics
import sys
import time

import numpy

import hottel


def median_seconds(calls, threads, work):
    clock = time.process_time if threads == 1 else time.perf_counter
    seconds = []
    for _ in range(calls):
        begin = clock()
        work()
        seconds.append(clock() - begin)
    return statistics.median(seconds)


def main(what, calls, threads, path, file=None):
    calls, threads = int(calls), int(threads)
    scene = hottel.read_scene(path)
    simulation = hottel.Simulation(scene, per="face" if what in ("visible", "program") else None,
                                   threads=threads)
    other = 0.0
    if what == "program":  # timed from outside
        numpy.save(file, simulation.factors.factors[:-1])
        return
    if what in ("visible", "light"):
        points = numpy.loadtxt(file, delimiter=",")
        ask = getattr(simulation, what)
        ask(points[:1])  # what is made once
        seconds, count = median_seconds(calls, threads, lambda: ask(points)), len(points)
    elif what == "factors":
        seconds = median_seconds(calls, threads, lambda: hottel.Simulation(scene, threads=threads).factors.arrays())
        count = len(simulation.factors.arrays()[1])
    elif what == "to_scipy":
        factors = simulation.factors
        seconds = median_seconds(calls, threads, factors.to_scipy)
        other = median_seconds(calls, threads, lambda: factors.to_scipy(copy=True))
        count = factors.to_scipy().nnz
    print(seconds, other, count)


main(*sys.argv[1:])
