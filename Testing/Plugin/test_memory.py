"""Animations, and volumes that are hidden and shown, don't make a process grow: test_memory.py"""

from paraview import simple

import flatblock
import session


def resident():
    """MiB of this process."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096 / 1048576.0


def measure(action, count, warm_up):
    """MiB by which the process grows from the end of the warm-up on."""
    for i in range(warm_up):
        action(i)
    before = resident()
    for i in range(warm_up, count):
        action(i)
    return resident() - before


def main():
    session.load_plugin()
    view = session.make_view(128)
    wavelet = session.make_wavelet(25)  # 0.5 MiB
    display = session.show(wavelet, view)
    session.look(view)
    simple.Render(view)
    mapper = session.get_mapper(display)
    used = mapper.GetMemoryInBytes()

    scene = simple.GetAnimationScene()
    scene.NumberOfFrames = 50
    track = simple.GetAnimationTrack("Maximum", proxy=wavelet)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[250.0 + 50.0 * time])
        for time in (0.0, 1.0)]
    scene.GoToFirst()
    animated = measure(lambda i: scene.GoToNext(), 49, 10)
    assert session.get_mapper(display).GetMemoryInBytes() <= 1.1 * used

    def toggle(_):
        display.Visibility = 0
        simple.Render(view)
        display.Visibility = 1
        simple.Render(view)

    hidden = measure(toggle, 100, 10)
    print("animation: %.1f MiB, hidden and shown: %.1f MiB" % (animated, hidden))
    assert animated < 8.0 and hidden < 8.0
    assert mapper.GetMemoryInBytes() <= 1.1 * used


if __name__ == "__main__":
    main()
    session.end()
